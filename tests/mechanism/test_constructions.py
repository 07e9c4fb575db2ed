"""Each construction against an independent formula (mpmath with 60 digits, or the definition)."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.mechanism.component import discover
from variantgen.mechanism.constructions.circle_circle import CircleCircle, sixteen_area_squared
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.foot import Foot
from variantgen.mechanism.constructions.fraction import SegmentFraction
from variantgen.mechanism.constructions.line_circle import LineCircle
from variantgen.mechanism.constructions.line_line import LineLine
from variantgen.mechanism.constructions.on_body import OnBody
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.constructions.tangent import Tangent

AT = {"A": 1 + 2j, "B": 4 + 6j, "C": -1 + 0.5j}
LENGTH = st.floats(0.05, 20)
ANGLE = st.floats(-math.pi, math.pi)


def test_every_construction_of_the_folder_is_tested_here() -> None:
    tested = {
        "circle_circle",
        "coordinates",
        "foot",
        "fraction",
        "line_circle",
        "line_line",
        "near",
        "on_body",
        "polar",
        "tangent",
    }
    assert set(discover("variantgen.mechanism.constructions")) == tested


def test_coordinates() -> None:
    z, exists = Coordinates(0.3, -0.7).place({})
    assert z == 0.3 - 0.7j
    assert exists is True


@given(LENGTH, ANGLE)
def test_polar_has_the_distance_and_the_angle(distance: float, angle: float) -> None:
    z, exists = Polar("A", distance, angle).place(AT)
    assert exists is True
    assert abs(z - AT["A"]) == pytest.approx(distance)
    assert complex(z - AT["A"]) == pytest.approx(distance * complex(math.cos(angle), math.sin(angle)), abs=1e-12)


def test_polar_towards_counts_the_angle_from_the_ray() -> None:
    # A -> B is (3, 4)/5; a quarter turn to the left of it is (-4, 3)/5.
    z, _ = Polar("A", 10.0, math.pi / 2, "B").place(AT)
    assert complex(z) == pytest.approx(AT["A"] + 10 * complex(-0.8, 0.6))


def test_right_angles_are_exact() -> None:
    z, _ = Polar("O", 2.0, math.pi / 2).place({"O": 0j})
    assert complex(z) == 2j


def test_on_body_along_and_to_the_left() -> None:
    z, _ = OnBody("A", "B", 5.0, 10.0).place(AT)
    assert complex(z) == pytest.approx(AT["A"] + complex(3, 4) + 2 * complex(-4, 3))


@given(st.floats(-2, 3))
def test_fraction_divides_the_segment(part: float) -> None:
    z, _ = SegmentFraction("A", "B", part).place(AT)
    assert complex(z) == pytest.approx(AT["A"] + part * (AT["B"] - AT["A"]))


@given(LENGTH, LENGTH, st.sampled_from([1.0, -1.0]))
def test_circle_circle_keeps_both_distances_and_the_side(first: float, second: float, side: float) -> None:
    z, meets = CircleCircle("A", first, "B", second, side).place(AT)
    gap = abs(AT["B"] - AT["A"])
    if abs(first - second) < gap * (1 - 1e-9) and first + second > gap * (1 + 1e-9):
        assert meets
        assert abs(z - AT["A"]) == pytest.approx(first)
        assert abs(z - AT["B"]) == pytest.approx(second)
        turn = (np.conj(AT["B"] - AT["A"]) * (z - AT["A"])).imag
        assert side * turn >= 0
    elif first + second < gap * (1 - 1e-9) or abs(first - second) > gap * (1 + 1e-9):
        assert not meets
        assert np.isfinite(z)


def test_needle_triangle_keeps_the_digits_that_its_data_have() -> None:
    # Sides whose naive formula loses every digit; reference with 60 digits on the same doubles.
    a, b, c = 1.0, 0.75, 0.25 + 1e-13
    with mp.workdps(60):
        s = (mp.mpf(a) + b + c) / 2
        exact = 16 * s * (s - a) * (s - b) * (s - c)
        assert abs(mp.mpf(float(sixteen_area_squared(a, b, c))) / exact - 1) < 1e-14


@given(LENGTH, ANGLE, st.sampled_from([1.0, -1.0]))
def test_line_circle_is_on_the_line_at_the_distance(distance: float, angle: float, branch: float) -> None:
    z, meets = LineCircle("C", "A", distance, angle, branch=branch).place(AT)
    way = complex(math.cos(angle), math.sin(angle))
    height = abs((np.conj(way) * (AT["A"] - AT["C"])).imag)
    if distance > height * (1 + 1e-6) + 1e-9:
        assert meets
        assert (np.conj(way) * (z - AT["C"])).imag == pytest.approx(0, abs=1e-9)
        assert abs(z - AT["A"]) == pytest.approx(distance)
        assert branch * (np.conj(way) * (z - AT["A"])).real >= -1e-9
    elif distance < height * (1 - 1e-6):
        assert not meets


@given(ANGLE, ANGLE)
def test_line_line_is_on_both_lines(first: float, second: float) -> None:
    z, crosses = LineLine("A", "B", first, second).place(AT)
    if abs(math.sin(first - second)) > 1e-3:
        assert crosses
        for point, angle in (("A", first), ("B", second)):
            assert (np.exp(-1j * angle) * (z - AT[point])).imag == pytest.approx(0, abs=1e-9)


def test_parallel_lines_do_not_cross() -> None:
    z, crosses = LineLine("A", "B", 0.3, 0.3).place(AT)
    assert not crosses
    assert np.isfinite(z)


@given(ANGLE)
def test_foot_is_on_the_line_and_the_way_to_it_is_across(angle: float) -> None:
    z, _ = Foot("A", "B", angle).place(AT)
    way = np.exp(1j * angle)
    assert (np.conj(way) * (z - AT["B"])).imag == pytest.approx(0, abs=1e-9)
    assert (np.conj(way) * (AT["A"] - z)).real == pytest.approx(0, abs=1e-9)


@given(st.floats(0.1, 2), st.sampled_from([1.0, -1.0]), st.floats(0, 2), st.sampled_from([1.0, -1.0]))
def test_thread_touches_both_drums(radius: float, side: float, other: float, other_side: float) -> None:
    start, exists = Tangent("A", radius, side, "B", other, other_side).place(AT)
    # The same thread seen from the other end: its left is our right.
    end, _ = Tangent("B", other, -other_side, "A", radius, -side).place(AT)
    assert exists
    assert abs(start - AT["A"]) == pytest.approx(radius)
    assert abs(end - AT["B"]) == pytest.approx(other, abs=1e-12)
    way = (end - start) / abs(end - start)
    assert (np.conj(way) * (start - AT["A"])).real == pytest.approx(0, abs=1e-9)
    assert (np.conj(way) * (start - AT["A"])).imag == pytest.approx(side * radius)


def test_a_thread_needs_room_between_the_drums() -> None:
    _, exists = Tangent("A", 4.0, 1.0, "B", 3.0, -1.0).place(AT)
    assert not exists
