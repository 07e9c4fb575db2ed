"""A point with a name is marked: by a dot, a hinge, or the end of a line."""

from __future__ import annotations

import pytest

from variantgen.figure.drawing import Layer
from variantgen.figure.inspection.faults import unmarked_points
from variantgen.figure.sketch import DOT, HINGE, Sketch


@pytest.mark.parametrize(("dots", "expected"), [((), ["B"]), ((10 + 0j,), [])])
def test_a_point_in_the_middle_of_a_rod_needs_a_dot(dots: tuple[complex, ...], expected: list[str]) -> None:
    places = {"A": 0j, "B": 10 + 0j, "C": 20 + 0j, "D": 5 + 5j}
    sketch = Sketch(places, 1.0)
    sketch.path((0, 20), Layer.LINK)
    sketch.circle(5 + 5j, HINGE, Layer.HINGE)
    for dot in dots:
        sketch.circle(dot, DOT, Layer.HINGE, fill="ink")
    drawing = sketch.finish({})
    assert unmarked_points(drawing, {name: place + drawing.origin for name, place in places.items()}) == expected
