"""``variantgen mark``: from the answers of a class to marks."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING

from variantgen.cli.messages import counted, say, tell
from variantgen.cli.options import add_families

if TYPE_CHECKING:
    from variantgen.marking.marks import Marked

HELP = "mark the answers that a class has handed in"
DESCRIPTION = (
    "Mark the answers to a finished exam: tables (CSV, XLSX) with columns  student, problem, quantity, answer,  or\n"
    "student, 1.v_B, 1.omega_AB, ...,  or the filled grading.xlsx. Students are named by the code of the sheet, by id\n"
    "or name. What is wrong is compared with plausible mistakes. Several files add up; what cannot be matched or read\n"
    "is listed, and nothing is guessed."
)
_SHOWN = 20


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("folder", metavar="OUT_DIR", type=Path, help="folder that  variantgen build  has made")
    parser.add_argument("answers", metavar="ANSWERS", type=Path, nargs="+", help="tables with the answers")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder for the marks")
    parser.add_argument("--force", action="store_true", help="replace an earlier marking")
    parser.add_argument("--policy", type=Path, metavar="FILE", help="what answers are worth (TOML)")
    parser.add_argument("--anonymous", action="store_true", help="leave out ids, names and groups: codes only")
    parser.add_argument("--json", action="store_true", help="the marks as one JSON document on stdout")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Mark the class."""
    from variantgen.exam.manifest import read_manifest
    from variantgen.exam.marking_policy import read_policy_file
    from variantgen.families.folders import family_folders
    from variantgen.finished.restore import restore
    from variantgen.marking.answer_tables import FormWords, read_answers
    from variantgen.marking.key import Key
    from variantgen.marking.marks import mark
    from variantgen.marking.pages import FILES as PAGES
    from variantgen.marking.pages import write_pages
    from variantgen.marking.records import FILES, not_matched, write_marks
    from variantgen.outputs.files.folder import check_free, whole_folder

    known = (*FILES, *PAGES)
    check_free(arguments.out, arguments.force, lambda: known)
    finished = restore(read_manifest(arguments.folder), family_folders(arguments.families))
    asked = Key(finished.record).asked
    policy = read_policy_file(arguments.policy, asked) if arguments.policy else finished.exam.marking
    found = mark(finished, read_answers(arguments.answers, FormWords.of(finished.exam)), policy)
    with whole_folder(arguments.out, arguments.force, lambda: known) as work:
        write_marks(work, finished.record, found, arguments.anonymous)
        write_pages(work, finished, found, arguments.anonymous)
    if arguments.json:
        say(_json(found, arguments.anonymous))
    for difference in finished.differences:
        tell(f"not as when the exam was made: {difference}")
    left = not_matched(found, arguments.anonymous)
    for item in left[:_SHOWN]:
        tell(
            f"{item.where}: {item.why}"
            + (f" (got {item.text})" if item.text else "")
            + (f"\n    {item.remedy}" if item.remedy else "")
        )
    if len(left) > _SHOWN:
        tell(f"and {len(left) - _SHOWN} more, see not_matched.csv")
    tell(_summary(found))
    tell(f"written: {arguments.out}: {', '.join((*FILES, *PAGES))}")
    return 0


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
    from dataclasses import asdict

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
        }
        for total in found.totals
    ]
    return json.dumps(
        {"students": students, "not_matched": [asdict(item) for item in not_matched(found, anonymous)]},
        ensure_ascii=False,
        indent=1,
    )
