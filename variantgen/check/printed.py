"""Whether the mechanism that is solved is the one on the sheet: its lengths, radii and marks."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import numpy as np

from variantgen.check.statement_reading import StatementReading, two_points
from variantgen.families.hints import DIRECTIONS
from variantgen.families.parameters.units import Unit, unit
from variantgen.families.quantities import Quantity, quantity_names, split_name
from variantgen.mechanism.motion import Motion, take_scene
from variantgen.mechanism.rows import Placement
from variantgen.variants.variant import Variant

_EQUAL = 1e-6  # relative: what rounding changes

# A mistake: what it is (copies of it in other variants have the same), and the message.
Fault = tuple[str, str]


def print_mismatches(
    variant: Variant, motion: Motion, place: int, sheets: Sequence[StatementReading]
) -> Iterator[Fault]:
    """What is printed of a variant and is not so in its solved position (that of ``motion`` at ``place``)."""
    yield from _false_marks(variant, motion, place)
    yield from _false_lengths(variant, motion, place, sheets)
    yield from _false_circles(variant, motion, place)
    yield from _false_rates(variant, motion, place)


def _false_lengths(variant: Variant, motion: Motion, place: int, sheets: Sequence[StatementReading]) -> Iterator[Fault]:
    """Lengths named by two points are the distances of these points."""
    length = unit(variant.family.length_unit)
    for name, datum in ((name, datum) for sheet in sheets for name, data in sheet.data.items() for datum in data):
        ends = two_points(name, variant.form)
        if ends is None or datum.measures != "length":
            continue
        size = float(abs(motion.z[ends[1]][place] - motion.z[ends[0]][place]))
        if not _near(size, datum.value):
            message = f"the sheet says {name} = {datum.written}, but these points are {_in(size, length)} apart"
            remedy = "give this distance in [points] as it is printed, or the parameter another name"
            yield f"length {name}", f"{message}; {remedy}"


def _false_circles(variant: Variant, motion: Motion, place: int) -> Iterator[Fault]:
    """The circles of wheels, gears and pulleys that joints speak of are those of the figure."""
    form, length = variant.form, unit(variant.family.length_unit)
    values = form.values({name: variant.si(name) for name in form.parameters})
    scene = take_scene(motion.scene, place, motion.size)
    at = Placement({name: complex(motion.z[name][place]) for name in motion.z}, scene.frame)
    for joint in scene.joints:
        for circle in joint.circles(at):
            radius = float(np.asarray(circle.radius))
            marks = [
                (disc.name, float(disc.radius.value(values)))
                for disc in form.figure.discs
                if disc.centre == circle.centre and (not disc.body or not circle.body or disc.body == circle.body)
            ]
            if radius > 0 and marks and not any(_near(radius, drawn) for _, drawn in marks):
                shown = " or ".join(f"{name} = {_in(size, length)}".removeprefix(" = ") for name, size in marks)
                yield (
                    f"circle {circle.centre} {circle.body}",
                    f"a joint takes the circle of {circle.body or 'a wheel'} about {circle.centre} to have the radius"
                    f" {_in(radius, length)}, the sheet shows {shown}; write the same radius in joints and figure",
                )


def _false_rates(variant: Variant, motion: Motion, place: int) -> Iterator[Fault]:
    """Rates that are written as a quantity of the scene (v_B, omega_OA) are those of the motion."""
    form = variant.form
    for name, parameter in form.parameters.items():
        if not parameter.is_rate or parameter.unit is None or parameter.symbol not in quantity_names(form.sample):
            continue
        quantity = split_name(parameter.symbol)
        if quantity.component:
            continue
        rate, given = abs(float(quantity.value(motion)[place])), abs(variant.si(name))
        if abs(rate - given) > _EQUAL * max(given, _largest(quantity, motion, place)):
            measured = parameter.unit
            message = f"the sheet says {name} = {variant.printed[name]} {measured.name}, but {parameter.symbol} is"
            yield f"rate {name}", f"{message} {measured.from_si(rate):.6g} {measured.name}; write it so in the driver"


def _largest(quantity: Quantity, motion: Motion, place: int) -> float:
    """The largest velocity, acceleration or rate of turning of the scene: small ones are as exact as it."""
    tables = (motion.v, motion.a) if quantity.is_vector else (motion.omega, motion.epsilon)
    return max((float(abs(values[place])) for values in tables[quantity.order - 1].values()), default=0.0)


def _false_marks(variant: Variant, motion: Motion, place: int) -> Iterator[Fault]:
    """Marks of the figure have the size of their parameter."""
    values = variant.form.values({name: variant.si(name) for name in variant.form.parameters})
    hints, z = variant.form.figure, {name: complex(motion.z[name][place]) for name in motion.z}
    frame = take_scene(motion.scene, place, motion.size).frame

    def ray(corner: str, name: str) -> complex:
        return complex(frame.place(DIRECTIONS[name])) if name in DIRECTIONS else z[name] - z[corner]

    found = [
        (mark.name, abs(cmath.phase(ray(mark.at, mark.end) / ray(mark.at, mark.start))), "angle")
        for mark in hints.angles
    ]
    found += [(mark.name, abs(z[mark.end] - z[mark.start]), "length") for mark in hints.lengths]
    found += [(disc.name, float(disc.radius.value(values)), "radius") for disc in hints.discs if disc.name]
    faults = [
        f"the angle marked as right at {mark.at} is not right"
        for mark in hints.right_angles
        if abs(math.cos(cmath.phase(ray(mark.at, mark.end) / ray(mark.at, mark.start)))) > _EQUAL
    ]
    faults += [
        f"the {kind} marked {name} is not the given one"
        for name, size, kind in found
        if not (_same_angle if kind == "angle" else _near)(size, float(values[name]))
    ]
    yield from ((fault, fault) for fault in faults)


def _same_angle(size: float, value: float) -> bool:
    return abs(math.cos(size) - math.cos(value)) < _EQUAL


def _near(size: float, value: float) -> bool:
    return abs(size - abs(value)) <= _EQUAL * (size + abs(value))


def _in(size: float, length: Unit) -> str:
    return f"{length.from_si(size):.6g} {length.name}"
