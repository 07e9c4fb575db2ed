"""Vectors of the end of a line that grows (the rod of a cylinder): along it as given, and of its rotation."""

from __future__ import annotations

from variantgen.figure.motion_board import MotionBoard
from variantgen.figure.motion_data import MotionData
from variantgen.mechanism.drivers.extension import Extension
from variantgen.methods.graphical.vector_chain import Cylinder
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import component_marks, compound_part

Named = list[tuple[Symbol, complex]]


def cylinder_velocities(board: MotionBoard, found: MotionData, language: Language) -> dict[str, Named]:
    """The relative velocity, by the letter of the statement, and the transport velocity (m/s) of each rod's end."""
    parts: dict[str, Named] = {}
    for cylinder in found.chain.cylinders:
        along, across = found.now.growth(cylinder.point, cylinder.base)
        names = _relative(board, cylinder, "v", language), compound_part("v", "tr", cylinder.point, language)
        parts[cylinder.point] = list(zip(names, (along, across), strict=True))
    return parts


def cylinder_accelerations(board: MotionBoard, found: MotionData, language: Language) -> dict[str, Named]:
    """Relative, transport (normal and tangential) and Coriolis acceleration (m/s^2) of each rod's end."""
    normal, tangential = component_marks(language)
    parts: dict[str, Named] = {}
    for cylinder in found.chain.cylinders:
        names = (
            _relative(board, cylinder, "a", language),
            compound_part("a", "tr", cylinder.point, language, normal),
            compound_part("a", "cor", cylinder.point, language),
            compound_part("a", "tr", cylinder.point, language, tangential),
        )
        parts[cylinder.point] = list(
            zip(names, found.now.growing_acceleration(cylinder.point, cylinder.base), strict=True)
        )
    return parts


def _relative(board: MotionBoard, cylinder: Cylinder, kind: str, language: Language) -> Symbol:
    """The relative vector under the letter by which its magnitude is given."""
    drivers = (driver for driver in board.scene.drivers if isinstance(driver, Extension))
    driver = next(driver for driver in drivers if (driver.end, driver.start) == (cylinder.point, cylinder.base))
    return board.given_symbol(driver, kind) or compound_part(kind, "rel", cylinder.point, language)
