"""How much work the variants of a finished exam take: by problem and form, and by sheet."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from msgspec import Struct, field

from variantgen.exam.manifest import Manifest
from variantgen.methods.hand.work import Work
from variantgen.outputs.html.pages import write_page
from variantgen.wording.language import Language

_PARTS = ("calculations", "operations", "negatives", "obtuse")
_WIDTH, _HEIGHT = 420, 60  # of a plot, in pixels
_BARS = 42  # most bars of a plot


class WorkReport(Struct, frozen=True):
    """The variants by problem, family and form: how many take so many calculations, operations, ...

    ``sheets`` has the calculations of whole sheets, of those on which all problems have their work recorded.
    ``configurations`` counts by problem, form and group the words of what is seen in the figure: a side, a sense.
    """

    forms: Mapping[tuple[int, str], Mapping[str, Counter[int]]] = field(default_factory=dict)
    sheets: Counter[int] = field(default_factory=Counter)
    configurations: Mapping[tuple[int, str, str], Mapping[str, Counter[str]]] = field(default_factory=dict)


def work_report(record: Manifest) -> WorkReport:
    """The report of a manifest; without forms where the exam was built without looking at work."""
    forms: dict[tuple[int, str], dict[str, Counter[int]]] = {}
    sheets = Counter[int]()
    configurations: dict[tuple[int, str, str], dict[str, Counter[str]]] = {}
    for sheet in record.sheets:
        works = [(problem, problem.work) for problem in sheet.problems]
        for problem, work in works:
            if work is not None:
                key = problem.number, problem.problem_type
                own = forms.setdefault(key, {part: Counter() for part in _PARTS})
                for part in _PARTS:
                    own[part][getattr(work, part)] += 1
            for name, (word, unit) in problem.parameters.items():
                if not unit:
                    place = problem.number, problem.problem_type, sheet.student.group
                    configurations.setdefault(place, {}).setdefault(name, Counter())[word] += 1
        if works and all(work is not None for _, work in works):
            sheets[_total(work for _, work in works)] += 1
    return WorkReport(dict(sorted(forms.items())), sheets, dict(sorted(configurations.items())))


def _total(works: Iterable[Work | None]) -> int:
    return sum(work.calculations for work in works if work is not None)


def spread(found: Counter[int]) -> str:
    """The fewest and the most: ``77-80``, or the one number."""
    least, most = min(found), max(found)
    return str(least) if least == most else f"{least}\N{EN DASH}{most}"


def counted(found: Mapping[str, Counter[str]]) -> str:
    """How often each word was drawn: ``side: left 9, right 11; sense: ...``."""
    return "; ".join(
        f"{name}: " + ", ".join(f"{word} {count}" for word, count in sorted(words.items()))
        for name, words in sorted(found.items())
    )


def ratio(found: Counter[int]) -> float:
    """The most over the fewest."""
    return max(found) / max(1, min(found))


def write_report(path: Path, report: WorkReport, title: str, course: str, language: Language) -> None:
    """Write a page with the spread of each problem and of the sheets as plots."""
    rows = [
        {
            "number": number,
            "form": form,
            "students": own["calculations"].total(),
            "spreads": [spread(own[part]) for part in _PARTS],
            "ratio": _decimal(ratio(own["calculations"]), language),
            "plot": _plot(own["calculations"]),
        }
        for (number, form), own in report.forms.items()
    ]
    sheets = report.sheets
    write_page(
        path,
        "fairness.html.j2",
        lang=language.name,
        course=course,
        heading=title,
        words=language.words("fairness"),
        key=language.words("key"),
        rows=rows,
        configurations=[(*place, counted(own)) for place, own in report.configurations.items()],
        sheets={
            "spread": spread(sheets),
            "ratio": _decimal(ratio(sheets), language),
            "students": sheets.total(),
            "plot": _plot(sheets),
        }
        if sheets
        else None,
        width=_WIDTH,
        height=_HEIGHT,
    )


def _decimal(number: float, language: Language) -> str:
    return f"{number:.2f}".replace(".", language.decimal_mark)


def _plot(found: Counter[int]) -> dict[str, Any]:
    """The bars of a histogram: where each begins, how wide and how high it is, and whom it counts."""
    least, most = min(found), max(found)
    step = -(-(most - least + 1) // _BARS)
    bins = Counter(dict.fromkeys(range(least, most + 1, step), 0))
    for number, count in found.items():
        bins[least + (number - least) // step * step] += count
    tallest = max(bins.values())
    width = _WIDTH / max(len(bins), 8)
    return {
        "least": least,
        "most": most,
        "bars": [
            {
                "x": round(width * place, 1),
                "width": round(0.9 * width, 1),
                "height": round((_HEIGHT - 14) * count / tallest, 1),
                "from": first,
                "to": min(first + step - 1, most),
                "count": count,
            }
            for place, (first, count) in enumerate(sorted(bins.items()))
        ],
    }
