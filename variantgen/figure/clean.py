"""The first of several drawings on which no label is crossed or covered."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from variantgen.figure.drawing import Drawing
from variantgen.figure.faults import count_label_faults


def first_clean(makers: Iterable[Callable[[], Drawing]]) -> Drawing:
    """The first drawing without a fault of its labels, or the one with the fewest faults; there is at least one."""
    best: tuple[int, Drawing] | None = None
    for make in makers:
        drawing = make()
        faults = count_label_faults(drawing)
        if not faults:
            return drawing
        if best is None or faults < best[0]:
            best = (faults, drawing)
    assert best is not None
    return best[1]
