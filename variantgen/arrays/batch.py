"""Many variants of one form of a family as arrays (``variantgen.batch``), drawn at the speed of the solver.

The variants of a batch are drawn from one random stream, named by the seed, the family and the form: attempt after
attempt over the grid of the family, of which those that pass the screens stay, in order. So the first variants of a
larger batch are those of a smaller one. A variant of an exam is drawn in the same way, but from a stream of its own
student: the variants of a batch are like those of an exam, and none of them is that of a student.
"""

from __future__ import annotations

import operator
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cached_property
from os import PathLike
from typing import Any, SupportsIndex, overload

import numpy as np
from msgspec import Struct
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.arrays.columns import Columns, as_csv, motion_columns
from variantgen.arrays.whole_number import whole_number
from variantgen.errors import InputError, Problem
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.families.asking import Ask, check_ask, read_ask
from variantgen.families.family import Family, Form
from variantgen.families.form_motion import motion_of
from variantgen.families.parameters.draw_rules import frame
from variantgen.families.quantities import Quantity
from variantgen.families.reading.folders import Folders
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import by_parameter, restrict
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.notebook import display
from variantgen.variants.attempts import FormSampler, VerificationError
from variantgen.variants.batch import Attempts, RejectionCounts
from variantgen.variants.examined import examined
from variantgen.variants.only_variant import only_variant
from variantgen.variants.screening import verification
from variantgen.variants.seeding import Stream
from variantgen.variants.variant import Variant

_LARGEST = 10_000_000


class Batch(Struct, frozen=True, eq=False, dict=True):
    """Variants of one form, solved; every array has the shape (N,) and every mapping is by names.

    ``motion`` has positions (m), velocities and accelerations on paper as complex numbers x + iy, in SI, and rotations
    of bodies; see :class:`variantgen.mechanism.motion.Motion`. ``index`` has the places of the parameters on their
    grids, ``sense`` and ``turns`` how the scenes lie on paper, ``attempt`` which draw of the stream it was.
    """

    family: Family
    form: Form
    asked: tuple[Quantity, ...]
    motion: Motion
    index: Mapping[str, NDArray[np.int64]]
    sense: NDArray[np.int64]
    turns: NDArray[np.int64]
    attempt: NDArray[np.int64]

    @cached_property
    def parameters(self) -> dict[str, Field]:
        """The parameters in printed units (of a choice the number behind the word), shape (N,) each."""
        grids = {name: p.printed for name, p in self.form.parameters.items()}
        return {name: np.array([float(value) for value in grids[name]])[i] for name, i in self.index.items()}

    @cached_property
    def answers(self) -> dict[str, Field]:
        """The answers to what is asked, in printed units, with all digits, shape (N,) each."""
        length = self.family.length_unit
        return {q.name: q.unit(length).from_si(q.value(self.motion)) for q in self.asked}

    @property
    def positions(self) -> Mapping[str, ComplexField]:
        """Positions of the points on paper (m), x + iy, shape (N,) each."""
        return self.motion.z

    @property
    def velocities(self) -> Mapping[str, ComplexField]:
        """Velocities of the points (m/s), x + iy, shape (N,) each."""
        return self.motion.v

    @property
    def accelerations(self) -> Mapping[str, ComplexField]:
        """Accelerations of the points (m/s^2), x + iy, shape (N,) each."""
        return self.motion.a

    @cached_property
    def units(self) -> dict[str, str]:
        """The unit of every column of :meth:`table` that has one, by its name."""
        length = self.family.length_unit
        own = {name: p.unit.name for name, p in self.form.parameters.items() if p.unit is not None}
        moving = {name: unit.name for name, unit in motion_columns(self.motion, length)[1].items()}
        return moving | own | {q.name: q.unit(length).name for q in self.asked}

    def table(self, motion: bool = False) -> Columns:
        """Columns by name, as data frames take them: parameters (choices as words), then answers, in printed units.

        With ``motion`` also places, velocities, accelerations and rotations (:mod:`variantgen.arrays.columns`), but for
        what is a column already.
        """
        found: Columns = {}
        for name, parameter in self.form.parameters.items():
            words = np.array(parameter.words)
            found[name] = words[self.index[name]] if parameter.unit is None else self.parameters[name]
        found |= self.answers
        if motion:
            further, _ = motion_columns(self.motion, self.family.length_unit)
            found |= {name: column for name, column in further.items() if name not in found}
        return found

    def csv(self, motion: bool = False) -> str:
        """The table as CSV with the units in its head."""
        return as_csv(self.table(motion), self.units)

    def __len__(self) -> int:
        return int(self.attempt.size)

    @overload
    def __getitem__(self, number: SupportsIndex) -> Variant: ...
    @overload
    def __getitem__(self, number: slice) -> Batch: ...

    def __getitem__(self, number: SupportsIndex | slice) -> Variant | Batch:
        if isinstance(number, slice):
            return self._part(np.arange(len(self))[number])
        number = operator.index(number)
        if not -len(self) <= number < len(self):
            raise IndexError(f"a batch of {len(self)} variants has none with the number {number}")
        parameters = self.form.parameters
        printed = {name: parameters[name].printed[int(self.index[name][number])] for name in parameters}
        pose = int(self.sense[number]), int(self.turns[number])
        return Variant(self.family, self.form, printed, *pose, int(self.attempt[number]))

    def _part(self, places: NDArray[np.int64]) -> Batch:
        """The variants at these places."""
        return replace(
            self,
            motion=self.motion.take(places),
            index={name: index[places] for name, index in self.index.items()},
            sense=self.sense[places],
            turns=self.turns[places],
            attempt=self.attempt[places],
        )

    def __iter__(self) -> Iterator[Variant]:
        return (self[number] for number in range(len(self)))

    def _repr_html_(self) -> str:
        """What a notebook shows: the first variants as a table."""
        return display("batch_html", self)

    def __repr__(self) -> str:
        form = f" {self.form.name}" if self.form.name else ""
        return f"<Batch of {len(self)} {self.family.name}{form}: {', '.join((*self.form.parameters, *self.answers))}>"


def batch(
    family: str | PathLike[str] | Family,
    n: SupportsIndex,
    seed: object = 0,
    form: str = "",
    ask: Ask | str = None,
    set: Mapping[str, Any] | None = None,  # noqa: A002  (as the option is called)
    range: Mapping[str, Any] | None = None,  # noqa: A002
    *,
    for_sheets: bool = False,
    nice: bool = False,
    units: str = "",
    folders: Folders = (),
) -> Batch:
    """``n`` valid variants of one form of a family, solved, as arrays.

    >>> import variantgen
    >>> rods = variantgen.batch("four_bar", 1000, seed=1, ask=["v_B", "omega_AB"], range={"phi": [30, 60]})
    >>> rods.answers["v_B"].shape, rods.units["v_B"]
    ((1000,), 'cm/s')
    >>> bool((rods.parameters["phi"] <= 60).all())
    True

    ``family`` is a name, a path or a family that is loaded; without ``form`` it is the first of its forms that has what
    is fixed or narrowed (and, for ``nice``, hand-friendly variants). ``set`` fixes parameters, ``range`` narrows them,
    as the options of ``variantgen show`` do (to the lowest and highest value, or to words of a choice; ``range(30,
    61)`` is from 30 to 60); bare numbers are in printed units. The screens are those of the family,
    mistakes that must be seen in the answers among them. What takes the steps of a solution is done only
    ``for_sheets``: a calculation by hand with three digits stays within the family's ceiling, and the independent
    computation confirms every variant; some 0.3 to 3 ms each. Variants may repeat: where nothing is left to draw (a
    scene without parameters, everything fixed) all are that one, as ``variantgen show`` takes it, without the screens
    of a draw (but ``for_sheets``). Raises InputError, and VerificationError where that computation finds something
    else: a defect of the program.
    """
    n = whole_number(n, "n", 1, _LARGEST)
    whole = family if isinstance(family, Family) else load_family(family, folders)
    fixed, ranges = by_parameter(set, "set"), by_parameter(range, "range")
    chosen = form or _first_form(whole, {*fixed, *ranges}, nice)
    narrowed = restrict(whole, fixed, ranges, (chosen,) if chosen else (), nice, True, units)
    if ask is not None:
        check_ask(narrowed, ask, whole)
    only = next(iter(narrowed.forms.values()))
    asked = read_ask(only, ask)
    if only.grid_size == 1 and not for_sheets:
        return _copies(only_variant(narrowed, only, whole.name if whole is family else str(family)), tuple(asked), n)
    sampler = FormSampler(
        narrowed, only, examined(only, asked), RejectionCounts(), f"batch: {whole.name}", AnswerTolerances()
    )
    attempts = sampler.many(Stream("batch", seed, whole.name, only.name), n, for_sheets)
    found = _solved(narrowed, only, tuple(asked), sampler.poses, attempts)
    if for_sheets and not np.all(verification(found.motion, 2)):
        raise VerificationError(f"{whole.name}: the solver and the independent computation disagree (seed {seed})")
    return found


def _first_form(family: Family, named: Collection[str], nice: bool) -> str:
    """The first form that has parameters of these names; the very first where none has, to say so."""
    forms = (family.nice_forms if nice else []) or list(family.forms)
    return next((form for form in forms if all(name in family.forms[form].parameters for name in named)), forms[0])


def _copies(variant: Variant, asked: tuple[Quantity, ...], n: int) -> Batch:
    """A batch of one variant, so many times. Raises InputError where it is not solved."""
    zeros = np.zeros(n, np.int64)
    parameters = variant.form.parameters
    index = {name: zeros + parameters[name].printed.index(value) for name, value in variant.printed.items()}
    attempts = Attempts(index, zeros, zeros, np.arange(1, n + 1))
    found = _solved(variant.family, variant.form, asked, [(variant.sense, variant.turns)], attempts)
    if not found.motion.solved[0]:
        outcome = Outcome(int(found.motion.outcome[0]))
        raise InputError(Problem(outcome.text, key="motion", value=variant.family.name))
    return found


def _solved(
    family: Family, form: Form, asked: tuple[Quantity, ...], poses: Sequence[tuple[int, int]], attempts: Attempts
) -> Batch:
    """The batch of attempts, solved."""
    sense, turns = np.array(poses)[attempts.pose].T
    parameters = {name: form.parameters[name].si[i] for name, i in attempts.index.items()}
    motion = motion_of(form, parameters, frame(sense, turns))
    return Batch(family, form, asked, motion, attempts.index, sense, turns, attempts.number)
