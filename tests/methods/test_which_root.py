"""Which of two triangles on three sides is meant: on which side of a line the point lies."""

from __future__ import annotations

import pytest

from tests.methods.given_data import worked_geometry


@pytest.mark.parametrize(
    ("data", "key"),
    [
        # A(0; 30), C(60; 0): left of the way from A to C is above the line.
        ({"OA": 30, "OC": 60, "phi": 90, "AB": 45, "BC": 44, "side": 1}, "position.triangle_sides_above"),
        ({"OA": 30, "OC": 60, "phi": 90, "AB": 45, "BC": 44, "side": -1}, "position.triangle_sides_below"),
        # A(41.04; 28.19), C(50; 0): a steep line, left of the way down is to the right of it.
        ({"OA": 50, "OC": 50, "phi": 35, "AB": 45, "BC": 44, "side": 1}, "position.triangle_sides_right"),
        ({"OA": 50, "OC": 50, "phi": 35, "AB": 45, "BC": 44, "side": -1}, "position.triangle_sides_left"),
        # AC = 67.08 cm of 45 + 24 cm: B is 6.4 cm from AC, a tenth of the mechanism; of 45 + 22.1 it would not be seen.
        ({"OA": 30, "OC": 60, "phi": 90, "AB": 45, "BC": 22.1, "side": 1}, "position.triangle_sides"),
    ],
)
def test_the_side_of_a_line_is_said_where_it_is_seen(data: dict[str, float], key: str) -> None:
    said = [item.key for item in worked_geometry("four_bar", "crank", "v_B", **data)]
    assert [found for found in said if found.startswith("position.triangle_sides")] == [key]
