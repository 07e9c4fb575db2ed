"""The answers of scans beside those that were typed: what a person has typed stands before what a scan says."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.exam.sections.marking_policy import MarkingPolicy
from variantgen.finished.restore import Finished
from variantgen.marking.answer_tables import ReadAnswers
from variantgen.marking.key import Key
from variantgen.marking.marks import Verdict, mark
from variantgen.marking.matching import is_blank
from variantgen.marking.scan.collecting import Question, Scans, collect
from variantgen.marking.scan.confirming import Confirmed
from variantgen.marking.scan.review import typed_before
from variantgen.marking.typed_number import read_number


class Joined(Struct, frozen=True):
    """The answers of tables and scans together; what was read from the scans, and what was typed by question."""

    answers: ReadAnswers
    scans: Scans
    typed: Mapping[Question, str]


def join(
    finished: Finished,
    read: ReadAnswers,
    scans: Sequence[Path],
    policy: MarkingPolicy,
    names: Mapping[Path, str] | None = None,
    collected: Scans | None = None,
) -> Joined:
    """Read scans and put their answers behind those of tables. Raises InputError and ToolMissingError.

    ``names`` are words for the files where their own may name students; ``collected`` is what was read from the scans
    before, whose doubtful readings are confirmed in place.
    """
    if not finished.exam.scan:
        remedy = "type the answers into a table; the next exam has them with  [answers] scan = true  in its file"
        raise InputError(Problem("the exam was built without pages for answers", str(scans[0]), remedy=remedy))
    key = Key(finished.record, policy.tolerance)
    found = collect(scans, key, names) if collected is None else collected
    typed = typed_before(key, read.answers)
    _confirm_what_follows(finished, read, found, typed, policy)
    own = Scans({asked: answer for asked, answer in found.answers.items() if not _is_typed(asked, found, typed)})
    answers = (*read.answers, *own.handed_in(key))
    not_matched = (*read.not_matched, *found.not_matched)
    return Joined(replace(read, answers=answers, not_matched=not_matched), found, typed)


def _is_typed(asked: Question, scans: Scans, typed: Mapping[Question, str]) -> bool:
    """Whether what was typed stands alone: of doubtful answers always, of others where it says the same."""
    if asked not in typed:
        return False
    own = scans.answers[asked].read
    if own.why or is_blank(own.text):
        return True
    number, same = read_number(typed[asked]), read_number(own.text)
    return number is not None and same is not None and same.values[0] in number.values


def _confirm_what_follows(
    finished: Finished, read: ReadAnswers, scans: Scans, typed: Mapping[Question, str], policy: MarkingPolicy
) -> None:
    """Let doubtful readings stand that are right given the student's own earlier answers, if these stand.

    One answer of a problem is tried at a time, the others wait: two doubtful readings say nothing for each other.
    """
    may: dict[tuple[int, int], list[Question]] = defaultdict(list)
    for asked, answer in scans.doubtful.items():
        if answer.read.may_follow and asked not in typed:
            may[asked[:2]].append(asked)
    key = Key(finished.record, policy.tolerance)
    changed = True
    while changed:
        changed = False
        for turn in range(max(map(len, may.values()), default=0)):
            tried = {
                asked: replace(scans.answers[asked], read=Confirmed(scans.answers[asked].read.text))
                for own in may.values()
                for asked in own[turn : turn + 1]
            }
            of_these = {
                asked: tried.get(asked, answer)
                for asked, answer in scans.answers.items()
                if asked[:2] in may and not _is_typed(asked, scans, typed)
            }
            answers = (*read.answers, *Scans(of_these).handed_in(key))
            for item in mark(finished, replace(read, answers=answers), policy).marks:
                asked = item.place, item.problem, item.answer.quantity.name
                if asked in tried and item.verdict is Verdict.FOLLOW_THROUGH:
                    scans.answers[asked] = tried[asked]
                    changed = True
        may = {place: rest for place, own in may.items() if (rest := [a for a in own if a in scans.doubtful])}
