"""The data of a scene that has no statement of its own: what its file says in numbers, as given equations."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal

import numpy as np

from variantgen.families.literal_data import LiteralDatum, literal_data, literal_radii, on_lines_through
from variantgen.families.parameters.units import Unit, short_unit, unit
from variantgen.families.quantities import Quantity, motion_order
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Equation, Formula, Index, Measured, Symbol, SymbolProperty
from variantgen.wording.formula.tree import ANGLE
from variantgen.wording.language import Language
from variantgen.wording.text import Text

_DIGITS = 6  # of a number of the file, which may stand there in another unit
_NOTHING = 1e-12  # of a coordinate: rounding
_ON_LINE = 1e-9  # sine of an angle: less is rounding
_PER_TIME = {"velocity": "/s", "acceleration": "/s^2"}


def scene_data(
    variant: Variant, asked: Sequence[Quantity], language: Language
) -> tuple[list[Equation], list[Equation]]:
    """Lengths, radii, angles and places; then the magnitudes of rates, whose sense the figure shows.

    Places and directions are those on paper. What lies at points that the figure does not show is left out, and rates
    that only accelerations depend on where none is asked.
    """
    case = _SceneData(variant, asked, language)
    found = list({(datum.kind, datum.name, datum.si): datum for datum in literal_data(variant.form, case.at)}.values())
    seen = [datum for datum in found if set(datum.points) <= case.shown and datum.unless not in case.shown]
    kinds = ("length", "radius", "angle", "corner", "place", "x", "y")
    position = [e for kind in kinds for datum in seen if datum.kind == kind for e in case.equations(datum)]
    slow = motion_order(asked) == 1
    rates = [datum for datum in found if datum.kind in ("rate", "direction") and not (datum.second and slow)]
    return position, [e for datum in rates for e in case.equations(datum)]


def guide_inclinations(variant: Variant, asked: Sequence[Quantity], language: Language) -> list[tuple[str, Formula]]:
    """The points of inclined guides of a scene, each with the acute angle of the guide with the horizontal."""
    return [(point, angle) for point, angle, _ in _guides(variant, asked, language)]


def _guides(variant: Variant, asked: Sequence[Quantity], language: Language) -> list[tuple[str, Formula, str]]:
    """Each inclined guide of a scene: its point, the acute angle with the horizontal, a point that its line passes."""
    guides = [datum for datum in literal_data(variant.form) if datum.kind == "guide"]
    if not guides:
        return []
    case = _SceneData(variant, asked, language)
    return [(datum.name, case.inclination(datum), case.passed(datum)) for datum in guides]


def guide_sentences(variant: Variant, asked: Sequence[Quantity], language: Language) -> Text:
    """A sentence for each inclined guide, with a space before it; it says through which point the line passes."""
    found: list[Formula | str] = []
    for point, angle, through in _guides(variant, asked, language):
        named = {"point": point} | ({"through": through} if through else {})
        formulas = {key: language.symbol(name, variant.form.symbols) for key, name in named.items()}
        sentence = language.words("sheet")["guide_through" if through else "guide"]
        found += [" ", *with_formulas(sentence, {**formulas, "angle": angle})]
    return tuple(found)


def with_formulas(sentence: str, formulas: Mapping[str, Formula]) -> Text:
    """A sentence with formulas in the place of their names in braces."""
    parts = re.split(r"\{(\w+)\}", sentence)
    return tuple(formulas[part] if i % 2 else part for i, part in enumerate(parts) if part)


class _SceneData:
    """One variant whose data are told."""

    def __init__(self, variant: Variant, asked: Sequence[Quantity], language: Language) -> None:
        self.variant, self.language = variant, language
        self.shown = set(shown_points(variant, asked))
        motion = solve_variants([variant], 0)
        self.at = {name: complex(z[0]) for name, z in motion.z.items()}
        form = variant.form
        self._values = form.values({name: variant.si(name) for name in form.parameters})
        self._frame = motion.scene.frame

    @property
    def _lies_as_written(self) -> bool:
        """Whether the scene lies on paper as its file has it: an angle with the x axis is that of the file."""
        return self.variant.sense > 0 and self.variant.turns == 0

    def _way(self, angle: float) -> complex:
        """A direction of the scene on paper, a unit vector."""
        return complex(np.ravel(self._frame.direction(angle))[0])

    def passed(self, datum: LiteralDatum) -> str:
        """The point in the figure through which the line of a guide goes, as the point in it is placed; "" for none."""
        way = self._way(self._angle(datum))
        for name in on_lines_through(self.variant.form).get(datum.name, ()):
            arm = self.at[datum.name] - self.at[name]
            if name in self.shown and abs((arm / way).imag) < _ON_LINE * abs(arm):
                return name
        return ""

    def _angle(self, datum: LiteralDatum) -> float:
        """The angle (rad) of a guide in the scene."""
        return datum.si if datum.source is None else float(datum.source.value(self._values))

    def inclination(self, datum: LiteralDatum) -> Formula:
        """The acute angle of a guide with the horizontal: a number, or the letter of a parameter that is one."""
        angle = self._angle(datum)
        is_letter = datum.source is not None and datum.source.text in self.variant.form.parameters
        if datum.source is not None and is_letter and self._lies_as_written and 0 < angle < math.pi / 2:
            name = self.variant.form.parameters[datum.source.text].symbol
            return self.language.symbol(name, self.variant.form.symbols)
        way = self._way(angle)
        return self._measured(math.atan2(abs(way.imag), abs(way.real)), self._unit("angle"))

    def equations(self, datum: LiteralDatum) -> Iterator[Equation]:
        """One equation, of a place two."""
        own = self._unit(datum.measures)
        match datum.kind:
            case "length" | "angle" if datum.source is not None and self._lies_as_written:
                name = self.variant.form.parameters[datum.source.text].symbol
                symbol = self.language.symbol(datum.name, self.variant.form.symbols)
                left = symbol if datum.kind == "length" else SymbolProperty("angle", symbol)
                yield Equation(left, self.language.symbol(name, self.variant.form.symbols))
            case "place":
                z = self.at[datum.name]
                for axis, place in (("x", z.real), ("y", z.imag)):
                    yield self._equation(f"{axis}_{datum.name}", place, own)
            case "x" | "y":
                z = self.at[datum.name]
                # On a sheet that is turned by a quarter the guide is so too.
                axis = datum.kind if self.variant.turns % 2 == 0 else "xy"[datum.kind == "x"]
                yield self._equation(f"{axis}_{datum.name}", z.real if axis == "x" else z.imag, own)
            case "angle":
                start, end = (self.at[point] for point in datum.points)
                left = SymbolProperty("angle", self.language.symbol(datum.name, self.variant.form.symbols))
                yield Equation(left, self._measured(float(np.angle(end - start)), own))
            case "corner":
                start, at, end = (self.at[point] for point in datum.points)
                angle = abs(float(np.angle((end - at) / (start - at))))
                yield Equation(Symbol(ANGLE + "".join(datum.points)), self._measured(angle, own))
            case "radius":
                yield Equation(self._radius(datum), self._measured(datum.si, own))
            case "length":
                start, end = (self.at[point] for point in datum.points)
                yield self._equation(datum.name, abs(end - start), own)
            case "direction":
                left = SymbolProperty("angle", self.language.symbol(datum.name, self.variant.form.symbols))
                yield Equation(left, self._measured(float(np.angle(self._way(datum.si))), own))
            case "rate":
                si = datum.si if datum.source is None else float(datum.source.value(self._values))
                yield self._equation(datum.name, abs(si), short_unit(si, own))

    def _radius(self, datum: LiteralDatum) -> Symbol:
        """``r_B``, of a second one of the same body ``r_2B``: as in :mod:`variantgen.methods.geometry.radii`."""
        symbol = self.language.symbol(f"r_{datum.name}", self.variant.form.symbols)
        place = literal_radii(self.variant.form, self.at).get(datum.name, [datum.si]).index(datum.si)
        return symbol._replace(index=(Index(str(place + 1)), *symbol.index)) if place else symbol

    def _equation(self, name: str, si: float, own: Unit) -> Equation:
        return Equation(self.language.symbol(name, self.variant.form.symbols), self._measured(si, own))

    def _measured(self, si: float, own: Unit) -> Measured:
        value = own.from_si(si) if abs(si) > _NOTHING else 0.0
        return Measured(self.language.decimal(Decimal(f"{value:.{_DIGITS}g}")), self.language.unit(own))

    def _unit(self, measure: str) -> Unit:
        """The printed unit."""
        length = self.variant.family.length_unit
        if measure in ("angle", "length"):
            return unit("deg" if measure == "angle" else length)
        if measure in _PER_TIME:
            return unit(length + _PER_TIME[measure])
        return unit("rad/s" if measure == "angular velocity" else "rad/s^2")
