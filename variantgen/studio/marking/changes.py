"""What is done to a marking: files brought, answers said, rules changed; and the command that writes the marks."""

from __future__ import annotations

import shutil
import zipfile
from collections.abc import Callable
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Any

from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.exam.sections.marking_policy import MarkingPolicy
from variantgen.exam.sheets import Answer
from variantgen.letters import unseen
from variantgen.marking.answer_tables import read_answers
from variantgen.marking.form_words import FormWords
from variantgen.marking.marks import Verdict, verdict_of
from variantgen.marking.scan.collecting import Question
from variantgen.marking.scan.pictures import is_picture
from variantgen.studio.documents.document import ChangedSinceError
from variantgen.studio.frame import command
from variantgen.studio.marking.folder import POLICY, RESULT, REVIEW, TYPED, Asked, MarkingFolder
from variantgen.studio.marking.marked import MarkedBuild, MarkedClass
from variantgen.studio.marking.policy_fields import policy_fields, with_fields
from variantgen.studio.marking.views import MarkWords, effect
from variantgen.studio.requests import number_of, text_of
from variantgen.studio.studio import Studio, UnknownKeyError

_LONGEST = 60  # letters of an answer


def words_of_command(studio: Studio, folder: MarkingFolder) -> list[str]:
    """The command that writes these marks."""
    words = ["mark", str(folder.build.folder), *map(str, folder.every()), "--out", str(folder.path / RESULT), "--force"]
    rules = folder.policy()
    words += ["--policy", str(rules)] if rules else []
    return [*words, *studio.workspace.families_option()]


def command_of(studio: Studio, folder: MarkingFolder) -> str:
    """The command as the page shows it."""
    words = words_of_command(studio, folder)
    if not folder.every():
        words.insert(2, "ANSWERS")
    return command("variantgen", *words)


def take(folder: MarkingFolder, marked: MarkedBuild, incoming: Path, name: str, done: Callable[[str], None]) -> None:
    """Keep a file with answers, if it has some; ``done`` is told its name in the folder. Raises InputError."""
    try:
        with incoming.open("rb") as file:
            beginning = file.read(8)
        path = folder.next_path(beginning)
        finished = marked.current().finished
        if is_picture(path):
            if not finished.exam.scan:
                text = "the exam was built without pages for answers"
                raise InputError(Problem(text, file=name, remedy="type the answers, or bring a table"))
        else:
            trial = incoming.with_suffix(path.suffix)
            shutil.move(incoming, trial)
            incoming = trial
            try:
                read_answers([trial], FormWords.of(finished.exam))
            except InputError as error:
                raise InputError(replace(problem, file=name) for problem in error.problems) from None
        with folder.lock:  # another window may have brought a file meanwhile
            path = folder.next_path(beginning)
            shutil.move(incoming, path)
            folder.name(path, name)
            done(path.name)
    finally:
        incoming.unlink(missing_ok=True)


def write_answer(
    folder: MarkingFolder,
    found: MarkedClass,
    data: dict[str, Any],
    expected: str | None = None,
    done: Callable[[str, str], None] = lambda before, text: None,
) -> tuple[Question, str, str]:
    """Write an answer; returns the question, what was typed before and what is now.

    ``done`` is told both before another window may write one. Raises InputError and UnknownKeyError for one that the
    exam does not ask, and ChangedSinceError where something else than what is ``expected`` is typed by now.
    """
    code, name = text_of(data, "code", 40), text_of(data, "quantity", 80)
    number = number_of(data.get("problem"), "problem", 1, 999)
    text = text_of(data, "text", _LONGEST).strip().lstrip("'")  # which spreadsheets put before a text
    if unseen(text):
        raise InputError(Problem("holds characters that cannot be seen", key="text"))
    try:
        question = found.place(code), number, name
        _right(found, question)
    except KeyError:
        raise UnknownKeyError(f"{code} {number}.{name}"[:80]) from None
    file = REVIEW if question in found.scanned else TYPED
    asked = code, number, name
    with folder.lock:
        entries = folder.written(file, _questions(found))
        before = entries.pop(asked, "")
        if expected is not None and before != expected:
            raise ChangedSinceError(Problem("was changed since", key=f"{code} {number}.{name}", value=before))
        if text:
            entries[asked] = text
        else:
            before = folder.forget(asked, before) or before
        folder.write(file, entries)
        done(before, text)
    return question, before, text


def said(
    folder: MarkingFolder, marked: MarkedBuild, data: dict[str, Any], done: Callable[[str, str], None]
) -> dict[str, Any]:
    """Write an answer; returns what stands then, whether that is of a file, and what was typed before.

    Where nothing or only a dash is typed the answer of a file stands. ``done`` and what is raised: as write_answer.
    """
    found = marked.current()
    question, before, text = write_answer(folder, found, data, done=done)
    verdict = verdict_of(_right(found, question), text)[2]
    if verdict is not Verdict.BLANK:
        return {"verdict": verdict.value, "text": text, "before": before, "typed": text, "of_file": False}
    now = marked.current()
    of_all = {(one.place, one.problem, one.answer.quantity.name): one for one in now.marked.marks}
    stands = "" if of_all[question].waiting else of_all[question].text
    shown = "doubtful" if question in now.doubtful else of_all[question].verdict.value
    of_file = stands not in ("", text)
    return {"verdict": shown, "text": stands, "before": before, "typed": text, "of_file": of_file}


def _right(found: MarkedClass, question: Question) -> Answer:
    """The answer that is right. Raises KeyError for a question that the exam does not ask."""
    place, number, name = question
    return {answer.quantity.name: answer for answer in found.key.answers(place, number)}[name]


def _questions(found: MarkedClass) -> set[Asked]:
    """Everything that the exam asks."""
    return {
        (sheet.code, problem.number, answer.quantity)
        for sheet in found.finished.record.sheets
        for problem in sheet.problems
        for answer in problem.answers
    }


def with_policy(
    folder: MarkingFolder, marked: MarkedBuild, data: dict[str, Any], language: str, done: Callable[[str], None]
) -> dict[str, Any]:
    """What rules change; written if ``use`` is true. Raises InputError for what is no rule.

    ``done`` is told the name in the bin of the rules that were replaced.
    """
    found, given = marked.current(), data.get("fields")
    known = policy_fields(found.policy)
    if not isinstance(given, dict) or not given.keys() <= known.keys():
        raise InputError(Problem("expected rules", key="fields"))
    fields = {name: _rule(name, text) for name, text in given.items()}
    rules: MarkingPolicy = with_fields(found.policy, fields)
    answer = effect(found.marked, found.by_policy(rules), MarkWords(found, language))
    if data.get("use") is not True:
        return answer
    if POLICY in found.faults:
        remedy = "correct policy.toml, or remove it; rules that are used here replace it"
        raise InputError(Problem("the rules of the file cannot be read", file=POLICY, remedy=remedy))
    with folder.lock:
        kept = folder.write_policy(rules)
        done(kept)
    return {**answer, "kept": kept}


def _rule(name: str, text: object) -> Decimal:
    """A rule as it was typed: per cent, a factor or a step."""
    most = {"tolerance": 10, "problem_step": 100, "total_step": 100}.get(name, 100)
    try:
        found = Decimal(str(text).replace(",", ".").replace("%", "").strip()[:12])
    except InvalidOperation:
        found = Decimal("NaN")
    if not found.is_finite() or not 0 <= found <= most or (name == "tolerance" and not found):
        raise InputError(Problem(f"expected a number from 0 to {most}", key=name, value=str(text)[:20]))
    return found


def pack(folder: MarkingFolder, path: Path) -> None:
    """All that the command has written in one file."""
    home = folder.path / RESULT
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as packed:
        for own in sorted(home.rglob("*")):
            if own.is_file() and not own.is_symlink():
                packed.write(own, str(own.relative_to(home)))
