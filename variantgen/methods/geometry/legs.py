"""Vectors of known direction on paper: their sums, those along one line collected."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from variantgen.algebra.expression import Expression
from variantgen.algebra.normal_form import Signed, positive, summed
from variantgen.methods.geometry.angles import AngleForm


class Leg(Struct, frozen=True):
    """A vector: its length (printed unit; a negative one points backwards) and its direction on paper."""

    length: Expression
    form: AngleForm

    def reversed(self) -> Leg:
        """The opposite vector."""
        return Leg(self.length, self.form.turned(180.0))


def collected(legs: Iterable[Leg], nothing: float) -> list[Leg]:
    """Legs along the same line added, each of positive length; what is below ``nothing`` is left out."""
    groups: list[tuple[AngleForm, list[Signed]]] = []
    for leg in legs:
        if abs(leg.length.number(True)) <= nothing:
            continue
        for form, terms in groups:
            if form.is_along(leg.form):
                same = abs((leg.form.constant - form.constant + 90.0) % 360.0 - 90.0) < 1.0
                terms.append((1 if same else -1, leg.length))
                break
        else:
            groups.append((leg.form, [(1, leg.length)]))
    found = []
    for form, terms in groups:
        sign, length = positive(summed(terms))
        if abs(length.number(True)) > nothing:
            found.append(Leg(length, form if sign > 0 else form.turned(180.0)))
    return found
