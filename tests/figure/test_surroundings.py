"""What of a mechanism is drawn about a wheel of radius 30 whose centre is the only point of the figure."""

from __future__ import annotations

import math

import pytest

from variantgen.figure.drawing import Arc, Layer, Line, Path, Strokes
from variantgen.figure.equations.surroundings import Surroundings

WHEEL = Surroundings((0j,), (), ((0j, 30.0),))


def path(*points: complex) -> Path:
    return Path(points, Layer.LINK)


@pytest.mark.parametrize(
    ("line", "drawn"),
    [
        (path(30 - 40j, 30 + 40j), True),  # touches the wheel
        (path(23 - 12.1j, 40 + 17.3j), False),  # crosses its rim at 30 degrees, on more than six units
        (Arc(-60 + 0j, 30.0, Layer.DISC), False),  # the rim of a wheel in contact
        (Arc(-60 + 0j, 30.0, Layer.GROUND, start=-1.0, sweep=2.0), True),  # an arc that it rolls on
        (Arc(0j, 30.0, Layer.DISC), True),  # its own rim
        (path(60 + 0j, 90 + 0j), False),
    ],
)
def test_what_lies_along_a_rim_is_drawn_but_not_what_crosses_it(line: Line, drawn: bool) -> None:
    assert bool(list(WHEEL.pieces([line]))) == drawn


def test_a_piece_of_what_touches_is_as_long_as_it_lies_along_the_rim() -> None:
    (piece,) = WHEEL.pieces([path(30 - 40j, 30 + 40j)])
    assert isinstance(piece, Path)
    half = math.sqrt(31.7**2 - 30**2)  # where the line is 1.7 from the rim
    assert [point.imag for point in piece.points] == pytest.approx([-half, half], abs=0.4)


def test_hatching_is_kept_below_the_rim_alone() -> None:
    feet = [complex(x, -30) for x in range(-40, 41, 2)]
    strokes = Strokes(tuple((foot, foot - 1.5 - 1.5j) for foot in feet), Layer.GROUND)
    (kept,) = WHEEL.pieces([strokes])
    assert isinstance(kept, Strokes)
    assert 3 <= len(kept.segments) <= 10
    assert all(abs(start.real) < 10 for start, _ in kept.segments)
