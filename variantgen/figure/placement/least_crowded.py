"""The first of several drawings on which every label has found room."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from variantgen.figure.inspection.faults import buried_heads, count_label_faults, misread_labels
from variantgen.figure.lettered_sketch import LetteredSketch
from variantgen.figure.making import Making, Unlettered

_FAULT, _BURIED = 10, 3  # a label that is crossed or covered, a head of an arrow that is, in leaders
_FEW, _SHARE = 2, 6  # leaders that do not make a drawing crowded: so many, or one for so many labels


def first_clean(drafts: Iterable[Unlettered]) -> Making:
    """The first drawing without a fault of its labels, or the one with the fewest faults; there is at least one."""
    return _first(drafts, lambda draft: 0, lambda found: count_label_faults(found.drawing) if found.doubtful else 0)


def first_roomy(drafts: Iterable[Unlettered]) -> Making:
    """The same, where labels that are led to from afar and buried heads of arrows are too many as well."""
    return _first(drafts, lambda draft: _BURIED * len(buried_heads(draft.sketch.lines)), _crowding)


def _crowding(found: LetteredSketch) -> int:
    """Faults of labels, and the leaders that are too many for them."""
    allowed = max(_FEW, len(found.labels) // _SHARE)
    faults = count_label_faults(found.drawing) + len(misread_labels(found.drawing)) if found.doubtful else 0
    return _FAULT * faults + max(0, len(found.leaders) - allowed)


def _first(
    drafts: Iterable[Unlettered], bare: Callable[[Unlettered], int], crowding: Callable[[LetteredSketch], int]
) -> Making:
    """The first drawing that is not crowded, or the least crowded one; no more are made than are looked at.

    Crowded it may be without labels (``bare``) and with them (``crowding``). What is so without any is lettered last.
    """
    waiting: list[tuple[int, int, Unlettered]] = []
    best: tuple[int, int, LetteredSketch] | None = None
    for number, draft in enumerate(drafts):
        if draft.sketch.width >= draft.widest:
            continue
        if without := bare(draft):
            waiting.append((without, number, draft))
            continue
        found = yield draft
        if found.width >= draft.widest:
            continue
        crowded = crowding(found)
        if not crowded:
            return found.drawing
        if best is None or crowded < best[0]:
            best = (crowded, number, found)
    for without, number, draft in waiting:
        if best is None or (without, number) < best[:2]:
            found = yield draft
            crowded = without + crowding(found)
            if found.width < draft.widest and (best is None or (crowded, number) < best[:2]):
                best = (crowded, number, found)
    assert best is not None
    return best[2].drawing
