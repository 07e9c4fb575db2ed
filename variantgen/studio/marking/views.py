"""What the page Mark shows of the marks: the class in a list, one student, one question, all problems, other rules."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from fractions import Fraction
from statistics import median
from typing import Any

from markupsafe import Markup

from variantgen.exam.student_order import in_order
from variantgen.marking.class_statistics import class_facts
from variantgen.marking.diagnosis.causes import OTHER, Cause
from variantgen.marking.marks import Marked, MarkedAnswer, StudentTotal, Verdict
from variantgen.marking.words import cause_in_words
from variantgen.studio.marking.doubts import bubbles, outlines, points_between, readings
from variantgen.studio.marking.marked import MarkedClass
from variantgen.studio.marking.policy_fields import policy_fields
from variantgen.studio.messages import in_language
from variantgen.wording.language import Language, load_language
from variantgen.wording.mathml import to_mathml

_LISTED = 300
_BANDS = 10
_PLACE = re.compile(r", (?:worksheet .{1,31}, )?(?:row|page) \d+")
_FILE = re.compile(r"\b(?:answers|typed|review)-\d+\.\w+")


class MarkWords:
    """Numbers, symbols and causes in the language of the page."""

    def __init__(self, found: MarkedClass, language: str) -> None:
        self._found = found
        self.language: Language = load_language(language)
        self.marking = self.language.words("marking")
        self._name = language

    def explained(self, message: str, names: Mapping[str, str]) -> str:
        """A message of the program; ``names`` are those that files came with, by those that messages have."""
        message = in_language(message, self._name)
        message = _PLACE.sub(lambda found: in_language(found[0], self._name), message)
        return _FILE.sub(lambda found: names.get(found[0], found[0]), message)

    def number(self, text: str) -> str:
        """A number with the decimal mark and the minus sign of the language."""
        return text.replace(".", self.language.decimal_mark).replace("-", "\N{MINUS SIGN}")

    def points(self, points: Fraction) -> str:
        """Points with at most two places."""
        return self.number(f"{float(points):.2f}".rstrip("0").rstrip("."))

    def symbol(self, item: MarkedAnswer) -> Markup:
        """The symbol of a quantity."""
        return Markup(to_mathml(self.language.quantity(item.answer.quantity, self.symbols(item))))  # noqa: S704  # own MathML

    def title(self, item: MarkedAnswer) -> str:
        """The title of the problem that an answer is of."""
        return self._found.finished.variant(item.place, item.problem).family.title(self._name)

    def unit(self, item: MarkedAnswer) -> Markup:
        """The unit of an answer; '' for none."""
        name = item.answer.unit
        return Markup(to_mathml(self.language.unit(name))) if name.name != "1" else Markup("")  # noqa: S704

    def cause(self, item: MarkedAnswer) -> str:
        """Why an answer may be wrong."""
        return cause_in_words(item.cause, self.marking, self.language, self.symbols(item))

    def symbols(self, item: MarkedAnswer) -> dict[str, str]:
        """The symbols of the form that an answer is of."""
        return dict(self._found.finished.variant(item.place, item.problem).form.symbols)

    def right(self, item: MarkedAnswer) -> str:
        """What is right, with its tolerance."""
        value = self.language.answer(item.answer.quantity, item.answer.value).text
        return self.number(f"{value} ± {item.answer.tolerance:.2g}")


def queue(found: MarkedClass, words: MarkWords) -> list[dict[str, Any]]:
    """The class by group and name: points, how many answers wait, whether anything was handed in."""
    places = {total.student.id: place for place, total in enumerate(found.marked.totals)}
    waiting = Counter(place for place, _, _ in found.doubtful)
    return [
        {
            "code": found.marked.totals[places[student.id]].code,
            "name": student.name or student.id,
            "group": student.group,
            "points": points_between(found, places[student.id], words.points),
            "doubts": waiting[places[student.id]],
            "handed_in": found.marked.totals[places[student.id]].handed_in,
        }
        for student in in_order([total.student for total in found.marked.totals])
    ]


def questions(found: MarkedClass, words: MarkWords) -> list[dict[str, Any]]:
    """The answers that the exam asks for, by their first symbols, with how many of each wait."""
    first: dict[tuple[int, str], MarkedAnswer] = {}
    for item in found.marked.marks:
        first.setdefault((item.problem, item.answer.quantity.name), item)
    waiting = Counter((problem, name) for _, problem, name in found.doubtful)
    return [
        {"problem": problem, "quantity": name, "symbol": words.symbol(item), "doubts": waiting[problem, name]}
        for (problem, name), item in first.items()
    ]


def student(found: MarkedClass, code: str, words: MarkWords) -> dict[str, Any]:
    """One student: the answers problem by problem."""
    place = found.place(code)
    total = found.marked.totals[place]
    own: dict[int, list[MarkedAnswer]] = {}
    for item in found.marked.marks:
        if item.place == place:
            own.setdefault(item.problem, []).append(item)
    return {
        "code": code,
        "name": total.student.name or total.student.id,
        "group": total.student.group,
        "points": points_between(found, place, words.points),
        "of": words.points(total.of),
        "grade": total.grade,
        "open": total.open,
        "scans": found.finished.exam.scan,
        "problems": [
            {
                "number": number,
                "title": words.title(items[0]),
                "points": words.points(total.problems[number]),
                "of": words.points(sum((item.of for item in items), Fraction(0))),
                "answers": [answer(found, item, words) for item in items],
            }
            for number, items in own.items()
        ],
    }


def question(found: MarkedClass, problem: int, name: str, words: MarkWords) -> list[dict[str, Any]]:
    """One question across the class, in the order of the list; those that wait come first."""
    by_id = {found.marked.totals[item.place].student.id: item for item in found.marked.marks if item.problem == problem
             and item.answer.quantity.name == name}  # fmt: skip
    students = in_order([total.student for total in found.marked.totals if total.student.id in by_id])
    rows = []
    for one in students:
        item = by_id[one.id]
        total = found.marked.totals[item.place]
        rows.append({"name": one.name or one.id, "code": total.code, **answer(found, item, words)})
    return sorted(rows, key=lambda row: not row["doubtful"])


def answer(found: MarkedClass, item: MarkedAnswer, words: MarkWords) -> dict[str, Any]:
    """One answer as a row."""
    asked = item.place, item.problem, item.answer.quantity.name
    doubt = found.doubtful.get(asked)
    scan = found.scanned.get(asked)
    return {
        "key": f"{item.problem}.{item.answer.quantity.name}",
        "problem": item.problem,
        "quantity": item.answer.quantity.name,
        "symbol": words.symbol(item),
        "unit": words.unit(item),
        "text": "" if item.waiting else item.text,
        "right": words.right(item),
        "verdict": "doubtful" if doubt else item.verdict.value,
        "cause": words.cause(item) if item.verdict in (Verdict.WRONG, Verdict.FOLLOW_THROUGH) else "",
        "points": words.points(item.points),
        "of": words.points(item.of),
        "doubtful": doubt is not None,
        "readings": readings(doubt, item) if doubt else [],
        "outlines": outlines(doubt) if doubt else [],
        "bubbles": bubbles(doubt, words.language.decimal_mark) if doubt else [],
        "why": [why.replace(" ", "_") for why in doubt.read.why] if doubt else [],
        "picture": bool(scan and scan.picture),
    }


def class_in(found: MarkedClass, problem: int, words: MarkWords) -> dict[str, Any]:
    """What the class made of a problem: how often each verdict, each cause."""
    own = [item for item in found.marked.marks if item.problem == problem]
    handed = [item for item in own if found.marked.totals[item.place].handed_in]
    counts = Counter(item.verdict.value for item in handed if item.verdict is not Verdict.WRONG)
    causes = Counter(
        cause_in_words(_kind(item.cause), words.marking, words.language, words.symbols(item))
        for item in handed
        if item.verdict is Verdict.WRONG
    )
    rows = [(kind, words.marking[kind], counts[kind]) for kind in ("right", "follow_through")]
    rows += [("wrong", word, count) for word, count in causes.most_common(6)]
    rows.append(("blank", words.marking["blank"], counts["blank"]))
    most = max(1, *(count for _, _, count in rows))
    shares = [{"kind": k, "word": w, "count": n, "share": round(100 * n / most, 1)} for k, w, n in rows]
    return {"number": problem, "answers": len(handed), "rows": shares}


def class_view(found: MarkedClass, words: MarkWords, names: Mapping[str, str]) -> dict[str, Any]:
    """All problems, the points of the class, what was not matched in files, which came with these names."""
    mirrored = {
        (place, problem.number)
        for place, sheet in enumerate(found.finished.record.sheets)
        for problem in sheet.problems
        if problem.mirrored
    }
    facts = class_facts(found.marked, mirrored)
    totals = [total for total in found.marked.totals if total.handed_in]
    bands = [0] * _BANDS
    for share in facts.shares:
        bands[min(int(share * _BANDS), _BANDS - 1)] += 1
    most = max([*bands, 1])
    return {
        "students": facts.students,
        "handed_in": facts.handed_in,
        "median": words.number(f"{float(median(total.points for total in totals)):.4g}") if totals else "",
        "of": words.points(max((total.of for total in totals), default=Fraction(0))),
        "bands": [{"x": 8 + 31 * i, "h": round(84 * n / most), "n": n, "from": 10 * i} for i, n in enumerate(bands)],
        "problems": [
            {
                "number": own.number,
                "share": round(100 * own.share),
                "parts": _parts(found, own.number),
                "cause": "; ".join(
                    f"{cause_in_words(cause, words.marking, words.language, {})}, {count}"
                    for cause, count in own.causes[:1]
                ),
                "correlation": "" if own.discrimination is None else words.number(f"{own.discrimination:.2f}"),
                "uneven": facts.equal_forms.get(own.number, 1.0) < 0.05,
                "compared": own.number in facts.equal_forms,
            }
            for own in facts.problems
        ],
        "left": [
            {
                "text": item.text,
                **{name: words.explained(getattr(item, name), names) for name in ("where", "why", "remedy")},
            }
            for item in found.marked.not_matched[:_LISTED]
        ],
        "policy": policy_fields(found.policy),
    }


def _kind(cause: Cause | None) -> Cause:
    """A cause as it is counted: mistakes are told apart, of others the kind is enough."""
    return OTHER if cause is None else cause if cause.name == "mistake" else Cause(cause.name)


def _parts(found: MarkedClass, problem: int) -> list[dict[str, Any]]:
    """The parts of a bar: how many answers of a problem are what."""
    counts: Counter[str] = Counter()
    for item in found.marked.marks:
        if item.problem == problem and found.marked.totals[item.place].handed_in:
            known = item.verdict is Verdict.WRONG and item.cause is not None and item.cause.name != "other"
            counts["known" if known else item.verdict.value] += 1
    whole, start, parts = max(sum(counts.values()), 1), 0.0, []
    for kind in ("right", "follow_through", "known", "wrong", "blank", "unreadable"):
        length = 100 * counts[kind] / whole
        parts.append({"kind": kind, "x": round(start, 2), "w": round(length, 2), "count": counts[kind]})
        start += length
    return parts


def effect(before: Marked, now: Marked, words: MarkWords) -> dict[str, Any]:
    """Whose points are others by other rules."""
    changed: Sequence[tuple[StudentTotal, StudentTotal]] = [
        (old, new) for old, new in zip(before.totals, now.totals, strict=True) if old.points != new.points
    ]
    grades = sum(old.grade != new.grade for old, new in zip(before.totals, now.totals, strict=True))
    return {
        "up": sum(new.points > old.points for old, new in changed),
        "down": sum(new.points < old.points for old, new in changed),
        "grades": grades,
        "who": [
            {
                "name": new.student.name or new.student.id,
                "before": words.points(old.points),
                "now": words.points(new.points),
            }
            for old, new in changed[:_LISTED]
        ],
    }
