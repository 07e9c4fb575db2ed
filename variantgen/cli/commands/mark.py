"""``variantgen mark``: from the answers of a class to marks."""

from __future__ import annotations

import argparse
import json
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from variantgen.cli.messages import counted, say, tell
from variantgen.cli.options import add_built_folder, add_families
from variantgen.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from variantgen.exam.sections.marking_policy import MarkingPolicy
    from variantgen.finished.restore import Finished
    from variantgen.marking.answer_tables import NotMatched, ReadAnswers
    from variantgen.marking.changes import Change, Earlier
    from variantgen.marking.marks import Marked
    from variantgen.marking.scan.joining import Joined

HELP = "mark the answers that a class has handed in"
DESCRIPTION = (
    "Mark the answers to a finished exam: tables (CSV, XLSX) with columns  student, problem, quantity, answer,  or\n"
    "student, 1.v_B, 1.omega_AB, ...,  or the filled grading.xlsx. Students are named by the code of the sheet, by id\n"
    "or name. Scans (PDF, JPEG, PNG, TIFF) are pages for answers, which a build with  [answers] scan = true  prints.\n"
    "What is wrong is compared with plausible mistakes. Several files add up; what cannot be matched or read\n"
    "is listed, and nothing is guessed."
)
_SHOWN, _LONGEST = 20, 120  # of what is told: items, characters of a text
_BOOK = "marks.xlsx"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add_built_folder(parser)
    parser.add_argument(
        "answers", metavar="ANSWERS", type=Path, nargs="+", help="tables with the answers, scans, photos"
    )
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder for the marks")
    parser.add_argument("--force", action="store_true", help="replace an earlier marking")
    parser.add_argument("--policy", type=Path, metavar="FILE", help="what answers are worth (TOML)")
    parser.add_argument(
        "--columns", type=Path, metavar="FILE", help='what heads of tables stand for (TOML): "Speed of B" = "1.v_B"'
    )
    parser.add_argument(
        "--against",
        type=Path,
        metavar="DIR",
        help="an earlier marking: say whose mark changed (usual: the one replaced)",
    )
    parser.add_argument("--anonymous", action="store_true", help="leave out ids, names and groups: codes only")
    parser.add_argument(
        "--steps", action="store_true", help="feedback has the steps of the worked solution that wrong answers need"
    )
    parser.add_argument("--json", action="store_true", help="the marks as one JSON document on stdout")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Mark the class."""
    from variantgen.exam.manifest import read_manifest
    from variantgen.exam.sections.marking_policy import read_policy_file
    from variantgen.families.reading.folders import family_folders
    from variantgen.finished.restore import restore_unchanged
    from variantgen.marking.changes import changes
    from variantgen.marking.key import Key
    from variantgen.marking.marks import mark
    from variantgen.marking.records import without_words
    from variantgen.outputs.files.folder import check_free

    check_free(arguments.out, arguments.force, _known_files)
    finished = restore_unchanged(read_manifest(arguments.folder), family_folders(arguments.families))
    asked = Key(finished.record).asked
    policy = read_policy_file(arguments.policy, asked) if arguments.policy else finished.exam.marking
    earlier = _earlier(arguments.against, arguments.out, {sheet.code for sheet in finished.record.sheets})
    finished, read, joined = _read(arguments, finished, policy)
    found = mark(finished, read, policy)
    if arguments.anonymous:
        found = without_words(found)
    changed = None if earlier is None else changes(finished.record, found, earlier)
    written = _write(arguments, finished, found, policy, changed, joined)
    if arguments.json:
        say(_json(found, arguments.anonymous))
    _tell(arguments, finished, found, changed, written)
    return 0


def _known_files() -> Sequence[str]:
    """All files that a marking may have."""
    from variantgen.marking import changes, gradebooks, pages, records
    from variantgen.marking.scan import review

    return (*records.FILES, *pages.FILES, *gradebooks.FILES, changes.CHANGES, *review.FILES, _BOOK)


def _write(
    arguments: argparse.Namespace,
    finished: Finished,
    found: Marked,
    policy: MarkingPolicy,
    changed: Sequence[Change] | None,
    joined: Joined | None,
) -> list[str]:
    """The folder of a marking, whole or not at all; the names of its files."""
    from variantgen.marking.changes import write_changes
    from variantgen.marking.gradebooks import write_gradebooks
    from variantgen.marking.pages import write_pages
    from variantgen.marking.records import write_marks
    from variantgen.marking.scan.review import write_review
    from variantgen.outputs.files.folder import whole_folder

    record, anonymous = finished.record, arguments.anonymous
    with whole_folder(arguments.out, arguments.force, _known_files) as work:
        write_marks(work, record, found, anonymous)
        write_pages(work, finished, found, anonymous, arguments.steps)
        if not anonymous:
            write_gradebooks(work, finished.exam.title, found)
        if _can_write_book():
            from variantgen.marking.marks_book import write_book

            write_book(work / _BOOK, finished.exam, found, policy, anonymous)
        if changed is not None:
            write_changes(work, record, changed, anonymous)
        if joined is not None:
            write_review(work, finished, joined.scans.doubtful, joined.typed, joined.scans.lost, anonymous)
        return sorted(path.name for path in work.iterdir())


def _can_write_book() -> bool:
    """Whether the package is there that writes workbooks."""
    return find_spec("xlsxwriter") is not None


def _tell(
    arguments: argparse.Namespace,
    finished: Finished,
    found: Marked,
    changed: Sequence[Change] | None,
    written: Sequence[str],
) -> None:
    """Say what was marked, what is left to do, and what was written."""
    from variantgen.marking.records import not_matched

    for difference in finished.differences:
        tell(f"not as when the exam was made: {difference}")
    _tell_left(not_matched(found, arguments.anonymous))
    tell(_summary(found))
    _tell_open(found)
    if changed is not None:
        _tell_changes(found, changed)
    if not _can_write_book():
        tell(f'{_BOOK} is left out: it needs XlsxWriter, pip install "variantgen[xlsx]"')
    tell(f"written: {arguments.out}: {', '.join(written)}")


def _read(
    arguments: argparse.Namespace, finished: Finished, policy: MarkingPolicy
) -> tuple[Finished, ReadAnswers, Joined | None]:
    """The exam as it was asked, the answers of tables and scans together, and what the scans hold, if there are any."""
    from variantgen.marking.answer_tables import ReadAnswers, read_answers
    from variantgen.marking.drawn import as_drawn
    from variantgen.marking.form_words import FormWords
    from variantgen.marking.heads import read_columns
    from variantgen.marking.scan.joining import join
    from variantgen.marking.scan.pictures import is_picture
    from variantgen.marking.scan.review import check_readings_kept

    tables = [path for path in arguments.answers if not is_picture(path)]
    scans = [path for path in arguments.answers if is_picture(path)]
    check_readings_kept(arguments.out, tables)
    columns = read_columns(arguments.columns) if arguments.columns else None
    names = {path: f"file {n}" for n, path in enumerate(arguments.answers, 1)} if arguments.anonymous else None
    read = read_answers(tables, FormWords.of(finished.exam), columns, names) if tables else ReadAnswers((), ())
    finished, read = as_drawn(finished, read)
    if not scans:
        return finished, read, None
    joined = join(finished, read, scans, policy, names)
    return finished, joined.answers, joined


def _tell_left(left: Sequence[NotMatched]) -> None:
    """Say what was not matched."""
    for item in left[:_SHOWN]:
        tell(
            f"{item.where}: {item.why}"
            + (f" (got {_short(item.text)})" if item.text else "")
            + (f"\n    {item.remedy}" if item.remedy else "")
        )
    if len(left) > _SHOWN:
        tell(f"and {len(left) - _SHOWN} more, see not_matched.csv")


def _short(text: str) -> str:
    """A text that is not too long to tell: files have the whole one."""
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}..."


def _tell_open(found: Marked) -> None:
    """Say that marks are not final while answers have to be looked at."""
    from variantgen.marking.scan.review import PAGE, TABLE

    if waiting := [total for total in found.totals if total.open]:
        answers = counted(sum(total.open for total in waiting), "answer")
        tell(f"not final: {answers} of {counted(len(waiting), 'student')} to look at in {PAGE};")
        tell(f"    type what you see into {TABLE} and mark again with it")


def _earlier(against: Path | None, out: Path, codes: Collection[str]) -> Earlier | None:
    """The marks to compare with: those that are named, or those that are replaced; None where there are none."""
    from variantgen.marking.changes import read_marking
    from variantgen.marking.records import MARKS

    if against is not None:
        return read_marking(against, codes)
    try:
        return read_marking(out, codes) if (out / MARKS).is_file() else None
    except InputError:
        return None  # whoever replaces a damaged marking has nothing to compare with


def _tell_changes(found: Marked, changed: Sequence[Change]) -> None:
    """Say whose mark is another one."""
    totals = [change for change in changed if not change.answer]
    every = counted(len(found.totals), "student")
    tell(f"marks that are other than before: {len(totals)} of {every}" + (", see changes.csv" if changed else ""))
    for change in totals[:_SHOWN]:
        total = found.totals[change.place]
        grades = f", grade {change.before[0]} -> {change.now[0]}" if change.before[0] != change.now[0] else ""
        tell(f"    {total.code}: {change.before[1] or 'nothing'} -> {change.now[1]}{grades}")
    if len(totals) > _SHOWN:
        tell(f"    and {len(totals) - _SHOWN} more")


def _summary(found: Marked) -> str:
    """How many answers are what."""
    counts: dict[str, int] = {}
    for item in found.marks:
        counts[item.verdict.value] = counts.get(item.verdict.value, 0) + 1
    handed_in = sum(total.handed_in > 0 for total in found.totals)
    by_verdict = ", ".join(f"{name.replace('_', ' ')} {count}" for name, count in counts.items())
    return f"{handed_in} of {counted(len(found.totals), 'student')} handed in; answers: {by_verdict}"


def _json(found: Marked, anonymous: bool) -> str:
    """The sums and what was not matched, as JSON."""
    from msgspec.structs import asdict

    from variantgen.marking.records import not_matched

    students = [
        {
            **({} if anonymous else {"id": total.student.id, "name": total.student.name, "group": total.student.group}),
            "code": total.code,
            "problems": {str(number): float(points) for number, points in total.problems.items()},
            "points": float(total.points),
            "of": float(total.of),
            "grade": total.grade,
            "answers": total.handed_in,
            "open": total.open,
        }
        for total in found.totals
    ]
    return json.dumps(
        {"students": students, "not_matched": [asdict(item) for item in not_matched(found, anonymous)]},
        ensure_ascii=False,
        indent=1,
    )
