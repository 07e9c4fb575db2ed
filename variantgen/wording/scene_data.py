"""The data of a scene that has no statement of its own: what its file says in numbers, as given equations."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal

import numpy as np

from variantgen.families.literal_data import LiteralDatum, literal_data, literal_radii
from variantgen.families.parameters.units import Unit, short_unit, unit
from variantgen.families.quantities import Quantity, motion_order
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Equation, Index, Measured, Symbol, SymbolProperty
from variantgen.wording.formula.tree import ANGLE
from variantgen.wording.language import Language

_DIGITS = 6  # of a number of the file, which may stand there in another unit
_NOTHING = 1e-12  # of a coordinate: rounding
_PER_TIME = {"velocity": "/s", "acceleration": "/s^2"}


def scene_data(
    variant: Variant, asked: Sequence[Quantity], language: Language
) -> tuple[list[Equation], list[Equation]]:
    """Lengths, radii, angles and places; then the magnitudes of rates, whose sense the figure shows.

    Places and directions are those on paper. What lies at points that the figure does not show is left out, and rates
    that only accelerations depend on where none is asked.
    """
    case = _SceneData(variant, asked, language)
    found = list({(datum.kind, datum.name, datum.si): datum for datum in literal_data(variant.form)}.values())
    seen = [datum for datum in found if set(datum.points) <= case.shown and datum.unless not in case.shown]
    kinds = ("length", "radius", "angle", "corner", "place", "x", "y")
    position = [e for kind in kinds for datum in seen if datum.kind == kind for e in case.equations(datum)]
    slow = motion_order(asked) == 1
    rates = [datum for datum in found if datum.kind == "rate" and not (datum.second and slow)]
    return position, [e for datum in rates for e in case.equations(datum)]


class _SceneData:
    """One variant whose data are told."""

    def __init__(self, variant: Variant, asked: Sequence[Quantity], language: Language) -> None:
        self.variant, self.language = variant, language
        self.shown = set(shown_points(variant, asked))
        motion = solve_variants([variant], 0)
        self.at = {name: complex(z[0]) for name, z in motion.z.items()}
        form = variant.form
        self._values = form.values({name: variant.si(name) for name in form.parameters})

    def equations(self, datum: LiteralDatum) -> Iterator[Equation]:
        """One equation, of a place two."""
        own = self._unit(datum.measures)
        match datum.kind:
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
            case "rate":
                si = datum.si if datum.source is None else float(datum.source.value(self._values))
                yield self._equation(datum.name, abs(si), short_unit(si, own))

    def _radius(self, datum: LiteralDatum) -> Symbol:
        """``r_B``, of a second one of the same body ``r_2B``: as in :mod:`variantgen.methods.geometry.radii`."""
        symbol = self.language.symbol(f"r_{datum.name}", self.variant.form.symbols)
        place = literal_radii(self.variant.form)[datum.name].index(datum.si)
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
