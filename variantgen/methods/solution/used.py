"""Leaves out the steps and lines that only find what nothing else in a solution is computed from."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from msgspec.structs import replace

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order, parts
from variantgen.methods.steps.printed_digits import facts_values, shown_values
from variantgen.methods.steps.step import Derived, Item, Projection, Sentence, Step, TermTable, VectorLine, VectorOf

_TURNING = ("omega", "epsilon")
_QUIET = ("length", "angle", "direction", "parameter", "v", "a", *_TURNING)  # kinds that nothing but formulas needs
_SENSES = ("clockwise", "counter_clockwise")
_RATES = [f"rates.{kind}_{sense}{end}" for kind in _TURNING for sense in _SENSES for end in ("", "_sum")]
_BY_CENTRE = "velocity_centre.link"  # the heading of the velocity of a point and of the angular velocity of a link
_ANNOUNCED = [f"velocity_centre.direction_{sense}" for sense in ("clockwise", "counter_clockwise")]
_BOTH = "points.about_pivot_a"  # the sentence about both components of an acceleration


def used_steps(steps: Sequence[Step], results: Iterable[Value]) -> list[Step]:
    """The steps of which a later one or the ``results`` need a value; those that derive none are kept.

    A step that finds a zero is kept too: it explains why a vector is absent from a later equation. What an earlier step
    has found already is no reason to keep one that writes it down again.
    """
    needed = set(in_order(results))
    names = _names(needed)
    derived = [[item.value for item in step.items if isinstance(item, Derived)] for step in steps]
    first: dict[Name | None, int] = {}
    for number, values in enumerate(derived):
        for value in values:
            first.setdefault(value.name, number)
    kept: list[Step] = []
    for number, step in reversed(list(enumerate(steps))):
        values = derived[number]
        found = {value.name for value in values if first[value.name] == number}
        if not values or found & names or any(value.exact == 0 for value in values):
            kept.append(step)
            more = in_order((value for item in step.items for value in read(item)), needed)
            needed.update(more)
            names |= _names(more)
    return kept[::-1]


def used_lines(steps: Sequence[Step], results: Iterable[Value]) -> list[Step]:
    """The steps without the lines of which no later line and no result needs the value, nor sentences about these.

    A vector is needed where it is projected or something is computed from it; that an equation names it is no reason to
    work out its magnitude.
    """
    met = set(in_order(results))
    names = _names(met)
    drawn: set[Name] = set()
    kept: list[Step] = []
    for step in reversed(steps):
        items: list[Item] = []
        for item in reversed(step.items):
            if _is_idle(item, names) or _leads_nowhere(item, names | drawn):
                continue
            if isinstance(item, VectorLine):
                drawn |= {term.name for term in (*item.left, *item.right)}
            items.append(_without_normal(item, names | drawn) if isinstance(item, Sentence) else item)
            more = in_order(read(item), met)
            met.update(more)
            names |= _names(more)
        kept.append(replace(step, heading=_heading(step, items), items=items[::-1]))
    return kept[::-1]


def _heading(step: Step, items: Collection[Item]) -> Sentence:
    """The heading of a step, without the angular velocity of the link where the line that finds it is left out."""
    found = {item.value.name for item in step.items if isinstance(item, Derived)}
    gone = found - {item.value.name for item in items if isinstance(item, Derived)}
    if step.heading.key == _BY_CENTRE and any(name is not None and name.kind == "omega" for name in gone):
        return Sentence("velocity_centre.point", {"point": step.heading.facts["point"]})
    return step.heading


def _is_idle(item: Item, needed: Collection[Name]) -> bool:
    """Whether a line finds only what is not needed, or a sentence tells the sense of such a rate.

    Of the roots of a system those that are rates are left out, and the lines that show how something is computed.
    """
    if isinstance(item, Sentence):
        rate = item.facts.get("rate")
        if item.key not in _RATES or not isinstance(rate, Name):
            return False
        kind, body = rate.kind, rate.of
        return not any(name.kind == kind and name.of == body for name in needed)
    if not isinstance(item, Derived):
        return False
    name = item.value.name
    if name is None or item.value.exact == 0 or name in needed:
        return False
    return name.kind in (_QUIET if item.symbolic else () if item.numeric else _TURNING)


def _leads_nowhere(item: Item, met: Collection[Name]) -> bool:
    """Whether a sentence announces the magnitude of a velocity about the centre that nobody needs."""
    if not isinstance(item, Sentence) or item.key not in _ANNOUNCED:
        return False
    vector = item.facts.get("vector")
    return isinstance(vector, VectorOf) and vector.name not in met


def _without_normal(sentence: Sentence, met: Collection[Name]) -> Sentence:
    """The sentence about the components of an acceleration, of the tangential one alone if the other is never met."""
    whole = sentence.facts.get("vector")
    if sentence.key != _BOTH or not isinstance(whole, VectorOf) or whole.name.component("n") in met:
        return sentence
    return replace(
        sentence, key="points.about_pivot_v", facts={**sentence.facts, "vector": VectorOf(whole.name.component("tau"))}
    )


def _names(values: Iterable[Value]) -> set[Name]:
    return {value.name for value in values if value.name is not None}


def read(item: Item) -> Sequence[Value]:
    """The values that a reader meets in an item: a table says directions in words, of magnitudes what is known before.

    Of a law only the lengths: they show why it comes down to what follows. Found once, as those that are shown.
    """
    known = vars(item)
    if "read" not in known:
        known["read"] = _read(item)
    found: Sequence[Value] = known["read"]
    return found


def _read(item: Item) -> Sequence[Value]:
    if isinstance(item, Derived) and item.law is not None:
        return [item.value, *(value for value in parts(item.law) if value.measure == "length")]
    if isinstance(item, TermTable):
        return [value for term in item.terms for value in facts_values(term.way)]
    if isinstance(item, Projection):
        sizes = [share.term.size for share in (*item.left, *item.right) if share.term.size is not None]
        return [*sizes, *shown_values(item)]
    return shown_values(item)
