"""What a statement says of graphs: the one that gives a rate, and the curves that are to be sketched."""

from __future__ import annotations

from variantgen.families.family import Form
from variantgen.families.quantities import split_name
from variantgen.families.rate_graphs import grid_of
from variantgen.families.units import unit
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Equation, Formula, Measured, Symbol
from variantgen.wording.language import Language
from variantgen.wording.text import Text


def graph_sentences(form: Form, language: Language) -> Text:
    """What is said of the graph that gives a rate, and of the curves to be sketched, a sentence each."""
    words, found = language.words("sheet"), list[str | Formula]()
    if graph := form.figure.graph:
        before, after = words["by_graph"].split("{symbol}")
        found += [" " + before, language.symbol(form.parameters[graph[0]].symbol, form.symbols), after]
    for name in form.figure.sketch:
        before, after = words["sketch"].split("{symbol}")
        found += [" " + before, language.quantity(split_name(name), form.symbols), after]
    return tuple(found)


def graph_instant(variant: Variant, language: Language) -> list[Equation]:
    """The time on the graph of a given rate at which the mechanism has its position; none without such a graph."""
    names = variant.form.figure.graph
    if not names:
        return []
    found = grid_of(*(abs(variant.printed[name]) for name in names))
    assert found is not None, "families with such data are refused"
    return [Equation(Symbol("t"), Measured(language.decimal(found[0]), language.unit(unit("s"))))]
