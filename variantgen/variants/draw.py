"""Drawing of variants: uniform over the valid part of the grid, bounded, distinct.

For each student the raw stream is cut into attempts (one word for the pose, one per parameter). The first attempt
that passes all screens is the variant: that is rejection sampling, uniform over the valid grid. Attempts of all
students are screened together as one batch.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem, VariantgenError
from variantgen.families.asking import read_ask
from variantgen.families.family import Family, Form, frame
from variantgen.families.quantities import Quantity
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.solve import add_speeds, solve
from variantgen.variants.screening import (
    motion_screens,
    parameter_screens,
    position_screens,
    sensitivity,
    verification,
)
from variantgen.variants.seeding import Stream, index_below
from variantgen.variants.variant import Variant

MAX_ATTEMPTS = 20_000
_CHUNK = 12


class VerificationError(VariantgenError):
    """The solver and the independent computation disagree: a defect of the program, never to reach paper."""


@dataclass
class Tally:
    """How many attempts were made, and how many each screen was the first to reject."""

    attempts: int = 0
    rejected: Counter[str] = field(default_factory=Counter)

    def report(self) -> str:
        """The screens that rejected most, in words."""
        parts = [f"{name}: {count}" for name, count in self.rejected.most_common(4) if count]
        return f"of {self.attempts} draws rejected by " + "; ".join(parts)


def draw(
    family: Family, ask: Sequence[str] | None, keys: Sequence[tuple[object, ...]], tally: Tally | None = None
) -> list[Variant]:
    """One variant per key, each depending on its key only (and on the family); keys may repeat variants.

    ``ask`` names the asked quantities (None: those of each form). Raises InputError when the ranges leave nothing.
    """
    return Drawing(family, ask, tally).after(keys, [0] * len(keys))


@dataclass(frozen=True)
class Entry:
    """A wish for one variant: from which drawing, by which key, and its rank where two would get the same."""

    drawing: Drawing
    key: tuple[object, ...]
    priority: bytes


def draw_distinct(entries: Sequence[Entry]) -> tuple[list[Variant], list[int]]:
    """One variant per entry, no two the same; also the positions of those that had to draw again.

    Where two entries would get the same variant, the one with the smaller ``priority`` keeps it and the other takes
    the next of its own valid draws. The result does not depend on the order of the entries (it is the stable
    matching of deferred acceptance). Raises InputError if there are fewer distinct variants than entries.
    """
    _check_room(entries)
    found = _drawn(entries, [0] * len(entries))
    again: set[int] = set()
    seen = {variant.identity for variant in found}
    idle = 0
    while True:
        holders: dict[object, int] = {}
        losers = []
        for i in sorted(range(len(entries)), key=lambda i: entries[i].priority):
            if holders.setdefault(found[i].identity, i) != i:
                losers.append(i)
        if not losers:
            return found, sorted(again)
        again.update(losers)
        replaced = _drawn([entries[i] for i in losers], [found[i].attempt for i in losers])
        for i, variant in zip(losers, replaced, strict=True):
            found[i] = variant
        new = {variant.identity for variant in replaced} - seen
        seen |= new
        idle = 0 if new else idle + len(losers)
        # One unseen variant among n is missed by 20 n draws with a probability of 2e-9.
        if idle > 100 + 20 * len(seen):
            raise InputError(_too_few(entries[losers[0]].drawing, len(entries), len(seen)))


def _check_room(entries: Sequence[Entry]) -> None:
    """Raise InputError where there are more entries than points of the grid, without drawing anything."""
    wanted = Counter(id(entry.drawing) for entry in entries)
    for drawing in {id(entry.drawing): entry.drawing for entry in entries}.values():
        room = sum(form.grid_size for form in drawing.forms)
        if room < wanted[id(drawing)]:
            raise InputError(_too_few(drawing, wanted[id(drawing)], room))


def _too_few(drawing: Drawing, wanted: int, found: int) -> Problem:
    return Problem(
        f"the ranges leave too few distinct variants: {wanted} sheets need as many, at most {found} were found",
        key=drawing.where,
        remedy="widen a range, fix fewer parameters or add another family to the pool",
    )


def _drawn(entries: Sequence[Entry], done: Sequence[int]) -> list[Variant]:
    """The next valid draw of each entry; entries of one drawing are screened as one batch."""
    groups: dict[int, list[int]] = {}
    for i, entry in enumerate(entries):
        groups.setdefault(id(entry.drawing), []).append(i)
    found: dict[int, Variant] = {}
    for members in groups.values():
        drawing = entries[members[0]].drawing
        drawn = drawing.after([entries[i].key for i in members], [done[i] for i in members])
        found.update(zip(members, drawn, strict=True))
    return [found[i] for i in range(len(entries))]


class Drawing:
    """The drawing of one family for one list of asked quantities."""

    def __init__(self, family: Family, ask: Sequence[str] | None, tally: Tally | None = None, where: str = "") -> None:
        self.family = family
        self.where = f"{where}: {family.name}" if where else family.name
        self.forms = list(family.forms.values())
        self.asked = {form.name: read_ask(form, ask) for form in self.forms}
        self.tally = tally or Tally()

    def after(self, keys: Sequence[tuple[object, ...]], done: Sequence[int]) -> list[Variant]:
        """The first valid draw of each key after the attempts ``done`` that it has used."""
        streams = [Stream(*key, self.family.name) for key in keys]
        chosen = [int(index_below(stream.words(1), len(self.forms))[0]) for stream in streams]
        found: dict[int, Variant] = {}
        for number, form in enumerate(self.forms):
            members = [i for i, choice in enumerate(chosen) if choice == number]
            if members:
                batch = _FormDrawing(self, form)
                drawn = batch.run([streams[i] for i in members], [done[i] for i in members])
                found.update(zip(members, drawn, strict=True))
        return [found[i] for i in range(len(keys))]


@dataclass(frozen=True)
class _Attempts:
    """A batch of attempts: grid indices per parameter, pose, and which student each belongs to."""

    index: dict[str, NDArray[np.int64]]
    pose: NDArray[np.int64]
    owner: NDArray[np.int64]
    number: NDArray[np.int64]

    def take(self, chosen: NDArray[np.int64]) -> _Attempts:
        return _Attempts(
            {name: i[chosen] for name, i in self.index.items()},
            self.pose[chosen],
            self.owner[chosen],
            self.number[chosen],
        )


class _FormDrawing:
    """Attempts of many students at one form."""

    def __init__(self, drawing: Drawing, form: Form) -> None:
        self.family, self.form, self.where = drawing.family, form, drawing.where
        self.asked: list[Quantity] = drawing.asked[form.name]
        self.tally = drawing.tally
        self.names = sorted(form.parameters)
        self.poses = form.pose.frames()
        self.order = max(q.order for q in self.asked)

    def run(self, streams: Sequence[Stream], done: Sequence[int]) -> list[Variant]:
        """The first valid attempt of each stream after the attempts already used."""
        width = len(self.names) + 1
        for stream, skipped in zip(streams, done, strict=True):
            stream.words(skipped * width)
        used = np.array(done)
        found: dict[int, Variant] = {}
        pending, chunk = list(range(len(streams))), _CHUNK
        while pending:
            words = np.array([streams[i].words(chunk * width) for i in pending]).reshape(-1, width)
            owner = np.repeat(pending, chunk)
            number = used[owner] + np.tile(np.arange(1, chunk + 1), len(pending))
            attempts = self._attempts(words, owner, number)
            for variant, i in self._accepted(attempts):
                found[i] = variant
            used[pending] += chunk
            pending = [i for i in pending if i not in found]
            chunk = min(2 * chunk, 2048)
            if pending and min(used[pending] - np.array(done)[pending]) > MAX_ATTEMPTS:
                raise InputError(self._exhausted())
        return [found[i] for i in range(len(streams))]

    def _attempts(self, words: NDArray[np.uint64], owner: NDArray[np.int64], number: NDArray[np.int64]) -> _Attempts:
        index = {
            name: index_below(words[:, i + 1], len(self.form.parameters[name].printed))
            for i, name in enumerate(self.names)
        }
        return _Attempts(index, index_below(words[:, 0], len(self.poses)), owner, number)

    def _si(self, attempts: _Attempts) -> dict[str, NDArray[np.float64]]:
        return {name: self.form.parameters[name].si[i] for name, i in attempts.index.items()}

    def _frame(self, attempts: _Attempts) -> Frame:
        poses = np.array(self.poses)[attempts.pose]
        return frame(poses[:, 0], poses[:, 1])

    def _accepted(self, attempts: _Attempts) -> Iterator[tuple[Variant, int]]:
        """First acceptable attempt of each owner; later ones are looked at only if earlier ones fail."""
        promising = self._promising(attempts)
        while promising.owner.size:
            _, firsts = np.unique(promising.owner, return_index=True)
            heads = promising.take(firsts)
            good = self._sound(heads)
            for i in np.flatnonzero(good):
                yield self._variant(heads, int(i)), int(heads.owner[i])
            settled = set(heads.owner[good].tolist())
            keep = [j for j in range(promising.owner.size) if promising.owner[j] not in settled]
            promising = promising.take(np.setdiff1d(np.array(keep, dtype=np.int64), firsts))

    def _promising(self, attempts: _Attempts) -> _Attempts:
        """Attempts that pass the cheap screens, in order."""
        self.tally.attempts += attempts.owner.size
        parameters = self._si(attempts)
        values = self.form.values(parameters)
        passed = self._keep(parameter_screens(self.form, values, attempts.owner.size), attempts.owner.size)
        attempts = attempts.take(passed)
        if not attempts.owner.size:
            return attempts
        values = self.form.values(self._si(attempts))
        motion = solve(self.form.scene(values, self._frame(attempts)), 0, self.form.plan)
        passed = self._keep(position_screens(self.form, motion, values), attempts.owner.size)
        attempts = attempts.take(passed)
        if not attempts.owner.size:
            return attempts
        motion = add_speeds(motion.take(passed), self.form.plan, self.order)
        return attempts.take(self._keep(motion_screens(self.form, motion, self.asked), attempts.owner.size))

    def _sound(self, attempts: _Attempts) -> NDArray[np.bool_]:
        """Whether the answers are well conditioned. Raises VerificationError if the two computations disagree."""
        parameters, on_paper = self._si(attempts), self._frame(attempts)
        motion = solve(self.form.scene(self.form.values(parameters), on_paper), self.order, self.form.plan)
        gain = sensitivity(self.form, parameters, on_paper, self.asked, motion)
        good = gain <= self.form.screens.sensitivity * (1 + 1e-6)
        self.tally.rejected["answers well conditioned"] += int(np.sum(~good))
        if np.any(good):
            checked = np.flatnonzero(good)
            agrees = verification(motion.take(checked), self.order)
            if not np.all(agrees):
                bad = self._variant(attempts, int(checked[np.flatnonzero(~agrees)[0]]))
                raise VerificationError(
                    f"{self.family.name}: the solver and the independent computation disagree for "
                    + ", ".join(f"{k}={v}" for k, v in bad.printed.items())
                )
        return good

    def _keep(self, screens: dict[str, NDArray[np.bool_]], size: int) -> NDArray[np.int64]:
        alive = np.ones(size, dtype=bool)
        for name, passed in screens.items():
            self.tally.rejected[name] += int(np.sum(alive & ~passed))
            alive &= passed
        return np.flatnonzero(alive)

    def _variant(self, attempts: _Attempts, i: int) -> Variant:
        printed = {name: self.form.parameters[name].printed[int(index[i])] for name, index in attempts.index.items()}
        sense, turns = self.poses[int(attempts.pose[i])]
        return Variant(
            self.family,
            self.form,
            {name: printed[name] for name in self.form.parameters},
            sense,
            turns,
            int(attempts.number[i]),
        )

    def _exhausted(self) -> Problem:
        narrow = [name for name, p in self.form.parameters.items() if p.given and len(p.printed) <= 2]
        which = ", ".join(narrow or [name for name, p in self.form.parameters.items() if p.given])
        return Problem(
            "no valid variant found: " + self.tally.report(),
            key=f"{self.where}{'/' + self.form.name if self.form.name else ''}",
            remedy=f"widen the range of one of: {which}",
        )
