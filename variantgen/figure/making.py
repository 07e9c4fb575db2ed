"""Figures in the making: what is drawn waits for its labels, which are placed for many figures at once.

A figure is a generator that yields sketches, one after the other as it tries them, gets each back with its labels
placed, and returns the drawing that it settles on.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

from variantgen.errors import InputError
from variantgen.figure.drawing import Drawing
from variantgen.figure.lettered_sketch import LetteredSketch, lettered
from variantgen.figure.sketch import Sketch
from variantgen.wording.words import MissingWordError

_AT_ONCE = 8  # figures of which the labels are placed together: with more their arrays leave the cache


class Unlettered(NamedTuple):
    """A sketch without its labels, and the points that it shows; a drawing of it that is so wide (u) is no good."""

    sketch: Sketch
    named: Mapping[str, complex]
    widest: float = float("inf")


Making: TypeAlias = Generator[Unlettered, LetteredSketch, Drawing]


def made(making: Making) -> Drawing:
    """One figure. Raises InputError where it cannot be drawn."""
    (found,) = all_made([making])
    return found


def all_made(makings: Sequence[Making]) -> list[Drawing]:
    """Figures. Raises InputError where one cannot be drawn."""
    found = tried(makings)
    for one in found:
        if isinstance(one, InputError):
            raise one
    return [one for one in found if isinstance(one, Drawing)]


def tried(makings: Sequence[Making]) -> list[Drawing | InputError]:
    """Figures, or why they cannot be drawn. Raises MissingWordError."""
    found: dict[int, Drawing | InputError] = {}
    for start in range(0, len(makings), _AT_ONCE):
        group = dict(enumerate(makings[start : start + _AT_ONCE], start))
        drafts = {number: draft for number, making in group.items() if (draft := _next(making, None, number, found))}
        while drafts:
            placed = lettered([(draft.sketch, draft.named) for draft in drafts.values()])
            answered = zip(drafts, placed, strict=True)
            drafts = {n: draft for n, one in answered if (draft := _next(group[n], one, n, found))}
    return [found[number] for number in range(len(makings))]


def _next(
    making: Making, lettered: LetteredSketch | None, number: int, found: dict[int, Drawing | InputError]
) -> Unlettered | None:
    """What a figure tries next after it has got a sketch lettered (none: at first); None where it is ``found``."""
    try:
        return next(making) if lettered is None else making.send(lettered)
    except StopIteration as end:
        found[number] = end.value
    except MissingWordError:
        raise
    except InputError as error:
        found[number] = error
    return None
