"""Sketches with their labels placed, and put in order as drawings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

from msgspec import Struct

from variantgen.figure.drawing import Drawing, Label, Path
from variantgen.figure.placement.labels import NOTHING_PLACED, WantedLabels, place_labels
from variantgen.figure.sketch import MARGIN, Sketch, box_about, moved, moved_arc


class LetteredSketch(Struct, frozen=True, dict=True):
    """A sketch with its labels placed: the drawing is put in order only if it is kept."""

    sketch: Sketch
    labels: Sequence[Label]
    leaders: Sequence[Path]
    doubtful: bool

    @cached_property
    def _box(self) -> tuple[complex, complex]:
        """Lower left and upper right corner of everything."""
        corners = [*self.sketch.corners()] if self.sketch.lines else []
        corners += [point for leader in self.leaders for point in leader.points]
        for label in self.labels:
            half = 0.5 * complex(*label.size)
            corners += [label.at - half, label.at + half]
        low, high = box_about(corners)
        return low - complex(MARGIN, MARGIN), high + complex(MARGIN, MARGIN)

    @property
    def width(self) -> float:
        """The width of the paper (u)."""
        low, high = self._box
        return (high - low).real

    @cached_property
    def drawing(self) -> Drawing:
        """The paper cut to size, everything in order."""
        sketch, (low, high) = self.sketch, self._box
        ordered = sorted([*sketch.lines, *self.leaders], key=lambda line: line.layer)
        plates = [line.points for line in sketch.lines if isinstance(line, Path) and line.fill == "shade"]
        return Drawing(
            high.real - low.real,
            high.imag - low.imag,
            tuple([moved(line, -low) for line in ordered]),
            tuple([_on_paper(x, -low, plates) for x in self.labels]),
            scale=sketch.scale,
            origin=-low,
            beyond=tuple(sketch.beyond),
            lengthened=sketch.lengthened,
            doubtful=self.doubtful,
            rotations=tuple([turn._replace(arc=moved_arc(turn.arc, -low)) for turn in sketch.rotations]),
        )


def finish(sketch: Sketch, named: Mapping[str, complex]) -> Drawing:
    """Place the labels, beside which other places are ``named``, and put everything in order."""
    (found,) = lettered([(sketch, named)])
    return found.drawing


def lettered(sketches: Sequence[tuple[Sketch, Mapping[str, complex]]]) -> list[LetteredSketch]:
    """Several sketches with their labels placed, each with the places that are named beside them."""
    wanted = [
        WantedLabels(sketch.requests, sketch.obstacles.segments(), list(named.values()))
        for sketch, named in sketches
        if sketch.requests
    ]
    placed = iter(place_labels(wanted) if wanted else ())
    return [LetteredSketch(sketch, *(next(placed) if sketch.requests else NOTHING_PLACED)) for sketch, _ in sketches]


def _on_paper(label: Label, by: complex, plates: Sequence[Sequence[complex]]) -> Label:
    """A label moved to its place on the paper; ``plates`` are where it was placed."""
    arrow = None if label.arrow is None else (label.arrow[0] + by, label.arrow[1] + by)
    return Label(label.formula, label.at + by, label.size, _behind(label, plates), arrow)


def _behind(label: Label, plates: Sequence[Sequence[complex]]) -> str:
    """What lies behind a label, which stands clear of the outlines of plates: their shade or paper."""
    return "shade" if any(_surrounds(corners, label.at) for corners in plates) else "paper"


def _surrounds(corners: Sequence[complex], place: complex) -> bool:
    """Whether a polygon has a place inside: a ray to the right crosses its sides an odd number of times."""
    inside = False
    for start, end in zip(corners, (*corners[1:], corners[0]), strict=True):
        low, high = start - place, end - place
        if (low.imag > 0) != (high.imag > 0):
            inside ^= low.real - low.imag * (high.real - low.real) / (high.imag - low.imag) > 0
    return inside
