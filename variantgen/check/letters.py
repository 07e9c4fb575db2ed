"""Whether a letter has two meanings on one sheet."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.wording.formula import Symbol, to_plain
from variantgen.wording.language import Language

_ANGULAR = ("angle", "angular velocity", "angular acceleration")


def ambiguous_letters(form: Form, asked: Sequence[Quantity], language: Language) -> Iterator[str]:
    """Messages about given data and asked quantities that a language writes alike.

    Two names may not have one symbol, nor an angle the letter of an angular velocity or acceleration.
    """
    meant: dict[str, tuple[Symbol, str]] = {}
    for parameter in form.parameters.values():
        if parameter.given and parameter.unit is not None:
            symbol = language.symbol(parameter.symbol, form.symbols)
            meant[parameter.symbol] = symbol, parameter.unit.measures
    for quantity in asked:
        if quantity.is_vector or quantity.is_rotation or quantity.kind == "mu":
            name, measures = quantity.whole_name, quantity.unit("m").measures
            meant.setdefault(name, (language.symbol(name, form.symbols), measures if not quantity.component else ""))
    for (one, (first, kind)), (two, (second, other)) in combinations(meant.items(), 2):
        alike = first.base == second.base and kind != other and {kind, other} <= set(_ANGULAR)
        if first == second or alike:
            both = to_plain(first) if first == second else f"{to_plain(first)} and {to_plain(second)}"
            yield f"{both} stands for {one} and for {two}; give one of them another name, or see [notation]"
