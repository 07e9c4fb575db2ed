"""Attempts at one form of a family: drawn grid points, screened as a batch, until each key has a valid one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem, VariantgenError
from variantgen.families.family import Family, Form
from variantgen.families.parameters.draw_rules import frame
from variantgen.families.quantities import Quantity, motion_order
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.solving.solve import add_speeds, solve
from variantgen.variants.batch import Attempts, MakeScreening, RejectionCounts, joined, no_valid_variant, starts
from variantgen.variants.friendly import friendly_answers
from variantgen.variants.screening import (
    clear_answers,
    motion_screens,
    parameter_screens,
    position_screens,
    sensitivity,
    verification,
)
from variantgen.variants.seeding import Stream, index_below
from variantgen.variants.variant import Variant, solve_variants

MAX_ATTEMPTS = 20_000  # of one student
MAX_FRIENDLY_ATTEMPTS = 60_000  # where the answers, too, are chosen
_CHUNK = 12
_AT_LEAST, _AHEAD = 96, 4  # attempts whose answers are looked at together, where there are as many; most of one owner
# Attempts of a batch, and points of them: they bound the memory where few are valid or scenes are large.
_MOST_AT_ONCE, _POINTS_AT_ONCE = 60_000, 1_500_000
# A batch of which nobody has a variant yet is given up after so many attempts, in those of one student, and so many
# examined ones, which cost most: with one valid attempt in a hundred, that happens once in 20 000 times.
_HOPELESS, _HOPELESS_JUDGED = 2, 1000


class VerificationError(VariantgenError):
    """The solver and the independent computation disagree: a defect of the program, never to reach paper."""


class FormSampler:
    """Attempts of many students at one form."""

    def __init__(
        self,
        family: Family,
        form: Form,
        asked: Sequence[Quantity],
        tally: RejectionCounts,
        where: str,
        screening: MakeScreening | None = None,
    ) -> None:
        self.family, self.form, self.where, self.screening = family, form, where, screening
        self.asked = list(asked)
        self.tally = tally
        self.names = sorted(form.parameters)
        self.poses = form.pose.frames()
        self.order = motion_order(self.asked)
        self._most = MAX_FRIENDLY_ATTEMPTS if form.friendly else MAX_ATTEMPTS
        self._at_once = max(1, min(_MOST_AT_ONCE, _POINTS_AT_ONCE // len(form.points)))
        self._made = self._looked_at = 0  # attempts, and those of them that were examined

    def run(self, streams: Sequence[Stream], done: Sequence[int]) -> list[Variant]:
        """The first valid attempt of each stream after the attempts already used.

        Raises VerificationError if the two computations disagree on one of them.
        """
        found = self.first(streams, done)
        agrees = verification(solve_variants(found, self.order), self.order)
        if not np.all(agrees):
            wrong = int(np.flatnonzero(~agrees)[0])
            raise self._disagreement(found[wrong], streams[wrong])
        return found

    def first(self, streams: Sequence[Stream], done: Sequence[int]) -> list[Variant]:
        """The first attempt of each stream that passes all screens, not yet verified.

        Raises InputError where so many attempts fail that more of them are hopeless.
        """
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
            attempts = self.attempts(words, owner, number)
            for variant, i in self._accepted(attempts):
                found[i] = variant
            used[pending] += chunk
            pending = [i for i in pending if i not in found]
            chunk = min(2 * chunk, 2048, max(_CHUNK, self._at_once // max(1, len(pending))))
            if pending and (self._is_hopeless(len(found)) or min(used[pending] - np.array(done)[pending]) > self._most):
                raise InputError(self._exhausted)
        return [found[i] for i in range(len(streams))]

    def _is_hopeless(self, found: int) -> bool:
        """Whether so many attempts were in vain that more of them would be, for whomever."""
        return self._made > _HOPELESS * self._most * (1 + found) or self._looked_at > _HOPELESS_JUDGED * (1 + found)

    def attempts(self, words: NDArray[np.uint64], owner: NDArray[np.int64], number: NDArray[np.int64]) -> Attempts:
        """Attempts of random words, shape (N, 1 + parameters): a word for the pose, one for each parameter."""
        index = {
            name: index_below(words[:, i + 1], len(self.form.parameters[name].printed))
            for i, name in enumerate(self.names)
        }
        ties = self.form.ties
        if ties:
            row = index_below(words[:, 1 + self.names.index(ties.names[0])], len(ties.rows))
            index |= {name: place[row] for name, place in ties.places(self.form.parameters).items()}
        return Attempts(index, index_below(words[:, 0], len(self.poses)), owner, number)

    def si(self, attempts: Attempts) -> dict[str, NDArray[np.float64]]:
        """The parameters of attempts in SI, shape (N,) each."""
        return {name: self.form.parameters[name].si[i] for name, i in attempts.index.items()}

    def frame(self, attempts: Attempts) -> Frame:
        """How attempts lie on paper."""
        poses = np.array(self.poses)[attempts.pose]
        return frame(poses[:, 0], poses[:, 1])

    def _accepted(self, attempts: Attempts) -> Iterator[tuple[Variant, int]]:
        """First acceptable attempt of each owner; later ones are looked at only if earlier ones fail.

        Where few owners are left, several attempts of each are looked at together: a batch costs more than its size.
        """
        promising = self._promising(attempts)
        while promising.owner.size:
            size, begin = promising.owner.size, starts(promising.owner)
            rank = np.arange(size) - np.repeat(begin, np.diff(begin, append=size))
            chosen = np.flatnonzero(rank < max(1, min(_AHEAD, _AT_LEAST // begin.size)))
            heads = promising.take(chosen)
            good = np.flatnonzero(self._conditioned(heads))
            accepted = self._screened(heads.take(good)) if self.screening else self._firsts(heads.take(good))
            accepted_owners = []
            for variant, owner in accepted:
                accepted_owners.append(owner)
                yield variant, owner
            left = ~np.isin(promising.owner, accepted_owners)
            left[chosen] = False
            promising = promising.take(np.flatnonzero(left))

    def many(self, stream: Stream, count: int, by_hand: bool = False) -> Attempts:
        """The first attempts of one stream that pass all screens, so many, in their order.

        The screening's expensive screens, which need an object for each attempt, are used only ``by_hand``. Raises
        InputError where so many attempts fail that more of them are hopeless.
        """
        width, done, chunk = len(self.names) + 1, 0, min(self._at_once, max(_AT_LEAST, 8 * count))
        found: list[Attempts] = []
        have = 0
        while have < count:
            words, number = stream.words(chunk * width).reshape(-1, width), np.arange(done + 1, done + chunk + 1)
            passed = self._passed(self.attempts(words, number, number), by_hand)
            found.append(passed)
            have, done = have + passed.number.size, done + chunk
            if have < count and self._is_hopeless(have):
                raise InputError(self._exhausted)
            chunk = min(self._at_once, max(_AT_LEAST, round(1.1 * (count - have) * done / max(1, have))))
        return joined(found).take(np.arange(count))

    def _passed(self, attempts: Attempts, by_hand: bool) -> Attempts:
        """Those of the attempts, each of an owner of its own, that pass all screens."""
        left = self.valid(attempts)
        if self.screening is None or not left.number.size:
            return left
        assert left.motion is not None, "valid attempts are solved"
        screening = self.screening(self.form, self.si(left), self.frame(left), self.asked, left.motion)
        places = self._keep(screening.of_all(), left.number.size)
        if by_hand and places.size:
            variants = [self.variant(left, place) for place in places.tolist()]
            places = places[self._keep(screening.of_survivors(variants, places.tolist()), places.size)]
        return left.take(places)

    def valid(self, attempts: Attempts) -> Attempts:
        """The attempts that pass the screens of the form, with their motion."""
        promising = self._promising(attempts)
        return promising.take(np.flatnonzero(self._conditioned(promising))) if promising.owner.size else promising

    def _promising(self, attempts: Attempts) -> Attempts:
        """Attempts that pass the cheap screens, in order."""
        self.tally.attempts += attempts.owner.size
        self._made += attempts.owner.size
        parameters = self.si(attempts)
        values = self.form.values(parameters)
        passed = self._keep(parameter_screens(self.form, values, attempts.owner.size), attempts.owner.size)
        attempts = attempts.take(passed)
        if not attempts.owner.size:
            return attempts
        values = self.form.values(self.si(attempts))
        motion = solve(self.form.scene(values, self.frame(attempts)), 0, self.form.plan)
        passed = self._keep(position_screens(self.form, motion, values), attempts.owner.size)
        attempts = attempts.take(passed)
        if not attempts.owner.size:
            return attempts
        motion = add_speeds(motion.take(passed), self.form.plan, self.order)
        attempts = replace(attempts, motion=motion)
        of_instant = [quantity for quantity in self.asked if not quantity.is_of_interval]
        attempts = attempts.take(self._keep(motion_screens(self.form, motion, of_instant), attempts.owner.size))
        for screens in (self._friendly, self._clear_in_time):
            if attempts.owner.size:
                assert attempts.motion is not None, "it was put in above"
                attempts = attempts.take(self._keep(screens(attempts.motion), attempts.owner.size))
        return attempts

    def _friendly(self, motion: Motion) -> dict[str, NDArray[np.bool_]]:
        nice = friendly_answers(motion, self.asked, self.family.length_unit) if self.form.friendly else None
        return {} if nice is None else {"hand-friendly answers": nice}

    def _clear_in_time(self, motion: Motion) -> dict[str, NDArray[np.bool_]]:
        """The screens of values of an interval of time: the last, as each needs the motion all through it."""
        return clear_answers(self.form, motion, [quantity for quantity in self.asked if quantity.is_of_interval])

    def _conditioned(self, attempts: Attempts) -> NDArray[np.bool_]:
        """Whether the answers are well conditioned."""
        motion = attempts.motion
        assert motion is not None, "only promising attempts come here, and these are solved"
        sensitivities = sensitivity(self.form, self.si(attempts), self.frame(attempts), self.asked, motion)
        good = sensitivities <= self.form.screens.sensitivity * (1 + 1e-6)
        self.tally.rejected["answers well conditioned"] += int(np.count_nonzero(~good))
        return good

    def _firsts(self, attempts: Attempts) -> Iterator[tuple[Variant, int]]:
        """The first attempt of each owner."""
        for place in starts(attempts.owner).tolist() if attempts.owner.size else []:
            yield self.variant(attempts, place), int(attempts.owner[place])

    def _screened(self, attempts: Attempts) -> Iterator[tuple[Variant, int]]:
        """The first attempt of each owner that passes the screening.

        The expensive screens see one attempt of each owner at a time.
        """
        assert self.screening is not None
        assert attempts.motion is not None
        if not attempts.owner.size:
            return
        screening = self.screening(self.form, self.si(attempts), self.frame(attempts), self.asked, attempts.motion)
        left = self._keep(screening.of_all(), attempts.owner.size)
        while left.size:
            owner = attempts.owner[left]
            firsts = starts(owner)
            places = left[firsts].tolist()
            variants = [self.variant(attempts, place) for place in places]
            passed = self._keep(screening.of_survivors(variants, places), len(places))
            self._looked_at += len(places)
            for i in passed.tolist():
                yield variants[i], int(owner[firsts[i]])
            later = ~np.isin(owner, owner[firsts[passed]])
            later[firsts] = False
            left = left[later]

    def _disagreement(self, variant: Variant, stream: Stream) -> VerificationError:
        """What to say of a variant on which the two computations disagree: its key and its data."""
        data = ", ".join(f"{name}={value}" for name, value in variant.printed.items())
        key = ", ".join(str(part) for part in stream.parts[:-1])
        return VerificationError(
            f"{self.family.name}: the solver and the independent computation disagree"
            f" (seed, student, problem: {key}) for {data}"
        )

    def _keep(self, screens: Mapping[str, NDArray[np.bool_]], size: int) -> NDArray[np.int64]:
        alive = np.ones(size, dtype=bool)
        for name, passed in screens.items():
            self.tally.rejected[name] += int(np.count_nonzero(alive & ~passed))
            alive &= passed
        return np.flatnonzero(alive)

    @property
    def _exhausted(self) -> Problem:
        return no_valid_variant(self.form, self.tally, self.where)

    def variant(self, attempts: Attempts, i: int) -> Variant:
        """One of the attempts."""
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
