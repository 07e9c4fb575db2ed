"""Label placement: clear of lines and of other labels where there is room, deterministic."""

from __future__ import annotations

import numpy as np

from variantgen.figure.drawing import Arc, Layer
from variantgen.figure.labels import along_line, around, boxes_crossed, place_labels
from variantgen.wording.formula import Index, Symbol

A, B = Symbol("A"), Symbol("B")


def test_boxes_and_segments() -> None:
    segments = np.array([[-5 + 0j, 5 + 0j], [3 + 3j, 9 + 9j]])
    crossed = boxes_crossed(np.array([0j, 0 + 2j, 4 + 4j, 10 + 0j]), (1.0, 1.0), segments)
    assert crossed.tolist() == [1, 0, 1, 0]


def test_a_label_keeps_off_lines() -> None:
    # A fan of lines fills everything but the lower left.
    fan = [40 * np.exp(1j * angle) for angle in np.linspace(-1.2, 2.8, 40)]
    segments = np.array([[0j, end] for end in fan])
    (label,) = place_labels([around(A, 0j, 1.0)], segments, [0j])
    assert boxes_crossed(np.array([label.at]), (label.size[0] / 2, label.size[1] / 2), segments).tolist() == [0]
    assert label.at.real < 0
    assert label.at.imag < 0


def test_labels_of_coinciding_wishes_are_spread() -> None:
    requests = [around(Symbol(letter), complex(0.5 * i), 1.0) for i, letter in enumerate("ABCDE")]
    labels = place_labels(requests, np.zeros((0, 2), dtype=complex), [])
    for i, one in enumerate(labels):
        for other in labels[:i]:
            gap = one.at - other.at
            assert abs(gap.real) >= 0.5 * (one.size[0] + other.size[0]) or abs(gap.imag) >= 0.5 * (
                one.size[1] + other.size[1]
            )


def test_same_input_same_places() -> None:
    requests = [around(A, 0j, 1.0), along_line(Symbol("omega", (Index("AB"),)), 0j, 20 + 5j), around(B, 20 + 5j, 1.0)]
    segments = np.array([[0j, 20 + 5j]])
    first = place_labels(requests, segments, [0j, 20 + 5j])
    assert place_labels(requests, segments, [0j, 20 + 5j]) == first


def test_bezier_pieces_follow_the_circle() -> None:
    arc = Arc(1 + 2j, 3.0, Layer.MARK, start=0.3, sweep=4.0)
    place = arc.at(0)
    for a, b, end in arc.cubics():
        for t in np.linspace(0, 1, 11):
            point = (1 - t) ** 3 * place + 3 * (1 - t) ** 2 * t * a + 3 * (1 - t) * t**2 * b + t**3 * end
            assert abs(abs(point - arc.centre) - 3.0) < 3 * 3e-4
        place = end
    assert abs(place - arc.at(1)) < 1e-12
