"""A second reading of finished steps: what was said is not said again, what only prepares a step is a part of it."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from msgspec.structs import replace

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order, made_of, parts
from variantgen.methods.solution.used import read
from variantgen.methods.steps.step import (
    Body,
    CentreOf,
    Derived,
    Fact,
    Item,
    Projection,
    Segment,
    Sentence,
    Step,
    Term,
    TermTable,
    VectorOf,
)

_SAYING = ("points.about_pivot", "velocity_centre.direction", "relative.zhukovsky")  # sentences that say directions
_PREPARING = (
    "points.turning",
    "rolling.",
    "turning.",
    "rested.",
    "contact.",
)  # steps that often only prepare another one
_REASONS = {  # and what is said again
    "rope.inextensible": "",
    "belt.inextensible": "",
    "rack.no_slip": "",
    "rope.same_a": "rope.again_a",
    "belt.same_a": "belt.again_a",
}
_ROLLING = "rolling.omega"  # what a wheel rolls about
# The line of a vector and the side to which it points, which of one that is still to be found is assumed.
_PLAIN, _ASSUMED = "ways.pointed", "ways.assumed"


def read_again(steps: Sequence[Step], results: Iterable[Value]) -> list[Step]:
    """The steps as a reader wants them: nothing twice, drivers in the step that needs them.

    A line that finds again what an earlier one has found is left out, and of a vector the direction that is known
    already. A step without a vector equation and without a figure, of which only the next step needs what it finds,
    becomes its beginning.
    """
    asked = {value.name for value in results if value.name is not None}
    whole = _with_letters(_with_conversions(_without_repeated_lines(steps)))
    once = _without_idle_centres(_without_repeated_reasons(whole))
    return _joined(_without_known_directions(once), asked)


def _without_repeated_lines(steps: Sequence[Step]) -> list[Step]:
    """The steps without lines that an earlier step has, or that they have themselves in the same form."""
    seen: set[tuple[Name, float]] = set()
    kept: list[Step] = []
    for step in steps:
        items: list[Item] = []
        found: set[tuple[Name, float]] = set()
        for item in step.items:
            if isinstance(item, Derived) and item.value.name is not None:
                mark = (item.value.name, item.value.exact)
                if mark in seen or item in items:
                    continue
                found.add(mark)
            items.append(item)
        seen |= found
        kept.append(replace(step, items=items))
    return kept


def _with_conversions(steps: Sequence[Step]) -> list[Step]:
    """The steps with a line before the first use of a datum in another unit: ``omega = pi 120 / 30 = 12.57 rad/s``."""
    shown = {item.value for step in steps for item in step.items if isinstance(item, Derived)}
    met: set[Value] = set()
    kept: list[Step] = []
    for step in steps:
        items: list[Item] = []
        for item in step.items:
            more = in_order(read(item), met)
            met.update(more)
            for value in more:
                same = any(p.name == value.name for p in made_of(value))
                if same and value.name is not None and value.measure.startswith("angular") and value not in shown:
                    shown.add(value)
                    items.append(Derived(value, symbolic=False))
            items.append(item)
        kept.append(replace(step, items=items))
    return kept


def _without_repeated_reasons(steps: Sequence[Step]) -> list[Step]:
    """The steps with each reason given once: what is said again of other points is said shortly, or not at all."""
    said: set[str] = set()
    kept: list[Step] = []
    for step in steps:
        items: list[Item] = []
        for item in step.items:
            if isinstance(item, Sentence) and item.key in said and item.key in _REASONS:
                items += [replace(item, key=again)] if (again := _REASONS[item.key]) else []
            else:
                items.append(item)
            if isinstance(item, Sentence):
                said.add(item.key)
        kept.append(replace(step, items=items))
    return kept


def _without_idle_centres(steps: Sequence[Step]) -> list[Step]:
    """The steps with no letter for the contact of a wheel that is named in the sentence about its rolling alone."""
    items = [item for step in steps for item in step.items]
    met = in_order(value for item in items for value in read(item))
    used = {name.body for value in met if (name := value.name) and name.body}
    used |= {fact.body for item in items for fact in _facts(item) if isinstance(fact, CentreOf)}
    used |= {fact.centre_of for item in items for fact in _facts(item) if isinstance(fact, Segment)}
    return [replace(step, items=[_unlettered(item, used) for item in step.items]) for step in steps]


def _unlettered(item: Item, used: Collection[str]) -> Item:
    """The sentence about a rolling wheel without the letter of its contact, if that is not ``used``."""
    if not isinstance(item, Sentence) or item.key != _ROLLING or not isinstance(item.facts["contact"], Sentence):
        return item
    (centre,) = item.facts["contact"].facts.values()
    if not isinstance(centre, CentreOf) or centre.body in used:
        return item
    return replace(item, facts={**item.facts, "contact": Sentence("rolling.contact")})


def _facts(item: Item) -> list[Fact]:
    """What is named in the sentences of an item, with the sentences in them; not what a wheel rolls about."""
    waiting: list[Fact] = []
    match item:
        case Sentence(key, facts) if key != _ROLLING:
            waiting = list(facts.values())
        case TermTable(terms):
            waiting = [term.way for term in terms]
        case Projection(words):
            waiting = list(words)
    found: list[Fact] = []
    while waiting:
        fact = waiting.pop()
        found.append(fact)
        if isinstance(fact, Sentence):
            waiting += fact.facts.values()
    return found


def _with_letters(steps: Sequence[Step]) -> list[Step]:
    """The steps with a sentence before each line whose law has the first mention of an angular rate."""
    met: set[Name] = set()
    kept: list[Step] = []
    for step in steps:
        items: list[Item] = []
        for item in step.items:
            if isinstance(item, Derived) and item.law is not None:
                for name in (name for name in _rates_in(item.law) if name not in met):
                    facts: dict[str, Fact] = {"rate": name, "body": Body(name.of)}
                    items.append(Sentence(f"rates.called_{name.kind}", facts, detail=False))
                    met.add(name)
            if isinstance(item, Derived) and item.value.name is not None:
                met.add(item.value.name)
            items.append(item)
        kept.append(replace(step, items=items))
    return kept


def _rates_in(expression: Expression) -> list[Name]:
    """The names of angular velocities and accelerations that are not given, in the order of reading."""
    names = dict.fromkeys(value.name for value in parts(expression) if value.name is not None)
    return [name for name in names if name.kind in ("omega", "epsilon")]


def _without_known_directions(steps: Sequence[Step]) -> list[Step]:
    """The steps with tables of those vectors only whose directions are new.

    Of a vector of which a later sentence says to which side it points, and why, the line is enough, as it is of one
    that turns out zero, and of one that stays unknown: nothing would say why it points there. Where a system of
    equations is to say it, the side is assumed. Of a rotation about a pole it is said once how its vectors lie.
    """
    known: set[Name] = set()
    usual: set[tuple[str, str]] = set()
    kept: list[Step] = []
    for step in steps:
        projections = [item for item in step.items if isinstance(item, Projection)]
        reasons: set[Name | None] = {name for item in projections for name in _sought(item)}
        found = [item.value for item in step.items if isinstance(item, Derived)]
        reasons |= {value.name for value in found if value.name is not None and value.exact == 0}
        reasons |= _unknown(step) - {value.name for value in found}
        items: list[Item] = []
        for item in step.items:
            if isinstance(item, Sentence) and item.key.startswith(_SAYING):
                known |= _vectors(item)
            if isinstance(item, TermTable):
                terms = [_line(term) if term.name in reasons else _assumed(term) for term in item.terms]
                new = [term for term in terms if not _is_known(term, known) and _usual(term) not in usual]
                items += [TermTable(tuple(new))] if new else []
                known |= {term.name for term in terms}
                usual |= {line for term in new if (line := _usual(term)) is not None}
            else:
                items.append(item)
        kept.append(replace(step, items=items))
    return kept


def _sought(item: Projection) -> set[Name]:
    """The vectors of which the words of a projection say to which side they point."""
    reasons = (sentence for sentence in item.words if sentence.key.startswith("axes.by_"))
    return {name for sentence in reasons for name in _vectors(sentence)}


def _unknown(step: Step) -> set[Name | None]:
    """The vectors of its tables whose magnitudes are not known before, without those that an equation projects."""
    terms = [term for item in step.items if isinstance(item, TermTable) for term in item.terms]
    unknown: set[Name | None] = {term.name for term in terms if term.size is None}
    used = [item for item in step.items if isinstance(item, Projection)]
    return unknown - {share.term.name for item in used for share in (*item.left, *item.right)}


def _vectors(sentence: Sentence) -> set[Name]:
    """The vector that a sentence is about."""
    fact = sentence.facts.get("vector")
    return {fact.name} if isinstance(fact, VectorOf) else set()


def _line(term: Term) -> Term:
    """A term of a table without the side to which it points."""
    way = term.way.facts.get("way") if term.way.key == _PLAIN else None
    return replace(term, way=way) if isinstance(way, Sentence) else term


def _assumed(term: Term) -> Term:
    """A term of a table, its side as assumed where nothing has found it."""
    is_open = term.size is None and term.way.key == _PLAIN
    return replace(term, way=replace(term.way, key=_ASSUMED)) if is_open else term


def _usual(term: Term) -> tuple[str, str] | None:
    """How a vector of a rotation about a moving pole lies, as all such vectors do; None for others.

    The normal acceleration leads to the pole, velocity and tangential acceleration are across the radius: that is said
    of the first of them.
    """
    usual = term.name.about and term.way.key in ("ways.towards", "ways.across")
    return (term.name.kind, term.way.key) if usual else None


def _is_known(term: Term, known: Collection[Name]) -> bool:
    """Whether the direction of a vector, or of the whole of which it is a component, has been said."""
    return term.is_laid or term.name in known or (not term.name.about and term.name.whole in known)


def _joined(steps: Sequence[Step], asked: Collection[Name]) -> list[Step]:
    """The steps, those that only prepare the next one as its beginning."""
    kept: list[Step] = []
    for step in reversed(steps):
        if kept and _prepares(step, kept[-1], asked):
            following = kept.pop()
            kept.append(replace(following, items=[*step.items, *following.items]))
        else:
            kept.append(step)
    return kept[::-1]


def _prepares(step: Step, following: Step, asked: Collection[Name]) -> bool:
    """Whether a step finds only what the following one needs: the motion of a point of the driving link, of a wheel."""
    if step.views or not step.heading.key.startswith(_PREPARING):
        return False
    found = [item.value for item in step.items if isinstance(item, Derived)]
    if any(value.name in asked for value in found):
        return False
    met = in_order(value for item in following.items for value in read(item))
    return any(value in met for value in found)
