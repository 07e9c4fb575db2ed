"""What the page Mark shows of doubtful readings: what each would be worth, how dark the bubbles are, what is open."""

from __future__ import annotations

import hashlib
from collections import defaultdict
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from variantgen.exam import answer_page
from variantgen.marking.marks import MarkedAnswer, verdict_of
from variantgen.marking.scan.collecting import SeenPage
from variantgen.marking.scan.copies import ScannedAnswer
from variantgen.marking.worth import sums
from variantgen.studio.marking.marked import MarkedClass

_READINGS, _BUBBLES = 4, 6  # of an answer that are shown
_ROOM = 0.3  # millimetres between bubbles and what is drawn around them
_DARKEST = 1.5  # that a bar shows, in usual marks


def points_between(found: MarkedClass, place: int, written: Callable[[Fraction], str]) -> str:
    """The points of a student; while readings are doubtful the least and the most that may come of them."""
    low = found.marked.totals[place].points
    own = {(problem, name) for at, problem, name in found.doubtful if at == place}
    if not own:
        return written(low)
    best, had = (
        defaultdict[int, Fraction](Fraction, found.marked.totals[place].by_hand),
        defaultdict[int, Fraction](Fraction),
    )
    for item in (item for item in found.marked.marks if item.place == place):
        best[item.problem] += item.of if (item.problem, item.answer.quantity.name) in own else item.points
        had[item.problem] += item.of
    most = sums(best, had, found.policy)[1]
    return f"{written(low)}\N{EN DASH}{written(most)}"


def readings(doubt: ScannedAnswer, item: MarkedAnswer) -> list[dict[str, str]]:
    """What a doubtful answer may say, as it was read first, with the verdict of each."""
    texts = dict.fromkeys(text for text in (doubt.read.text, *doubt.others) if text)
    return [{"text": text, "verdict": verdict_of(item.answer, text)[2].value} for text in list(texts)[:_READINGS]]


def bubbles(doubt: ScannedAnswer, decimal_mark: str) -> list[dict[str, Any]]:
    """The bubbles of doubtful columns: what they stand for, how dark they are beside the usual mark (per cent)."""
    kinds = {answer_page.MINUS: "minus", answer_page.POINT: "point"}
    return [
        {
            "kind": kinds.get(column, "digit"),
            "place": value if column == answer_page.POINT else column,
            "value": decimal_mark if column == answer_page.POINT else str(value),
            "share": round(100 * share),
            "width": round(100 * min(share / _DARKEST, 1.0)),
        }
        for column, value, share in doubt.seen[:_BUBBLES]
    ]


def outlines(doubt: ScannedAnswer) -> list[dict[str, float]]:
    """Where the doubtful columns stand on the picture of an answer, in millimetres of its block."""
    found = []
    for column in dict.fromkeys(column for column, _, _ in doubt.seen):
        own = [bubble for bubble in answer_page.BUBBLES if bubble.column == column]
        across, down = answer_page.LENGTH / 2 + answer_page.RADIUS + _ROOM, answer_page.RADIUS + _ROOM
        left, top = min(one.x for one in own) - across, min(one.y for one in own) - down
        width, height = max(one.x for one in own) + across - left, max(one.y for one in own) + down - top
        found.append({"x": left, "y": top, "width": width, "height": height})
    return [{name: round(value, 2) for name, value in one.items()} for one in found]


def scan_pages(found: MarkedClass, place: int) -> list[dict[str, Any]]:
    """The pages of the scan of a student, with the boxes that were read, in millimetres of the page."""
    marks = {(item.problem, item.answer.quantity.name): item for item in found.marked.marks if item.place == place}
    return [
        {
            "number": page.number,
            "where": page.where,
            "why": page.why,
            "version": version_of(page),
            "boxes": [_box(found, block, marks[asked[1:]]) for block, asked in enumerate(page.asked) if page.placed],
        }
        for page in found.pages.get(place, [])
    ]


def version_of(page: SeenPage) -> str:
    """A short name of the picture of a page, for addresses whose answer lasts; '' where its file is gone."""
    try:
        own = f"{page.path}\n{page.path.stat().st_mtime_ns}\n{page.within}\n{page.placed}"
    except OSError:
        return ""
    return hashlib.sha256(own.encode()).hexdigest()[:12]


def _box(found: MarkedClass, block: int, item: MarkedAnswer) -> dict[str, Any]:
    """The box of an answer on its page."""
    left, top = answer_page.block_corner(block)
    name = item.answer.quantity.name
    doubt = found.doubtful.get((item.place, item.problem, name))
    return {
        "key": f"{item.problem}.{name}",
        "x": left,
        "y": top,
        "verdict": "doubtful" if doubt else item.verdict.value,
        "columns": outlines(doubt) if doubt else [],
    }
