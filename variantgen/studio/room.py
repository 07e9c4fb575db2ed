"""How much room a problem has: which share of the draws passes, which screens reject how many, and where."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from msgspec import Struct

from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.families.parameters.draw_rules import frame
from variantgen.mechanism.outcome import Outcome
from variantgen.variants.attempts import FormSampler
from variantgen.variants.batch import Attempts, RejectionCounts
from variantgen.variants.examined import examined
from variantgen.variants.seeding import Stream, index_below
from variantgen.variants.variant import solve_variants

if TYPE_CHECKING:
    from variantgen.families.family import Family, Form
    from variantgen.families.quantities import Quantity
    from variantgen.variants.variant import Variant

DRAWS = 400
# What screens are called, by the words in their names; the key of the words for all of their kind.
_KINDS = (
    ("not trivial", "trivial"),
    ("well conditioned", "conditioned"),
    ("mistakes", "mistakes"),
    ("rounding", "conditioned"),
    ("dead points", "dead"),
    ("assembles", "assembles"),
    ("off other links", "off_links"),
    ("hinges apart", "apart"),
    ("aspect", "aspect"),
    ("nearly horizontal", "slant"),
    ("inside", "inside"),
    ("hand-friendly", "nice"),
    ("require", "require"),
)


def kind_of(screen: str) -> str:
    """The kind of a screen, by its name."""
    return next((kind for words, kind in _KINDS if words in screen), "machine")


class Room(Struct, frozen=True):
    """Of so many ``draws`` those that passed, those that each kind of screen rejected first, the size of the grid.

    ``accepted`` has, by parameter, how many of those that passed have each value of its grid.
    """

    draws: int
    passed: int
    rejected: Mapping[str, int]
    grid: int
    accepted: Mapping[str, Sequence[int]]

    @property
    def variants(self) -> int:
        """About how many variants there are."""
        return round(self.grid * self.passed / self.draws) if self.draws else 0


def room(family: Family, form: Form, names: tuple[str, ...] | None) -> Room:
    """The room of a form for what is asked (None: what it asks), from draws that are always the same."""
    known = form.remembered
    key = ("room", names)
    if key not in known:
        known[key] = _counted(family, form, names, DRAWS)
    found: Room = known[key]
    return found


def _counted(family: Family, form: Form, names: tuple[str, ...] | None, draws: int) -> Room:
    from variantgen.families.asking import read_ask

    asked = examined(form, read_ask(form, names))
    tally = RejectionCounts()
    drawing = FormSampler(family, form, asked, tally, family.name)
    attempts = _drawn(form, draws)
    left = drawing.valid(attempts)
    if left.number.size:
        screening = AnswerTolerances()(form, _si(form, left), _frame(form, left), asked, _solved(left))
        for name, passed in screening.of_all().items():
            tally.rejected[name] += int(np.count_nonzero(~passed))
            left = left.take(np.flatnonzero(passed))
    rejected: dict[str, int] = {}
    for name, count in tally.rejected.items():
        if count:
            rejected[kind_of(name)] = rejected.get(kind_of(name), 0) + count
    accepted = {
        name: np.bincount(left.index[name], minlength=len(parameter.printed)).tolist()
        for name, parameter in form.parameters.items()
        if parameter.given
    }
    return Room(draws, int(left.number.size), rejected, form.grid_size, accepted)


def reason(family: Family, variant: Variant, asked: Sequence[Quantity]) -> str:
    """The kind of screen that rejects a variant, '' if none does; ``impossible`` where there is no such position."""
    form = variant.form
    if Outcome(int(solve_variants([variant], 0).outcome[0])) is not Outcome.SOLVED:
        return "impossible"
    try:
        index = {name: np.array([p.printed.index(variant.printed[name])]) for name, p in form.parameters.items()}
        pose = form.pose.frames().index((variant.sense, variant.turns))
    except ValueError:
        index, pose = {}, 0
    if not index:
        return ""
    tally = RejectionCounts()
    one = np.array([0])
    FormSampler(family, form, examined(form, list(asked)), tally, family.name).valid(
        Attempts(index, np.array([pose]), one, one)
    )
    return next((kind_of(name) for name, count in tally.rejected.items() if count), "")


def _drawn(form: Form, count: int) -> Attempts:
    """So many attempts, uniform over the grid."""
    names, poses = sorted(form.parameters), form.pose.frames()
    words = Stream("room", form.name).words(count * (len(names) + 1)).reshape(count, -1)
    index = {name: index_below(words[:, i + 1], len(form.parameters[name].printed)) for i, name in enumerate(names)}
    if form.ties:
        row = index_below(words[:, 1 + names.index(form.ties.names[0])], len(form.ties.rows))
        index |= {name: place[row] for name, place in form.ties.places(form.parameters).items()}
    number = np.arange(count)
    return Attempts(index, index_below(words[:, 0], len(poses)), number, number)


def _si(form: Form, attempts: Attempts) -> dict[str, Any]:
    return {name: form.parameters[name].si[i] for name, i in attempts.index.items()}


def _frame(form: Form, attempts: Attempts) -> Any:
    poses = np.array(form.pose.frames())[attempts.pose]
    return frame(poses[:, 0], poses[:, 1])


def _solved(attempts: Attempts) -> Any:
    assert attempts.motion is not None, "valid attempts are solved"
    return attempts.motion
