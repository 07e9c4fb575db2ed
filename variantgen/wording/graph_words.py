"""What a statement says of graphs: the one that gives a rate, and the curves that are to be sketched."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from variantgen.families.family import Form
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity, split_name
from variantgen.families.rate_graphs import grid_of
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Equation, Formula, Measured, Symbol
from variantgen.wording.language import Language
from variantgen.wording.text import Text


def graph_sentences(form: Form, language: Language) -> Text:
    """What is said of the graph that gives a rate, and of the curves to be sketched, a sentence each."""
    words, found = language.words("sheet"), list[str | Formula]()
    if graph := form.figure.graph:
        symbol = language.symbol(form.parameters[graph[0]].symbol, form.symbols)
        found += _sentence(words["by_graph"], {"symbol": [symbol], "time": [Symbol("t")]})
    symbols = [language.quantity(split_name(name), form.symbols) for name in form.figure.sketch]
    if symbols:
        listed, key = _listed(symbols, language), "sketches" if symbols[1:] else "sketch"
        found += _sentence(words[key], {"symbols": listed, "symbol": listed, "angle": [Symbol("theta")]})
    return tuple(found)


def _sentence(words: str, facts: Mapping[str, Sequence[str | Formula]]) -> list[str | Formula]:
    """A sentence after others, with what stands for its fields."""
    pieces = re.split(r"{(\w+)}", words)
    return [" ", *(part for i, piece in enumerate(pieces) for part in (facts[piece] if i % 2 else [piece]) if part)]


def _listed(symbols: Sequence[Formula], language: Language) -> list[str | Formula]:
    """``a``, ``a and b``, ``a, b and c``."""
    last = language.words("figure")["and"].partition("{first}")[2].partition("{last}")[0]
    between = [", "] * (len(symbols) - 2) + [last]
    return [part for pair in zip(["", *between], symbols, strict=False) for part in pair if part != ""]


def read_off(form: Form, asked: Sequence[Quantity]) -> list[Quantity]:
    """The quantities whose signs and letters a reader of a problem meets: those asked, and those to be sketched."""
    return [*asked, *(quantity for name in form.figure.sketch if (quantity := split_name(name)) not in asked)]


def graph_instant(variant: Variant, language: Language) -> list[Equation]:
    """The time on the graph of a given rate at which the mechanism has its position; none without such a graph."""
    names = variant.form.figure.graph
    if not names:
        return []
    found = grid_of(*(abs(variant.printed[name]) for name in names))
    assert found is not None, "families with such data are refused"
    return [Equation(Symbol("t"), Measured(language.decimal(found[0]), language.unit(unit("s"))))]
