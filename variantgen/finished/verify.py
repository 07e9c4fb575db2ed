"""Verification of a finished exam from its manifest alone: every answer is computed again by the independent path.

The variants are taken from the manifest; the motion is found by closing the chain of joints anew at moved instants and
differentiating numerically (:mod:`variantgen.mechanism.verification.verify`), which shares nothing with the solver.
"""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice, tee, zip_longest
from pathlib import Path

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.exam.manifest import NAME, Manifest, RecordedAnswer, RecordedProblem, RecordedSheet
from variantgen.families.asking import read_ask
from variantgen.families.quantities import Quantity, motion_order
from variantgen.finished.restore import Finished
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.verification.verify import recompute
from variantgen.outputs.files.edited import EDITED, file_hash, is_meant
from variantgen.outputs.files.folder import file_hashes
from variantgen.outputs.files.records import KEY, RECORDED, recorded_rows
from variantgen.variants.variant import Variant, solve_variants

# Of an answer's size, or of the largest speed (acceleration) of the mechanism: numbers of the key have eight digits,
# and the differentiation is good to about 1e-9 of the largest.
_RELATIVE, _OF_LARGEST = 1e-6, 1e-7
_AT_ONCE = 512  # students whose motions are in memory together


class VerificationReport(Struct, frozen=True):
    """The result of a verification: answers computed again, largest relative difference, faults in words.

    ``edited`` are the files that were changed since the build and are there to be edited: no fault.
    """

    students: int
    answers: int
    largest: float
    faults: tuple[str, ...]
    edited: tuple[str, ...] = ()


def verify(finished: Finished, folder: Path) -> VerificationReport:
    """Compute every answer again and look whether the files are as they were built."""
    faults, edited = _files(finished, folder)
    faults += _students(finished.record) or _key(finished.record, folder)
    largest, count = 0.0, 0
    sheets, same = tee(replace(sheet, problems=tuple(sheet.problems)) for sheet in finished.record.sheets)
    pairs = zip(sheets, finished.variants(same), strict=True)
    while some := list(islice(pairs, _AT_ONCE)):
        for who, answer, again, scale in _recomputed(finished, some):
            count += 1
            if answer is None or again is None:
                faults.append(f"{who}: the key does not answer what the exam asks")
                continue
            difference = _difference(answer, again)
            allowed = max(_RELATIVE * abs(again), _OF_LARGEST * scale)
            if not difference <= allowed:
                faults.append(
                    f"{who}: {answer.quantity} is {answer.value:.8g} {answer.unit} in the "
                    f"manifest, {again:.8g} by the independent path"
                )
            elif again:
                largest = max(largest, difference / max(abs(again), _OF_LARGEST / _RELATIVE * scale))
    return VerificationReport(len(finished.record.sheets), count, largest, tuple(faults), tuple(edited))


def _difference(answer: RecordedAnswer, again: float) -> float:
    """The difference of two values; directions may differ by a full turn."""
    plain = abs(answer.value - again)
    return min(plain, abs(plain - 360.0)) if answer.unit == "deg" else plain


Compared = tuple[str, RecordedAnswer | None, float | None, float]


def _recomputed(finished: Finished, sheets: Sequence[tuple[RecordedSheet, Sequence[Variant]]]) -> Iterator[Compared]:
    """Student and problem, the answer of the manifest, the value again, the largest of its kind.

    Where the manifest has not the answers that the exam asks, both are None.
    """
    groups: dict[tuple[int, int], list[tuple[str, RecordedProblem, Variant]]] = {}
    for sheet, own in sheets:
        if len(own) < len(sheet.problems):
            continue  # a variant that cannot be, which is said in the end
        for problem, variant in zip(sheet.problems, own, strict=True):
            who = f"student {sheet.student.id}, problem {problem.number}"
            groups.setdefault((id(variant.form), problem.number), []).append((who, problem, variant))
    for members in groups.values():
        variants = [variant for *_, variant in members]
        task = next(task for task in finished.exam.tasks if task.number == members[0][1].number)
        asked = read_ask(variants[0].form, task.ask)
        motion, values, scales = independent(variants, asked)
        names = [(q.name, q.unit(variants[0].family.length_unit).name) for q in asked]
        for i, (who, problem, _) in enumerate(members):
            if [(a.quantity, a.unit) for a in problem.answers] != names or not motion.solved[i]:
                yield who, None, None, 0.0
                continue
            for k, answer in enumerate(problem.answers):
                yield who, answer, float(values[k][i]), float(scales[k][i])


def independent(variants: Sequence[Variant], asked: Sequence[Quantity]) -> tuple[Motion, np.ndarray, np.ndarray]:
    """The motion, and the values of the asked quantities by the independent path, in printed units, shape (answers, N).

    The last table has the largest value of the kind in the mechanism, in the same unit (of an angle 180°).
    """
    order = motion_order(asked)
    motion = solve_variants(variants, order)
    found = recompute(motion)
    again = replace(
        motion,
        v={**motion.v, **found.v},
        omega={**motion.omega, **found.omega},
        a={**motion.a, **found.a} if order > 1 else motion.a,
        epsilon={**motion.epsilon, **found.epsilon} if order > 1 else motion.epsilon,
    )
    length = variants[0].family.length_unit
    values, scales = [], []
    for quantity in asked:
        unit = quantity.unit(length)
        values.append([unit.from_si(float(x)) for x in quantity.value(again)])
        scales.append([unit.from_si(float(x)) for x in _largest(quantity, motion)])
    return motion, np.array(values), np.array(scales)


def _largest(quantity: Quantity, motion: Motion) -> np.ndarray:
    """The largest rate or vector of the kind of a quantity, SI, shape (N,)."""
    if quantity.is_angle:
        return np.full(motion.size, np.pi)
    if quantity.component == "sense":
        return np.zeros(motion.size)
    if quantity.is_length or quantity.group in ("ratio", "turn"):
        return np.abs(quantity.value(motion))
    points = (motion.v if quantity.order == 1 else motion.a).values()
    largest = np.max([np.abs(x) for x in points], axis=0)
    return np.asarray(largest / motion.length_scale() if quantity.is_rotation else largest)


def _students(record: Manifest) -> list[str]:
    """Codes and ids that several students have, and that the entries of students are not as they were built."""
    faults = [
        f"{NAME}: {count} students have the {what} {value}"
        for what, values in (
            ("id", Counter(sheet.student.id for sheet in record.sheets)),
            ("code", Counter(sheet.code for sheet in record.sheets)),
        )
        for value, count in values.items()
        if count > 1
    ]
    if record.students_changed:
        faults.append(f"{NAME}: the students have been changed since the build; restore it from a copy")
    return faults


def _key(record: Manifest, folder: Path) -> list[str]:
    """The first entry of ``key.csv``, as it was built, that is not in the manifest: an entry was edited there."""
    path = folder / KEY
    if not path.is_file() or file_hash(path) != record.files.get(KEY):
        return []  # which is said
    with path.open(encoding="utf-8-sig", errors="replace", newline="") as file:
        rows = csv.reader(file)
        shared = next(rows, [])[: len(RECORDED)]
        if tuple(shared) != RECORDED:
            return []  # of another version
        for row, own in zip_longest(rows, recorded_rows(record.sheets)):
            if row is None or own is None or row[: len(RECORDED)] != own:
                who = (row or own or ["?"])[0]
                return [f"{NAME}: the students have been changed since the build; {KEY} has others from {who} on"]
    return []


def _files(finished: Finished, folder: Path) -> tuple[list[str], list[str]]:
    """What is not as it was built: faults (files that are missing, damaged or new), and files that were edited."""
    now = {
        name: hashed
        for name, hashed in file_hashes(folder).items()
        if name != NAME and not name.startswith(f"{EDITED}/")
    }
    then = finished.record.files
    changed = {name for name, hashed in now.items() if then.get(name, hashed) != hashed}
    faults, edited = [], []
    for name in sorted(then.keys() | now.keys()):
        if name not in now:
            faults.append(f"{name}: the file is missing")
        elif name not in then:
            faults.append(f"{name}: the file does not belong to the exam")
        elif name in changed and is_meant(folder, name, changed):
            edited.append(name)
        elif name in changed:
            faults.append(f"{name}: the file has been changed since the build")
    return faults, edited
