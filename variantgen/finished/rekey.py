"""Another marking for sheets that are printed already: a new key, and whatever else shows tolerances.

The variants are those of the manifest, and neither their numbers nor the sheets and solutions are touched. What shows
tolerances is made again: ``key.csv``, ``manifest.json``, the keys on paper, the workbooks, the files for platforms. The
folder is replaced as a whole, or not at all; files that somebody has worked in are kept (``edited/N``).
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.exam.content import Content
from variantgen.exam.exam import Exam, with_floors
from variantgen.exam.manifest import NAME
from variantgen.exam.sections.tolerance import LARGEST
from variantgen.exam.sheets import Sheet
from variantgen.finished.restore import Finished
from variantgen.outputs.files.edited import EDITED
from variantgen.outputs.files.folder import file_hashes, whole_folder
from variantgen.outputs.files.records import key_rows, manifest_head, manifest_lines, write_key_csv, write_manifest
from variantgen.outputs.formats import STUDENTS_PER_PART, Chunk, Fragment, WholeExam, format_of
from variantgen.outputs.typst.typesetter import Typesetter

_EVERYTHING = ("*",)  # whatever is in the folder stays there
_AT_ONCE = 512  # students whose answers are computed together
_SHOWN = 3


class RekeyResult(Struct, frozen=True):
    """A new key: the number of answers, of those with another tolerance, the files made again, messages."""

    answers: int
    changed: int
    files: tuple[str, ...]
    notes: tuple[str, ...]


def marking(exam: Exam, floors: Mapping[int | None, float], ceiling: float | None = None) -> Exam:
    """The exam with other tolerances; ``floors`` by the number of a problem, None for those without one of their own.

    The ceiling of the build is kept as long as it can be one. Raises InputError for numbers that cannot be.
    """
    if not floors and ceiling is None:
        remedy = "for example  --tolerance 0.02, or  --tolerance 3=0.05  for problem 3 alone"
        raise InputError(Problem("expected another tolerance or ceiling", key="--tolerance", remedy=remedy))
    numbers = [task.number for task in exam.tasks]
    for number, floor in floors.items():
        if not 0 < floor <= LARGEST:
            given = f"{floor:g}"
            raise InputError(Problem(f"expected a number between 0 and {LARGEST:g}", key="--tolerance", value=given))
        if number is not None and number not in numbers:
            remedy = f"the problems are {', '.join(map(str, numbers))}"
            raise InputError(
                Problem("the exam has no such problem", key="--tolerance", value=str(number), remedy=remedy)
            )
    found = with_floors(exam, floors)
    if ceiling is None:
        return found
    low = found.tolerance.floor
    if not low <= ceiling <= LARGEST:
        expected = f"expected a number between the tolerance, {low:g}, and {LARGEST:g}"
        raise InputError(Problem(expected, key="--ceiling", value=f"{ceiling:g}"))
    return replace(found, tolerance=replace(found.tolerance, ceiling=ceiling))


def rekey(finished: Finished, folder: Path, exam: Exam, engine: Typesetter) -> RekeyResult:
    """Give the finished exam in a folder other tolerances, those of ``exam`` (see :func:`marking`).

    Raises InputError if an answer would need more than a new ceiling, or if this program computes other answers than
    the manifest has, ToolMissingError where a format needs something that is not installed; then nothing is written.
    """
    before = finished.record
    for name in exam.formats:
        format_of(name).check(exam, [sheet.student for sheet in before.sheets])
    again = Finished(before, exam, finished.differences)
    sheets = [sheet for places in _places(len(before.sheets)) for sheet in again.sheets(places, marked=True)]
    changed = _compare(finished, sheets)
    ceiling = exam.tolerance.ceiling
    if ceiling is not None and ceiling != finished.exam.tolerance.ceiling:
        _check_ceiling(sheets, ceiling)
    notes: list[str] = []
    renewed: set[str] = set()
    with whole_folder(folder, True, lambda: _EVERYTHING, notes, renewed) as work:
        fresh, parts = work / ".fresh", work / ".parts"
        fresh.mkdir()
        parts.mkdir()
        made = _Making(again, sheets, engine, fresh, parts, notes)
        for name in exam.formats:
            made.format(name)
        write_key_csv(fresh / "key.csv", made.pieces("csv", (key_rows(part).encode() for part in _parts(sheets))))
        new = file_hashes(fresh)
        rest = {name: hashed for name, hashed in before.files.items() if name not in new}
        lines = (manifest_lines(exam, part).encode() for part in _parts(sheets))
        hashes = dict(sorted({**rest, **new}.items()))
        head = manifest_head(exam, before.made_with, before.redrawn, before.pages, hashes, before.bands)
        write_manifest(fresh / NAME, head, made.pieces("json", lines))
        renewed |= {*new, NAME}
        _put_together(folder, fresh, work, renewed)
        shutil.rmtree(fresh)
        shutil.rmtree(parts)
    count = sum(len(item.answers) for sheet in sheets for item in sheet.items)
    return RekeyResult(count, changed, tuple(sorted(renewed)), tuple(notes))


def _places(count: int) -> Iterator[range]:
    return (range(start, min(start + _AT_ONCE, count)) for start in range(0, count, _AT_ONCE))


def _parts(sheets: Sequence[Sheet]) -> Iterator[Sequence[Sheet]]:
    """The students by parts, as a build makes them."""
    return (sheets[start : start + STUDENTS_PER_PART] for start in range(0, len(sheets), STUDENTS_PER_PART))


def _compare(finished: Finished, sheets: Sequence[Sheet]) -> int:
    """How many answers have another tolerance. Raises InputError where there are other answers."""
    other, changed = [], 0
    for sheet, recorded in zip(sheets, finished.record.sheets, strict=True):
        for item, problem in zip(sheet.items, recorded.problems, strict=True):
            now = [(answer.quantity.name, answer.unit.name, answer.value) for answer in item.answers]
            if now != [(answer.quantity, answer.unit, answer.value) for answer in problem.answers]:
                other.append(f"student {sheet.student.id}, problem {problem.number}")
                continue
            pairs = zip(item.answers, problem.answers, strict=True)
            changed += sum(answer.tolerance != old.tolerance for answer, old in pairs)
    if other:
        more = f" and {len(other) - _SHOWN} more" if len(other) > _SHOWN else ""
        version = finished.record.made_with.get("program", "?")
        raise InputError(
            Problem(
                "this program computes other answers than the manifest has",
                file=str(finished.record.path),
                value="; ".join(other[:_SHOWN]) + more,
                remedy=f"look what  variantgen verify  says; the exam was made by version {version}",
            )
        )
    return changed


def _check_ceiling(sheets: Iterable[Sheet], ceiling: float) -> None:
    """Raise InputError if an answer needs more."""
    above = [
        (answer.relative_tolerance, f"{answer.quantity.name} of student {sheet.student.id}, problem {item.task.number}")
        for sheet in sheets
        for item in sheet.items
        for answer in item.answers
        if answer.relative_tolerance > ceiling * (1 + 1e-9)
    ]
    if above:
        most, whose = max(above)
        raise InputError(
            Problem(
                f"on the printed sheets {len(above)} answers need more, the most, {100 * most:.3g} %, {whose}",
                key="--ceiling",
                value=f"{ceiling:g}",
                remedy="raise the ceiling, or leave it out: printed sheets cannot be drawn again",
            )
        )


def _put_together(folder: Path, fresh: Path, work: Path, names: Set[str]) -> None:
    """The new folder: what was made anew, all the rest as it is (what was kept before comes along by itself).

    Files are not copied where a second name for them will do: the old folder goes.
    """
    skipped = {folder / name for name in (*names, EDITED)}

    def left_out(place: str, inside: list[str]) -> list[str]:
        return [name for name in inside if Path(place) / name in skipped]

    shutil.copytree(folder, work, symlinks=True, ignore=left_out, copy_function=_link, dirs_exist_ok=True)
    for name in sorted(names):
        (work / name).parent.mkdir(parents=True, exist_ok=True)
        (fresh / name).rename(work / name)


def _link(source: str, target: str) -> None:
    """The same file under a second name, or a copy of it."""
    if not Path(source).is_symlink():
        try:
            os.link(source, target)
            return
        except OSError:
            pass  # the file system has no second names, or these are on two of them
    shutil.copy2(source, target, follow_symlinks=False)


class _Making:
    """Makes the files of formats in a folder, of pieces in another one."""

    def __init__(
        self,
        finished: Finished,
        sheets: Sequence[Sheet],
        engine: Typesetter,
        folder: Path,
        parts: Path,
        notes: list[str],
    ) -> None:
        self._exam = finished.exam
        self._sheets, self._engine, self._folder, self._notes = sheets, engine, folder, notes
        self._parts, self._count = parts, 0
        places = reversed(list(enumerate(sheets)))
        self._begun = {sheet.student.group: place for place, sheet in places}  # the first student of each group

    def format(self, name: str) -> None:
        """Those files of a format that show tolerances."""
        module = format_of(name)
        found: dict[str, list[Path]] = {}
        if module.write_key is None:
            self._collect(found, (piece for part in self._of(1) for piece in module.make(part)))
        for size, make in module.SUMMARIES:
            self._collect(found, (piece for part in self._of(size) for piece in make(part)))
        whole = WholeExam(self._exam, self._sheets, self._folder, self._engine, found, self._notes)
        (module.write_key or module.finish)(whole)

    def pieces(self, ending: str, contents: Iterable[bytes]) -> list[Path]:
        """Contents as files, in their order."""
        return [self._file(content, f".{ending}") for content in contents]

    def _of(self, parts: int) -> Iterator[Chunk]:
        """So many parts of a build together."""
        step = parts * STUDENTS_PER_PART
        for start in range(0, len(self._sheets), step):
            content = Content(self._exam, self._sheets[start : start + step])
            beginning = frozenset(group for group, place in self._begun.items() if start <= place < start + step)
            yield Chunk(content, start == 0, self._engine, beginning)

    def _collect(self, found: dict[str, list[Path]], made: Iterable[Fragment]) -> None:
        for piece in made:
            found.setdefault(piece.target, []).append(self._file(piece.content, piece.ending))

    def _file(self, content: bytes, ending: str) -> Path:
        path = self._parts / f"{self._count:07}{ending}"
        self._count += 1
        path.write_bytes(content)
        return path
