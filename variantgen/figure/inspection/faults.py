"""What is wrong with a finished figure, as far as a program can see it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations, pairwise

import numpy as np
from msgspec import Struct

from variantgen.figure.drawing import Arc, Drawing, Label, Layer, Line, Path
from variantgen.figure.ink import boxes_crossed_by, gaps_to_box, segments_of, spans_of
from variantgen.wording.formula import to_plain

# A figure much longer than wide (or the other way round) does not fit beside its statement.
_LONGEST = 5.0
_AT_POINT = 0.1  # distance of a mark from the point that it marks, u
_COVERED, _OTHER_PLACE = 1.6, 3.0  # how near to a tip nothing else is to lie; between places of arrows, u
WIDEST, HIGHEST = 108.0, 106.0  # limits of a figure, u


class Inspection(Struct, frozen=True):
    """The labels of a figure: which cover what, how many have a leader, and the smallest free space around one (u)."""

    overlaps: tuple[tuple[str, str], ...]
    crossed: tuple[str, ...]
    outside: tuple[str, ...]
    leaders: int
    clearance: float


def leaders(drawing: Drawing) -> list[Path]:
    """The thin lines that lead from labels to what they name."""
    return [line for line in drawing.lines if isinstance(line, Path) and line.layer == Layer.LABEL]


def inspect_labels(drawing: Drawing) -> Inspection:
    """Labels that cover each other, are crossed by a line (half its weight counts) or leave the paper."""
    names = [to_plain(label.formula) for label in drawing.labels]
    overlaps = [
        (names[i], names[j])
        for (i, first), (j, second) in combinations(enumerate(drawing.labels), 2)
        if _gap(first, second) <= 0
    ]
    gaps = [_gap(first, second) for first, second in combinations(drawing.labels, 2)]
    segments, weights = _weighted(drawing.lines)
    crossed = []
    for name, label in zip(names, drawing.labels, strict=True):
        free = _free_space(label, segments, weights, leaders(drawing))
        gaps.append(free)
        if free <= 0:
            crossed.append(name)
    outside = [name for name, label in zip(names, drawing.labels, strict=True) if _leaves(label, drawing)]
    return Inspection(
        tuple(overlaps), tuple(crossed), tuple(outside), len(leaders(drawing)), float(min(gaps, default=np.inf))
    )


def count_label_faults(drawing: Drawing) -> int:
    """How many faults :func:`inspect_labels` would name; cheap, because only lines near a label are looked at."""
    places = np.array([label.at for label in drawing.labels], dtype=complex)
    half = 0.5 * np.array([label.size for label in drawing.labels]).reshape(-1, 2)
    step = np.abs(places[:, None].real - places.real), np.abs(places[:, None].imag - places.imag)
    covers = (step[0] <= half[:, :1] + half[:, 0]) & (step[1] <= half[:, 1:] + half[:, 1])
    overlaps = (int(np.sum(covers)) - len(places)) // 2
    segments, weights = _weighted(drawing.lines)
    near = boxes_crossed_by(spans_of(segments), places, (half[:, :1] + weights, half[:, 1:] + weights))
    own = leaders(drawing)
    crossed = sum(_free_space(drawing.labels[i], segments, weights, own) <= 0 for i in np.flatnonzero(near))
    return overlaps + crossed + sum(_leaves(label, drawing) for label in drawing.labels)


def arrows_of(lines: Sequence[Line]) -> list[tuple[complex, complex, float]]:
    """Start, tip and length of the head of the straight arrows: a stroke followed by a filled triangle at its end."""
    found = []
    for shaft, head in pairwise(lines):
        if not isinstance(shaft, Path) or not isinstance(head, Path):
            continue  # an arc of rotation has a head too
        if len(shaft.points) == 2 and len(head.points) == 3 and head.closed and head.fill == "ink":
            tip, *wings = head.points
            found.append((shaft.points[0], tip, abs(tip - 0.5 * sum(wings))))
    return found


def short_arrows(drawing: Drawing) -> list[tuple[complex, complex]]:
    """Starts and tips of the arrows that are shorter than twice their heads."""
    return [(start, tip) for start, tip, head in arrows_of(drawing.lines) if abs(tip - start) < 2 * head - 1e-9]


def misread_labels(drawing: Drawing) -> list[str]:
    """Names of arrows that stand nearer to another arrow than to their own; a leader shows what is named."""
    named = [label for label in drawing.labels if label.arrow is not None]
    arrows = list(dict.fromkeys(label.arrow for label in named if label.arrow is not None))
    if len(arrows) < 2:
        return []
    places = np.array([[label.at] for label in named])
    half = 0.5 * np.array([label.size for label in named])
    sides = half[:, :1], half[:, 1:]
    gaps = gaps_to_box(places, sides, np.array(arrows))
    mine = (np.arange(len(named)), [arrows.index(label.arrow) for label in named if label.arrow is not None])
    own = gaps[mine] - 1e-6
    gaps[mine] = np.inf
    misread = np.minimum.reduce(gaps, axis=1) < own
    ends = np.array([[line.points[-1]] * 2 for line in leaders(drawing)], dtype=complex).reshape(-1, 2)
    if misread.any():
        misread &= ~(gaps_to_box(places, sides, ends) < 1.0).any(axis=1)
    return [to_plain(named[i].formula) for i in np.flatnonzero(misread)]


def buried_heads(lines: Sequence[Line]) -> list[tuple[complex, complex]]:
    """Starts and tips of the arrows whose heads lie on the hinge of another point or on an arrow from another place."""
    arrows = arrows_of(lines)
    hinges = [line.centre for line in lines if isinstance(line, Arc) and line.layer == Layer.HINGE] if arrows else []
    return [
        (start, tip)
        for start, tip, _ in arrows
        if any(abs(tip - hinge) < _COVERED and abs(hinge - start) > _OTHER_PLACE for hinge in hinges)
        or any(abs(other - start) > _OTHER_PLACE and _distance(tip, other, end) < _COVERED for other, end, _ in arrows)
    ]


def _distance(place: complex, start: complex, end: complex) -> float:
    """The distance of a place from a segment."""
    part = ((place - start) / (end - start)).real
    return abs(place - start - min(max(part, 0.0), 1.0) * (end - start))


def unmarked_points(drawing: Drawing, places: Mapping[str, complex]) -> list[str]:
    """Names of points (places on paper, u) at which no line begins, ends or bends and no circle is centred."""
    marks: list[complex] = []
    for line in drawing.lines:
        if isinstance(line, Path):
            marks += line.points
        elif isinstance(line, Arc):
            marks.append(line.centre)
    known = np.array(marks)
    return [name for name, place in places.items() if not len(known) or np.min(np.abs(known - place)) > _AT_POINT]


def figure_faults(drawing: Drawing) -> list[str]:
    """Faults of the labels and extreme proportions, in words."""
    seen = inspect_labels(drawing)
    found = [f"the label {name} leaves the figure" for name in seen.outside]
    found += [f"the labels {first} and {second} cover each other" for first, second in seen.overlaps]
    found += [f"the label {name} lies on a line" for name in seen.crossed]
    if max(drawing.width, drawing.height) > _LONGEST * min(drawing.width, drawing.height):
        found.append(f"the figure is {drawing.width:.0f} by {drawing.height:.0f} units: too long")
    if drawing.width > WIDEST or drawing.height - drawing.graphs > HIGHEST:
        found.append(f"the figure is {drawing.width:.0f} by {drawing.height:.0f} units: too large")
    return found


def vector_faults(drawing: Drawing) -> list[str]:
    """Faults of the arrows of a figure of motion and of their names, in words."""
    found = [
        f"an arrow of {abs(tip - start):.1f} units is shorter than twice its head"
        for start, tip in short_arrows(drawing)
    ]
    found += [f"the label {name} stands nearer to another arrow than to its own" for name in misread_labels(drawing)]
    return found + [f"the point {to_plain(letter)} lies outside the figure" for letter in drawing.beyond]


def _weighted(lines: tuple[Line, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Segments of all lines, shape (S, 2), and half the weight of each, shape (S,)."""
    segments, counts = segments_of(lines)
    return segments, np.repeat([0.5 * line.weight for line in lines], counts)


def _free_space(label: Label, segments: np.ndarray, weights: np.ndarray, own: list[Path]) -> float:
    """Distance of a label from the nearest line but its own leader (which ends at its box)."""
    half = (0.5 * label.size[0], 0.5 * label.size[1])
    gaps = gaps_to_box(label.at, half, segments) - weights
    for leader in own:
        if gaps_to_box(label.at, half, np.array([[leader.points[-1], leader.points[-1]]]))[0] < 1.0:
            mine = np.all(np.isin(segments, leader.points), axis=1)
            gaps = np.where(mine, np.inf, gaps)
    return float(np.min(gaps, initial=np.inf))


def _leaves(label: Label, drawing: Drawing) -> bool:
    half_width, half_height = 0.5 * label.size[0], 0.5 * label.size[1]
    across = half_width <= label.at.real <= drawing.width - half_width
    return not (across and half_height <= label.at.imag <= drawing.height - half_height)


def _gap(first: Label, second: Label) -> float:
    """Free space between two labels; zero or less where they cover each other."""
    step = first.at - second.at
    dx = abs(step.real) - 0.5 * (first.size[0] + second.size[0])
    dy = abs(step.imag) - 0.5 * (first.size[1] + second.size[1])
    return max(dx, dy) if dx <= 0 or dy <= 0 else float(np.hypot(dx, dy))
