"""What a solution starts from: one variant with its data as values, and its solved motion in printed units."""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping, Sequence
from fractions import Fraction
from functools import cache, cached_property
from itertools import combinations
from types import MappingProxyType
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Expression, Pi, Value
from variantgen.algebra.name import Name
from variantgen.families.family import Form
from variantgen.families.literal_data import literal_data, literal_radii
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.solved_law import SolvedLaw
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity, motion_order
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import Scene
from variantgen.methods.linkage.instant import Instant, instant
from variantgen.methods.linkage.needed import Needed, needed_for
from variantgen.methods.linkage.translated import Translator
from variantgen.variants.variant import Variant, solve_variants

AGREES = 1e-9  # of the natural scale: what rounding of the arithmetic leaves between a solution and the solver
_DIGITS = 12  # of a number of the file in the printed unit
CLOSE = 1e-9  # relative difference within which two numbers are one, but for rounding


class Task(Struct, frozen=True, dict=True):
    """One variant to be solved for the asked quantities; ``now`` is its motion in printed units (cm, cm/s, rad/s).

    What is asked may be made of plain quantities, such as a ratio of angular velocities: methods look for these.
    """

    variant: Variant
    asked: tuple[Quantity, ...]
    now: Instant

    @cached_property
    def form(self) -> Form:
        """The form of the variant's family."""
        return self.variant.form

    @cached_property
    def scene(self) -> Scene:
        """The scene of the variant (numbers in SI)."""
        return self.now.scene

    @cached_property
    def order(self) -> int:
        """1 if velocities are enough, 2 if accelerations are asked."""
        return motion_order(self.asked)

    @cached_property
    def remembered(self) -> dict[Hashable, Any]:
        """What steps have worked out from this task alone, by keys of their own."""
        return {}

    @cached_property
    def motion(self) -> Motion:
        """The motion of the variant as a batch of one."""
        return solve_variants([self.variant], self.order)

    @cached_property
    def sought(self) -> tuple[Quantity, ...]:
        """The plain quantities that the asked ones are, or are made of; none where positions alone are asked."""
        return tuple(dict.fromkeys(source for quantity in self.asked for source in quantity.sources(self.scene)))

    @property
    def at(self) -> Placement:
        """Positions in printed units, with the frame."""
        return Placement(self.now.z, self.scene.frame)

    @cached_property
    def linkage(self) -> Linkage:
        """The mechanism as a reader of the figure sees it, which for all variants of a form is the same."""
        return self.form.linkage

    @property
    def in_metres(self) -> Placement:
        """Positions in SI, as the numbers of the scene are."""
        return Placement({point: z * self.length_unit for point, z in self.now.z.items()}, self.scene.frame)

    @cached_property
    def fixed(self) -> frozenset[str]:
        """Points at rest."""
        return self.linkage.resting

    @cached_property
    def needed(self) -> Needed:
        """Points and bodies that lead to what is asked."""
        return needed_for(self.form, self.sought)

    @cached_property
    def accelerated(self) -> Needed:
        """Points and bodies that lead to the accelerations that are asked."""
        return needed_for(self.form, tuple(quantity for quantity in self.sought if quantity.order == 2))

    @cached_property
    def by_names(self) -> dict[Hashable, Any]:
        """What steps have worked out from names and what is asked alone, by keys of their own; the form keeps it."""
        found: dict[Hashable, Any] = self.form.remembered.setdefault(("by names", self.sought), {})
        return found

    @cached_property
    def translating(self) -> frozenset[str]:
        """Bodies that do not turn: a joint keeps them from it, or they are led by two equal parallel cranks."""
        linkage = self.linkage
        return linkage.translating | {body for body, ends in linkage.cranks.items() if self._are_parallel(ends)}

    def _are_parallel(self, cranks: Sequence[tuple[str, str]]) -> bool:
        """Whether two of some cranks, by their ends, are equal as vectors."""
        ways = [self.now.z[point] - self.now.z[pivot] for point, pivot in cranks]
        return any(abs(first - second) < CLOSE * self.size for first, second in combinations(ways, 2))

    @cached_property
    def size(self) -> float:
        """Size of the mechanism, in the printed unit of length; of a single point its way to the origin, or 1."""
        places = list(self.now.z.values())
        return max([abs(p - q) for p, q in combinations(places, 2)], default=0.0) or abs(places[0]) or 1.0

    @cached_property
    def largest_speed(self) -> float:
        """The largest velocity of the mechanism, in printed units; of wheels on fixed axles alone that of rims."""
        points = max((abs(v) for v in self.now.v.values()), default=0.0)
        return points or self.size * max((abs(rate) for rate in self.now.omega.values()), default=0.0)

    @cached_property
    def largest_acceleration(self) -> float:
        """The natural scale of accelerations, in printed units: the largest one, or what its speeds tell of them."""
        steady = self.largest_speed**2 / self.size if self.size else 0.0  # without acceleration only rounding
        found = max([steady, *(abs(a) for a in self.now.a.values())])
        return found or self.size * max((abs(rate) for rate in self.now.epsilon.values()), default=0.0)

    @cached_property
    def scales(self) -> Mapping[str, float]:
        """The natural scale of each measure in printed units, below which numbers are rounding; none of angles."""
        speed, acceleration, size = self.largest_speed, self.largest_acceleration, self.size
        scales = {"length": size, "velocity": speed, "acceleration": acceleration}
        return scales | {"angular velocity": speed / size, "angular acceleration": acceleration / size}

    @cached_property
    def si(self) -> Mapping[str, float]:
        """Parameters and derived quantities in SI."""
        values = self.form.values({name: self.variant.si(name) for name in self.form.parameters})
        return {name: float(value) for name, value in values.items()}

    @property
    def length_unit(self) -> float:
        """The printed unit of length in metres."""
        return float(unit(self.variant.family.length_unit).factor)

    @cached_property
    def given(self) -> dict[str, Value]:
        """The printed data as values: magnitudes of rates, since the figure shows their senses."""
        return {name: self._given(name) for name, p in self.form.parameters.items() if p.unit is not None}

    def _given(self, name: str) -> Value:
        parameter = self.form.parameters[name]
        assert parameter.unit is not None
        printed = float(self.variant.printed[name])
        shown = abs(printed) if parameter.is_rate else printed
        measure = parameter.unit.measures
        usual = self.unit_of(measure)
        if parameter.found:  # a result like all others, with as many digits
            return Value(Name("parameter", parameter.symbol), measure, shown, Constant(shown))
        value = Value(Name("parameter", parameter.symbol), measure, shown)
        if parameter.unit.name == usual:
            return value
        value.unit = parameter.unit.name
        converted = unit(usual).from_si(parameter.unit.to_si(self.variant.printed[name]))
        factor = unit(usual).from_si(unit(parameter.unit.name).to_si(type(self.variant.printed[name])(1)))
        # A rate of turning in other units is so many half turns: 100 rpm are 100 pi / 30, 2 rev/s are 2 * 2 pi.
        turns = Fraction(parameter.unit.turn / math.pi).limit_denominator(180)
        if measure.startswith("angular"):
            many = Pi() if turns.numerator == 1 else Constant(float(turns.numerator)) * Pi()
            shift = many * value if turns.denominator == 1 else many * value / Constant(float(turns.denominator))
        else:
            shift = value * Constant(round(factor, 12))
        return Value(value.name, measure, abs(converted) if parameter.is_rate else converted, shift)

    @cached_property
    def stated_rates(self) -> dict[str, Value]:
        """The rates that a scene states as numbers, by the letters that its sheet gives them; magnitudes, no zeros."""
        if not self.is_own_scene:
            return {}
        found = {}
        for datum in literal_data(self.form):
            if datum.kind == "rate" and datum.source is None and datum.si:
                printed = unit(self.unit_of(datum.measures)).from_si(abs(datum.si))
                # 12 in/s are not 12.000000000000002 by their metres.
                size = float(f"{printed:.{_DIGITS}g}")
                found[datum.name] = Value(Name("parameter", datum.name), datum.measures, size)
        return found

    @property
    def is_own_scene(self) -> bool:
        """Whether the mechanism is that of a file by itself, whose sheet the program makes."""
        return self.variant.family.is_scene

    @property
    def writes_laws(self) -> bool:
        """Whether the sheet writes laws of motion as equations; the statement of a family tells them in own words."""
        return self.is_own_scene

    @property
    def stated_radii(self) -> dict[str, list[float]]:
        """The radii of each body that its file states as numbers; of a scene also those of its wheels, as its sheet."""
        if self.is_own_scene:
            return self._in_printed_unit(literal_radii(self.form, self.in_metres.z))
        known = self.form.remembered
        if "stated radii" not in known:
            known["stated radii"] = self._in_printed_unit(literal_radii(self.form))
        found: dict[str, list[float]] = known["stated radii"]
        return found

    def _in_printed_unit(self, radii: Mapping[str, Sequence[float]]) -> dict[str, list[float]]:
        return {body: [radius / self.length_unit for radius in own] for body, own in radii.items()}

    def unit_of(self, measure: str) -> str:
        """The name of the unit in which a measure is printed in this solution."""
        return _units(self.variant.family.length_unit)[measure]

    def read(self, expression: FamilyExpression) -> float:
        """The value of an expression of the family in SI."""
        return float(expression.value(self.si))

    def expressed(
        self, expression: FamilyExpression, degrees: bool = False, known: Mapping[str, Value] = MappingProxyType({})
    ) -> Expression | None:
        """An expression of the family as one of the solution, if every part of it can be shown; choices are signs.

        An angle is a plain number, or in ``degrees``; ``known`` quantities are not written out.
        """
        if not known:
            key = ("expressed", expression, degrees)
            remembered = self.remembered if expression.names else self.form.remembered  # a number is that of the form
            if key not in remembered:
                remembered[key] = self._translator.translate(expression, degrees)
            found: Expression | None = remembered[key]
            return found
        return replace(self._translator, named=lambda name: known.get(name) or self._named(name)).translate(expression)

    def drawn_radius(self, body: str | None, centre: str, exact: float) -> Expression | None:
        """The radius of that length (printed unit) of a disc of the body (None: of the ground) about a point.

        Of another body's disc about the same point it is not, though as large by chance. None where none is drawn.
        """
        for disc in self.form.figure.discs_of(body, centre):
            near = abs(self.read(disc.radius) / self.length_unit - exact) <= CLOSE * exact
            if near and (found := self.expressed(disc.radius)) is not None:
                return found
        return None

    def _solved(self, derived: SolvedLaw) -> Value:
        """The place or the velocity of a law that has been integrated numerically."""
        name = derived.law.own
        measure = self.form.laws[name].rate_measure(derived.part)
        number = float(unit(self.unit_of(measure)).from_si(self.read(derived)))
        return Value(Name("parameter", name, dots=derived.part), measure, number, Constant(number))

    @cached_property
    def _translator(self) -> Translator:
        return Translator(self._named, self.form.derived.get, self.unit_of)

    def _named(self, name: str) -> Expression | None:
        """A parameter as its value, a choice as its number, what is integrated numerically as its value too."""
        parameter = self.form.parameters.get(name)
        if parameter is None:
            derived = self.form.derived.get(name)
            return self._solved(derived) if isinstance(derived, SolvedLaw) else None
        return Constant(float(self.variant.printed[name])) if parameter.unit is None else self.given[name]


@cache
def _units(length: str) -> dict[str, str]:
    """The units of all measures by that of lengths."""
    units = {"length": length, "velocity": f"{length}/s", "acceleration": f"{length}/s^2", "angle": "deg"}
    return units | {"angular velocity": "rad/s", "angular acceleration": "rad/s^2", "time": "s", "number": "1"}


def task_of(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity]) -> Task:
    """The task of one variant of a solved batch."""
    length_unit = float(unit(variant.family.length_unit).factor)
    return Task(variant, tuple(asked), instant(motion, index, length_unit))
