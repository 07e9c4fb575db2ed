"""Vectors of the end of a line that grows (the rod of a cylinder): along it as given, and of its rotation."""

from __future__ import annotations

from variantgen.figure.motion_board import MotionBoard
from variantgen.figure.solved import Solved
from variantgen.mechanism.drivers.extension import Extension
from variantgen.methods.graphical.vector_chain import Cylinder
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import component_marks, compound

Named = list[tuple[Symbol, complex]]


def growing_velocities(board: MotionBoard, found: Solved, language: Language) -> dict[str, Named]:
    """The relative velocity, by the letter of the statement, and the transport velocity (m/s) of each rod's end."""
    parts: dict[str, Named] = {}
    for reach in found.chain.reaches:
        along, across = found.now.growth(reach.point, reach.base)
        names = _relative(board, reach, "v", language), compound("v", "tr", reach.point, language)
        parts[reach.point] = list(zip(names, (along, across), strict=True))
    return parts


def growing_accelerations(board: MotionBoard, found: Solved, language: Language) -> dict[str, Named]:
    """Relative, transport (normal and tangential) and Coriolis acceleration (m/s^2) of each rod's end."""
    normal, tangential = component_marks(language)
    parts: dict[str, Named] = {}
    for reach in found.chain.reaches:
        names = (
            _relative(board, reach, "a", language),
            compound("a", "tr", reach.point, language, normal),
            compound("a", "cor", reach.point, language),
            compound("a", "tr", reach.point, language, tangential),
        )
        parts[reach.point] = list(zip(names, found.now.growing_acceleration(reach.point, reach.base), strict=True))
    return parts


def _relative(board: MotionBoard, reach: Cylinder, kind: str, language: Language) -> Symbol:
    """The relative vector under the letter by which its magnitude is given."""
    drivers = (driver for driver in board.scene.drivers if isinstance(driver, Extension))
    driver = next(driver for driver in drivers if (driver.end, driver.start) == (reach.point, reach.base))
    return board.given_symbol(driver, kind) or compound(kind, "rel", reach.point, language)
