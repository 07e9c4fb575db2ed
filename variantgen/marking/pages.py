"""Pages of a marking: what each student gets back, and what the marks tell of the problems."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from pathlib import Path
from typing import Any

from markupsafe import Markup

from variantgen.exam.exam import Exam
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity, split_name
from variantgen.finished.restore import Finished
from variantgen.marking.class_statistics import Advice, ProblemFacts, class_facts
from variantgen.marking.marks import Marked, MarkedAnswer, Verdict
from variantgen.marking.records import shown
from variantgen.marking.solution_steps import sections_of
from variantgen.marking.words import cause_in_words
from variantgen.outputs.documents.solution_blocks import blocks_data
from variantgen.outputs.html.articles import page_writing
from variantgen.outputs.html.pages import write_page
from variantgen.wording.language import Language
from variantgen.wording.mathml import to_mathml

FEEDBACK, STATISTICS = "feedback", "statistics.html"
FILES = (f"{FEEDBACK}/*.html", STATISTICS)
_VERDICTS = ("right", "follow_through", "wrong", "blank", "unreadable")
_HIDDEN = ("neighbour", "other")  # the first is a suspicion for the instructor alone
_DECIMAL = re.compile(r"-?\d+\.\d+")
_BANDS = 10  # of the shares of points of a class


def write_pages(folder: Path, finished: Finished, marked: Marked, anonymous: bool, steps: bool = False) -> None:
    """Write a page for each student who handed in or has points by hand, and the statistics of the class.

    ``steps``: with the steps of the worked solution that lead to wrong answers, at some 50 ms a problem.
    """
    exam = finished.exam
    language = exam.spoken
    (folder / FEEDBACK).mkdir()
    own: dict[int, list[MarkedAnswer]] = defaultdict(list)
    for item in marked.marks:
        own[item.place].append(item)
    for place, total in enumerate(marked.totals):
        if not total.handed_in and not total.by_hand:
            continue
        problems: dict[int, list[MarkedAnswer]] = defaultdict(list)
        for item in own[place]:
            problems[item.problem].append(item)
        write_page(
            folder / FEEDBACK / f"{total.code}.html",
            "feedback.html.j2",
            **_common(exam, language),
            who="" if anonymous else total.student.name,
            group="" if anonymous else total.student.group,
            code=total.code,
            points=_number(shown(total.points), language),
            of=_number(shown(total.of), language),
            grade=total.grade,
            open=language.words("review")["not_final"] if total.open else "",
            problems=[
                {
                    "number": number,
                    "answers": [_answer(finished, item, language) for item in items],
                    "points": _number(shown(total.problems[number]), language),
                    "of": _number(shown(sum((item.of for item in items), Fraction(0))), language),
                    "by_hand": _by_hand(total.by_hand.get(number), language),
                    "steps": _steps(finished, items) if steps else [],
                }
                for number, items in problems.items()
            ],
        )
    _write_statistics(folder / STATISTICS, finished, marked, language)


def _by_hand(points: Fraction | None, language: Language) -> str:
    """Points given or taken by hand, with their sign; '' for none."""
    return _number(("+" if points > 0 else "") + shown(points), language) if points else ""


def _common(exam: Exam, language: Language) -> dict[str, Any]:
    return {
        "lang": exam.language,
        "course": exam.course,
        "heading": exam.title,
        "words": language.words("marking"),
        "key": language.words("key"),
    }


def _answer(finished: Finished, item: MarkedAnswer, language: Language) -> dict[str, Any]:
    """One row of a student's page."""
    words = language.words("marking")
    return {
        "symbol": _symbol(finished.variant(item.place, item.problem).form, item.answer.quantity, language),
        "unit": Markup(to_mathml(language.unit(item.answer.unit))) if item.answer.unit.name != "1" else "",  # noqa: S704
        "text": _typed(item, language),
        "right": _number(str(language.answer(item.answer.quantity, item.answer.value).text), language),
        "verdict": words[item.verdict.value],
        "kind": item.verdict.value,
        "cause": _cause(finished, item, language),
        "points": _number(shown(item.points), language),
        "of": _number(shown(item.of), language),
        "struck": not item.of,
    }


@lru_cache(maxsize=1000)
def _symbol(form: Form, quantity: Quantity, language: Language) -> Markup:
    """The symbol of a quantity of a form as markup; students of a class have few different ones."""
    return Markup(to_mathml(language.quantity(quantity, dict(form.symbols))))  # noqa: S704


def _typed(item: MarkedAnswer, language: Language) -> str:
    """An answer as it was typed, a plain decimal with the mark of the language: scans are read with a point."""
    if item.value is None:
        return item.text
    return _number(item.text, language) if _DECIMAL.fullmatch(item.text) else item.text.replace("-", "\N{MINUS SIGN}")


def _cause(finished: Finished, item: MarkedAnswer, language: Language) -> str:
    """The cause in words for the student, answers in it by their symbols; '' for none and for a suspicion."""
    words, cause = language.words("marking"), item.cause
    if cause is None or cause.name in _HIDDEN:
        return ""
    if cause.name not in ("from", "other_answer"):
        return cause_in_words(cause, words, language, dict(finished.variant(item.place, item.problem).form.symbols))
    found = []
    for name in cause.detail.split(", "):
        number, dot, other = name.partition(".") if cause.name == "other_answer" else ("", "", name)
        symbol = _symbol(finished.variant(item.place, int(number or item.problem)).form, split_name(other), language)
        found.append(Markup("{}{} {}").format(number, dot, symbol) if number else symbol)
    return Markup("{}: {}").format(words[f"cause.{cause.name}"], Markup(", ").join(found))


def _steps(finished: Finished, items: Sequence[MarkedAnswer]) -> list[dict[str, Any]]:
    """The steps of the worked solution that lead to the wrong answers of a problem."""
    wrong = [place for place, item in enumerate(items) if item.verdict is Verdict.WRONG]
    if not wrong:
        return []
    place, number = items[0].place, items[0].problem
    task = next(task for task in finished.exam.tasks if task.number == number)
    answers = [item.answer for item in items]
    found = sections_of(finished.exam, task, finished.variant(place, number), answers, wrong)
    writing = page_writing()
    return [
        {"number": step, "heading": writing.text(section.heading), "blocks": blocks_data(section.blocks, writing)}
        for step, section in found.items()
    ]


def _number(text: str, language: Language) -> str:
    return text.replace(".", language.decimal_mark).replace("-", "\N{MINUS SIGN}")


def _write_statistics(path: Path, finished: Finished, marked: Marked, language: Language) -> None:
    mirrored = {
        (place, problem.number)
        for place, sheet in enumerate(finished.record.sheets)
        for problem in sheet.problems
        if problem.mirrored
    }
    facts = class_facts(marked, mirrored)
    words = language.words("marking")
    symbols = {
        (item.problem, item.answer.quantity.name): Markup("{}. {}").format(
            item.problem, _symbol(finished.variant(item.place, item.problem).form, item.answer.quantity, language)
        )
        for item in marked.marks
    }
    bands = [0] * _BANDS
    for share in facts.shares:
        bands[min(int(share * _BANDS), _BANDS - 1)] += 1
    write_page(
        path,
        "statistics.html.j2",
        **_common(finished.exam, language),
        students=facts.students,
        handed_in=facts.handed_in,
        bands=[
            {"from": 10 * i, "to": 10 * (i + 1), "count": count, "height": round(100 * count / max([*bands, 1]))}
            for i, count in enumerate(bands)
        ],
        verdicts=[(name, words["follows" if name == "follow_through" else name]) for name in _VERDICTS],
        advice=[_advised(item, symbols, words, language) for item in facts.advice],
        uneven=[
            {
                "symbol": symbols[item.number, item.quantity],
                "forms": [
                    (form, round(100 * right / (right + others)))
                    for form, (right, others) in zip(item.forms, item.right, strict=True)
                ],
                "p": _number(f"{item.probability:.2g}", language),
            }
            for item in facts.uneven
        ],
        mirrored=[{"number": n, "p": _number(f"{p:.2g}", language)} for n, p in facts.mirrored.items()],
        problems=[_problem(item, symbols, language) for item in facts.problems],
        forms=[_problem(item, symbols, language) for item in facts.forms],
        equal=[{"number": n, "p": _number(f"{p:.2g}", language)} for n, p in facts.equal_forms.items()],
    )


def _bars(counts: Sequence[int]) -> list[dict[str, Any]]:
    """Where the parts of a bar of the length 100 begin, and how long they are."""
    whole, found, start = max(sum(counts), 1), [], 0.0
    for name, count in zip(_VERDICTS, counts, strict=True):
        length = 100.0 * count / whole
        found.append({"name": name, "start": round(start, 2), "length": round(length, 2), "count": count})
        start += length
    return found


def _advised(
    item: Advice, symbols: Mapping[tuple[int, str], Markup], words: Mapping[str, str], language: Language
) -> dict[str, str]:
    """A piece of advice in words."""
    what = symbols[item.number, item.quantity] if item.quantity else f"{item.number}"
    reason = words["advice.correlation" if not item.quantity else "advice.hardly"]
    if item.kind == "teach":
        reason = cause_in_words(item.cause, words, language, {})
    return {"kind": words[f"advice.{item.kind}"], "what": what, "reason": reason}


def _problem(item: ProblemFacts, symbols: Mapping[tuple[int, str], Markup], language: Language) -> dict[str, Any]:
    """One row of the statistics with those of its answers."""
    return {
        "number": item.number,
        "form": item.form,
        "students": item.students,
        "share": round(100 * item.share),
        "discrimination": ""
        if item.discrimination is None
        else _number(f"{Decimal(item.discrimination):.2f}", language),
        "answers": [
            {
                "symbol": symbols[item.number, a.quantity],
                "counts": [a.verdicts.get(name, 0) for name in _VERDICTS],
                "bars": _bars([a.verdicts.get(name, 0) for name in _VERDICTS]),
                "share": round(100 * a.share),
            }
            for a in item.answers
        ],
        "causes": [
            (cause_in_words(cause, language.words("marking"), language, {}), count) for cause, count in item.causes
        ],
    }
