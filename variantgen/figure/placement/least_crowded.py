"""The first of several drawings on which every label has found room."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from variantgen.figure.drawing import Drawing
from variantgen.figure.faults import buried_heads, count_label_faults, leaders, misread_labels
from variantgen.figure.making import Making, Unlettered

_FAULT, _BURIED = 10, 3  # a label that is crossed or covered, a head of an arrow that is, in leaders
_FEW, _SHARE = 2, 6  # leaders that do not make a drawing crowded: so many, or one for so many labels


def first_clean(drafts: Iterable[Unlettered]) -> Making:
    """The first drawing without a fault of its labels, or the one with the fewest faults; there is at least one."""
    return _first(drafts, lambda drawing: count_label_faults(drawing) if drawing.doubtful else 0)


def first_roomy(drafts: Iterable[Unlettered]) -> Making:
    """The same, where labels that are led to from afar are too many as well."""
    return _first(drafts, _crowding)


def _crowding(drawing: Drawing) -> int:
    """Faults, buried heads, and the leaders that are too many for the labels of a drawing."""
    allowed = max(_FEW, len(drawing.labels) // _SHARE)
    faults = count_label_faults(drawing) + len(misread_labels(drawing)) if drawing.doubtful else 0
    return _FAULT * faults + _BURIED * len(buried_heads(drawing)) + max(0, len(leaders(drawing)) - allowed)


def _first(drafts: Iterable[Unlettered], crowding: Callable[[Drawing], int]) -> Making:
    """The first drawing that is not crowded, or the least crowded one; no more are made than are looked at."""
    best: tuple[int, Drawing] | None = None
    for draft in drafts:
        drawing = yield draft
        if drawing.width >= draft.widest:
            continue
        found = crowding(drawing)
        if not found:
            return drawing
        if best is None or found < best[0]:
            best = (found, drawing)
    assert best is not None
    return best[1]
