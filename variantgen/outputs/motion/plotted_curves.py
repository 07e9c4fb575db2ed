"""What is plotted of a driver sweep: panels of curves in printed units, grouped by what they measure."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from msgspec import Struct

from variantgen.families.parameters.units import Unit, unit
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.scene import fixed_points
from variantgen.mechanism.turn.sweep import Sweep
from variantgen.single import answers
from variantgen.variants.driver_sweep import DriverSweep
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Formula, Index, Symbol
from variantgen.wording.language import Language

# Variation, of the like rates of the whole mechanism, below which a quantity is constant.
_CONSTANT = 1e-9
_MEASURES = ("velocity", "angular velocity", "acceleration", "angular acceleration", "length", "angle", "number")


class PlottedCurve(Struct, frozen=True):
    """A quantity over the sweep, shape (K,), in its printed unit; ``now`` at the instant of the problem.

    Where the quantity has no finite value there is NaN; one that has none at the instant is left out.
    """

    formula: Formula
    unit: Unit
    values: Field
    now: float
    constant: bool


class Panel(Struct, frozen=True):
    """Curves of one unit; ``letters`` are what the axis is called: (x, y), or () where the unit says enough."""

    unit: Unit
    curves: tuple[PlottedCurve, ...]
    letters: tuple[str, ...] = ()


def panels(
    variant: Variant, driver_sweep: DriverSweep, asked: Sequence[Quantity], language: Language
) -> tuple[list[Panel], list[PlottedCurve]]:
    """Panels of what varies (positions of the asked points first), and the curves that are constant."""
    length = variant.family.length_unit
    positions = _positions(variant, driver_sweep, asked, language)
    found = [Panel(unit(length), tuple(positions), _letters(positions))] if positions else []
    printed = {answer.quantity: answer.value for answer in answers(variant, [quantity.written for quantity in asked])}
    plain = [
        quantity
        for quantity in asked
        if quantity.component != "sense" and quantity.is_of_instant and math.isfinite(printed[quantity])
    ]
    curves = [_curve(variant, driver_sweep.sweep, quantity, printed[quantity], language) for quantity in plain]
    for measure in _MEASURES:
        alike = [curve for curve in curves if curve.unit.measures == measure and not curve.constant]
        for measured in dict.fromkeys(curve.unit for curve in alike):
            found.append(Panel(measured, tuple(curve for curve in alike if curve.unit == measured)))
    return found, [curve for curve in curves if curve.constant]


def origin(variant: Variant, motion: Motion, asked: Sequence[Quantity], instant: int) -> tuple[str, complex]:
    """The point from which coordinates are counted, and its place (m): a shown point at rest, or any at the instant."""
    shown = shown_points(variant, asked)
    held = fixed_points(motion.scene) | {name for joint in motion.scene.joints for name in joint.landmarks()}
    name = next((name for name in shown if name in held), shown[0])
    return name, complex(motion.z[name][instant])


def _letters(curves: Sequence[PlottedCurve]) -> tuple[str, ...]:
    """The letters of the coordinates, each once, in their order."""
    bases = [curve.formula.base for curve in curves if isinstance(curve.formula, Symbol)]
    return tuple(sorted(set(bases)))


def _positions(
    variant: Variant, driver_sweep: DriverSweep, asked: Sequence[Quantity], language: Language
) -> list[PlottedCurve]:
    """Coordinates of the asked points that change."""
    motion, at = driver_sweep.sweep.motion, driver_sweep.sweep.instant
    _, zero = origin(variant, motion, asked, at)
    measured = unit(variant.family.length_unit)
    size = float(motion.length_scale()[at])
    names = dict.fromkeys(quantity.point for quantity in asked if quantity.point and not quantity.is_centre)
    found = []
    for name in names:
        place = motion.z[name] - zero
        index = (Index(variant.form.symbols.get(name, name)),)
        for letter, values in (("x", place.real), ("y", place.imag)):
            if np.ptp(values) > _CONSTANT * size:
                shown = np.array([measured.from_si(value) for value in values])
                found.append(PlottedCurve(Symbol(letter, index), measured, shown, float(shown[at]), False))
    return found


def _curve(variant: Variant, sweep: Sweep, quantity: Quantity, now: float, language: Language) -> PlottedCurve:
    """An asked quantity along the way, ``now`` as it is printed; over a dead position that is passed it goes on."""
    measured = quantity.unit(variant.family.length_unit)
    values = np.array(quantity.value(sweep.motion), dtype=np.float64)
    if quantity.is_direction:
        values = np.unwrap(values)
        values -= (
            2
            * np.pi
            * np.round((values[sweep.instant] - float(quantity.value(sweep.motion)[sweep.instant])) / (2 * np.pi))
        )
    blind = ~sweep.clear
    if blind.any() and not blind.all():
        values[blind] = np.interp(sweep.way[blind], sweep.way[~blind], values[~blind])
    values[~np.isfinite(values)] = np.nan
    # Noise of a quantity that does not change is not shown as a curve.
    constant = bool(np.nanmax(values) - np.nanmin(values) <= _CONSTANT * _scale(sweep, quantity))
    shown = np.array([measured.from_si(float(value)) for value in values])
    name = language.quantity(quantity, variant.form.symbols)
    return PlottedCurve(name, measured, shown, now, constant)


def _scale(sweep: Sweep, quantity: Quantity) -> float:
    """The largest rate of the kind in the mechanism at the instant (SI)."""
    motion, at = sweep.motion, sweep.instant
    if quantity.is_angle:
        return 1.0
    if quantity.is_length:
        return float(motion.length_scale()[at])
    if quantity.group == "ratio":
        return 1.0
    table = motion.v if quantity.order == 1 else motion.a
    if quantity.is_rotation:
        rates = motion.omega if quantity.order == 1 else motion.epsilon
        size = float(motion.length_scale()[at])
        return max(*(abs(float(x[at])) for x in rates.values()), *(abs(complex(x[at])) / size for x in table.values()))
    return max(abs(complex(x[at])) for x in table.values())
