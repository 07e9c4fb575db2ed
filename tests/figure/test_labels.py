"""Label placement: clear of lines and of other labels where there is room, deterministic."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from variantgen.figure.drawing import Arc, Layer
from variantgen.figure.ink import Segments, boxes_crossed_by, gaps_to_box, spans_of
from variantgen.figure.lettered_sketch import finish
from variantgen.figure.placement.label_requests import LabelRequest, along_arrow, along_line, around
from variantgen.figure.placement.labels import PlacedLabels, WantedLabels, place_labels
from variantgen.figure.placement.occupancy import CELL, Occupancy
from variantgen.figure.sketch import Sketch
from variantgen.wording.formula import Index, Symbol

A, B = Symbol("A"), Symbol("B")


def placed(
    requests: Sequence[LabelRequest], segments: NDArray[np.complex128], strangers: Sequence[complex]
) -> PlacedLabels:
    """The labels of one figure."""
    (found,) = place_labels([WantedLabels(requests, segments, strangers)])
    return found


def boxes_crossed(
    places: NDArray[np.complex128], half_sides: tuple[float, float], segments: Segments
) -> NDArray[np.int64]:
    """How many segments cross the box about each place."""
    return boxes_crossed_by(spans_of(segments), places, half_sides)


def test_boxes_and_segments() -> None:
    segments = np.array([[-5 + 0j, 5 + 0j], [3 + 3j, 9 + 9j]])
    crossed = boxes_crossed(np.array([0j, 0 + 2j, 4 + 4j, 10 + 0j]), (1.0, 1.0), segments)
    assert crossed.tolist() == [1, 0, 1, 0]


def test_a_label_keeps_off_lines() -> None:
    # A fan of lines fills everything but the lower left.
    fan = [40 * np.exp(1j * angle) for angle in np.linspace(-1.2, 2.8, 40)]
    segments = np.array([[0j, end] for end in fan])
    (label,), leaders, _ = placed([around(A, 0j, 1.0)], segments, [0j])
    assert not leaders
    assert boxes_crossed(np.array([label.at]), (label.size[0] / 2, label.size[1] / 2), segments).tolist() == [0]
    assert label.at.real < 0
    assert label.at.imag < 0


def test_labels_of_coinciding_wishes_are_spread() -> None:
    requests = [around(Symbol(letter), complex(0.5 * i), 1.0) for i, letter in enumerate("ABCDE")]
    labels = placed(requests, np.zeros((0, 2), dtype=complex), []).labels
    for i, one in enumerate(labels):
        for other in labels[:i]:
            gap = one.at - other.at
            assert abs(gap.real) >= 0.5 * (one.size[0] + other.size[0]) or abs(gap.imag) >= 0.5 * (
                one.size[1] + other.size[1]
            )


def test_same_input_same_places() -> None:
    requests = [around(A, 0j, 1.0), along_line(Symbol("omega", (Index("AB"),)), 0j, 20 + 5j), around(B, 20 + 5j, 1.0)]
    segments = np.array([[0j, 20 + 5j]])
    first = placed(requests, segments, [0j, 20 + 5j])
    assert placed(requests, segments, [0j, 20 + 5j]) == first


def test_a_label_without_room_is_led_to() -> None:
    # Short strokes all around the point leave no free place near it.
    ways = np.exp(1j * np.linspace(0, 2 * np.pi, 60, endpoint=False))
    segments = np.stack((1.5 * ways, 9.0 * ways), axis=1)
    (label,), (leader,), _ = placed([around(A, 0j, 1.0)], segments, [0j])
    half = (label.size[0] / 2, label.size[1] / 2)
    assert boxes_crossed(np.array([label.at]), half, segments).tolist() == [0]
    # The leader begins at the symbol, points at its centre, and ends at the letter.
    start, end = leader.points
    assert 1.0 <= abs(start) <= 2.0
    assert abs((end * np.conj(start)).imag) < 1e-9
    assert gaps_to_box(label.at, half, np.array([[end, end]]))[0] < 0.5


def test_gaps_of_segments_and_boxes() -> None:
    segments = np.array([[5 + 0j, 9 + 0j], [-1 + 3j, 1 + 3j], [4 + 5j, 5 + 4j], [-9 - 9j, 9 + 9j]])
    expected = [5 - 2, 3 - 1, np.sqrt(2) * (9 - 3) / 2, 0.0]
    assert np.allclose(gaps_to_box(0j, (2.0, 1.0), segments), expected)


@given(st.lists(st.tuples(*[st.floats(-40, 40)] * 4), min_size=1, max_size=30), st.integers(0, 2**32 - 1))
def test_no_ink_is_missed_by_the_grid(ends: list[tuple[float, float, float, float]], seed: int) -> None:
    segments = np.array([[complex(a, b), complex(c, d)] for a, b, c, d in ends])
    rng = np.random.default_rng(seed)
    places = rng.uniform(-50, 50, 200) + 1j * rng.uniform(-50, 50, 200)
    half = rng.uniform(0.5, 4.0, (200, 2))
    found = Occupancy([segments]).taken(places, half[:, 0], half[:, 1])
    for place, (hx, hy), cells in zip(places, half, found, strict=True):
        crossed = boxes_crossed(np.array([place]), (hx, hy), segments)[0]
        # The corner of a cell may be cut unseen; nothing else is missed, and nothing far is counted.
        if boxes_crossed(np.array([place]), (hx - 0.05, hy - 0.05), segments)[0]:
            assert cells
        if not boxes_crossed(np.array([place]), (hx + CELL, hy + CELL), segments)[0]:
            assert not cells
        assert crossed or not cells or np.min(gaps_to_box(place, (hx, hy), segments)) <= 1.5 * CELL


def test_bezier_pieces_follow_the_circle() -> None:
    arc = Arc(1 + 2j, 3.0, Layer.MARK, start=0.3, sweep=4.0)
    place = arc.at(0)
    for a, b, end in arc.cubics():
        for t in np.linspace(0, 1, 11):
            point = (1 - t) ** 3 * place + 3 * (1 - t) ** 2 * t * a + 3 * (1 - t) * t**2 * b + t**3 * end
            assert abs(abs(point - arc.centre) - 3.0) < 3 * 3e-4
        place = end
    assert abs(place - arc.at(1)) < 1e-12


def test_the_letter_of_an_arrow_is_led_to_rather_than_far_away() -> None:
    # Lines on both sides leave only places beyond them, and before the head stands another arrow.
    v = [Symbol("v", (Index(letter),)) for letter in "AB"]
    arrows = [along_arrow(v[0], 0j, 5 + 0j), along_arrow(v[1], 9 + 0j, 20 + 0j)]
    walls = [(-3 + 1j * y, 8 + 1j * y) for y in (1.5, -1.5, 4.0, -4.0)] + [(8 - 9j, 8 + 9j)]
    (label, _), leaders, _ = placed(arrows, np.array([(0, 5), (9, 20), *walls]), [])
    assert label.formula == v[0]
    assert [leader.points[0] for leader in leaders] == [5 + 0j]


def test_a_label_on_a_plate_has_the_shade_behind_it() -> None:
    corners = (0j, 40 + 0j, 40j)
    sketch = Sketch({"A": 12 + 12j, "B": 30 + 30j}, 1.0)
    sketch.path(corners, Layer.DISC, closed=True, fill="shade")
    sketch.label(around(A, 12 + 12j, 1.0))
    sketch.label(around(B, 30 + 30j, 1.0))
    assert [label.paper for label in finish(sketch, {}).labels] == ["shade", "paper"]
