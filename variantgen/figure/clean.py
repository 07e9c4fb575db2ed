"""The first of several drawings on which every label has found room."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from variantgen.figure.drawing import Drawing
from variantgen.figure.faults import count_label_faults, leaders

_FAULT = 10  # a label that is crossed or covered, in leaders
_FEW = 1  # leaders that do not make a drawing crowded


def first_clean(makers: Iterable[Callable[[], Drawing]]) -> Drawing:
    """The first drawing without a fault of its labels, or the one with the fewest faults; there is at least one."""
    return _first(makers, count_label_faults, 0)


def first_roomy(makers: Iterable[Callable[[], Drawing]]) -> Drawing:
    """The same, where labels that are led to from afar are too many as well."""
    return _first(makers, lambda drawing: _FAULT * count_label_faults(drawing) + len(leaders(drawing)), _FEW)


def _first(makers: Iterable[Callable[[], Drawing]], crowding: Callable[[Drawing], int], allowed: int) -> Drawing:
    """The first drawing that is not more crowded than allowed, or the least crowded one."""
    best: tuple[int, Drawing] | None = None
    for make in makers:
        drawing = make()
        found = crowding(drawing)
        if found <= allowed:
            return drawing
        if best is None or found < best[0]:
            best = (found, drawing)
    assert best is not None
    return best[1]
