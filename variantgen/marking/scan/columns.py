"""What is filled in in each column of an answer, and what of it is doubtful.

A mark is measured by those of its own page: the darkness of a bubble is told as a share of that of the usual mark, so
faint pencils and crosses count as much as bubbles that are filled in well. Between marked and empty lies a band where
nobody decides but a person, or the key.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from msgspec import Struct
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.exam import answer_page as page
from variantgen.marking.scan.darkness import Darkness

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

_MARKED, _EMPTY, _TRACE = 0.5, 0.2, 0.09  # shares of the darkness of the usual mark
_ERASED = 0.35  # what is fainter may be what a rubber has left: the key cannot make a mark of it
_RIVAL = 0.5  # of the darkest bubble of a column: what is as dark beside it may be meant as well, as is every mark
_LEAST = 0.028  # darkness that the eye sees at all
_USUAL, _FEWEST = 0.3, 3  # the usual mark where a page has fewer of them than that
_WEAK = 0.7
# Strokes that cross a bubble out: the share of the usual mark and the least darkness that they have beyond its
# corners, at how many of them.
_OUT, _LEAST_OUT, _STROKES = 0.3, 0.12, 3
# At all four corners so dark, strokes do what the page tells to do with a wrong bubble: nobody need look at that.
_CLEAR, _LEAST_CLEAR = 0.8, 0.25
_CROSSES = 0.15  # of the marks: who has more crosses than that marks by them
_WRITTEN, _SHARE_WRITTEN = 0.007, 0.018  # least darkness of a box that has been written in, and share of the usual mark


class Column(Struct, frozen=True):
    """A column as it was read: its value (None: blank), and ``doubt``, why a person should look ('' if none).

    ``others`` are the values that it may have instead; ``open`` says that no value is more likely than others.
    ``dark`` are the bubbles in which something is seen, with their darkness as a share of that of the usual mark.
    """

    value: int | None
    doubt: str = ""
    others: tuple[int | None, ...] = ()
    open: bool = False
    dark: tuple[tuple[int, float], ...] = ()


def columns(measured: Darkness) -> list[list[Column]]:
    """The columns of each block of a page."""
    usual = _usual(measured)
    noise = measured.noise
    written = measured.boxes > max(_WRITTEN, _SHARE_WRITTEN * usual)
    found = []
    inked = measured.beside > max(_OUT * usual, _LEAST_OUT)
    crossed: NDArray[np.bool_] = inked.sum(axis=-1) >= _STROKES
    marks = measured.bubbles > _MARKED * usual
    if (crossed & marks).sum() > _CROSSES * marks.sum():
        crossed[:] = False  # this is how the student marks
    clear = np.all(measured.beside > max(_CLEAR * usual, _LEAST_CLEAR), axis=-1)
    for dark, out, firm in zip(measured.bubbles, crossed, clear, strict=True):
        own = [_column(dark[places], out[places], firm[places], usual, noise) for places in _places()]
        found.append([replace(c, dark=_seen(dark[places], usual)) for c, places in zip(own, _places(), strict=True)])
    writes = _writes(found, written)
    if writes:
        found = [_with_boxes(own, boxes) for own, boxes in zip(found, written, strict=True)]
    return found


def _seen(dark: Array, usual: float) -> tuple[tuple[int, float], ...]:
    """The bubbles of a column in which something is seen, the darkest first."""
    values = _values()[_kind_of(len(dark))]
    order = [int(k) for k in np.argsort(-dark) if dark[k] > _TRACE * usual]
    return tuple((values[k], float(dark[k]) / usual) for k in order)


@cache
def _places() -> tuple[NDArray[np.intp], ...]:
    """The places of the bubbles of each column."""
    return tuple(
        np.array([k for k, bubble in enumerate(page.BUBBLES) if bubble.column == column])
        for column in range(page.READ_COLUMNS)
    )


@cache
def _values() -> tuple[tuple[int, ...], ...]:
    return tuple(tuple(page.BUBBLES[k].value for k in places) for places in _places())


def _usual(measured: Darkness) -> float:
    """The darkness of the usual mark of a page: of bubbles that are alone in their columns."""
    marks = []
    for column in range(1, page.DIGITS + 1):
        own = np.sort(measured.bubbles[:, _places()[column]], axis=1)
        top, second = own[:, -1], own[:, -2]
        chosen = (top > max(_LEAST, 5 * measured.noise)) & (second < 0.4 * top)
        marks += top[chosen].tolist()
    if len(marks) < _FEWEST:
        return float(max([_USUAL, *marks]))
    return float(np.median(marks))


def _column(dark: Array, out: Flags, clear: Flags, usual: float, noise: float) -> Column:
    """One column by the darkness of its bubbles; ``out`` are crossed out, ``clear`` as the page tells to do it."""
    out = out & (dark > max(_EMPTY * usual, _LEAST))
    if out.any():
        rest = _column(np.where(out, 0.0, dark), np.zeros_like(out), clear, usual, noise)
        values = _values()[_kind_of(len(dark))]
        taken_back = tuple(values[k] for k in np.nonzero(out)[0])
        others = (*rest.others, *taken_back)
        if clear[out].all():
            return Column(rest.value, rest.doubt, others, rest.open)
        return Column(rest.value, "crossed out", others, rest.open or rest.value is None)
    values = _values()[_kind_of(len(dark))]
    order = np.argsort(-dark)
    top = float(dark[order[0]])
    second = float(dark[order[1]]) if len(dark) > 1 else 0.0
    empty = max(_EMPTY * usual, _LEAST, 4.0 * noise)
    trace = max(_TRACE * usual, 0.5 * _LEAST, 2.5 * noise)
    best = values[order[0]]
    traces = tuple(values[k] for k in order if dark[k] > trace)
    if top < empty:
        return Column(None, others=traces)
    rival = max(min(_RIVAL * top, _MARKED * usual), empty)
    if top < _MARKED * usual:
        return Column(best, "faint", (None, *traces[1:]), open=top < _ERASED * usual or second >= rival)
    if second >= rival:
        return Column(best, "several", tuple(values[k] for k in order if dark[k] > empty), open=True)
    if second >= empty:
        return Column(best, "several", traces[1:])
    weak = (None,) if top < _WEAK * usual else ()
    return Column(best, others=(*traces[1:], *weak))


def _kind_of(bubbles: int) -> int:
    """A column with so many bubbles."""
    return {1: page.MINUS, page.DIGITS - 1: page.POINT}.get(bubbles, 1)


def _writes(found: list[list[Column]], written: NDArray[np.bool_]) -> bool:
    """Whether the student writes digits above the bubbles: then a box tells whether its column is blank."""
    agreeing = [
        bool(boxes[k])
        for own, boxes in zip(found, written, strict=True)
        for k in range(1, page.DIGITS + 1)
        if own[k].value is not None and not own[k].doubt
    ]
    return len(agreeing) >= _FEWEST and sum(agreeing) >= 0.8 * len(agreeing)


def _with_boxes(own: list[Column], boxes: NDArray[np.bool_]) -> list[Column]:
    """The columns with what the boxes above digits and sign tell of them."""
    found = list(own)
    for k in range(page.DIGITS + 1):
        column = own[k]
        if column.value is None and boxes[k] and not column.doubt:
            # Where not even a trace is in the bubbles, these say what they say: the key may agree with them.
            found[k] = replace(column, doubt="unfilled", open=k != page.MINUS and bool(column.others))
        elif column.value is not None and not boxes[k]:
            found[k] = replace(column, doubt=column.doubt or "unwritten", others=(*column.others, None))
    return found
