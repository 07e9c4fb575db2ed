"""Velocities by equal projections, against the worked examples of the guide (23, 36) and hand numbers."""

from __future__ import annotations

from math import acos, cos, degrees, radians, sqrt

import pytest
from msgspec.structs import replace

from tests.methods.test_velocity_centre import keys, speed
from tests.solved_cases import case_of, task
from variantgen.methods.agreement import deviation
from variantgen.methods.by_groups import solve_groups
from variantgen.methods.centres import projections
from variantgen.methods.groups.group import Dyad, PointPath
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.methods.steps.step import Projection


def solved(family: str, case: str, names: tuple[str, ...], **changed: float) -> Book:
    found, worked = case_of(family, case)
    worked = replace(worked, given={**worked.given, **changed})
    book = Book(task(found, worked, names), style=MethodStyle("projections", "acceleration_pole"))
    solve_groups.velocities(book)
    assert deviation(book) < 1e-12
    return book


def angles(book: Book) -> list[list[float]]:
    """The angles of the two velocities with the line of their points, equation by equation."""
    lines = [item for step in book.steps for item in step.items if isinstance(item, Projection)]
    return [
        [degrees(acos(share.factor.number(True))) for share in (*line.left, *line.right) if share.factor]
        for line in lines
    ]


def test_example_23() -> None:
    book = solved("ladder", "M23", ("v_B",))
    assert angles(book) == [[pytest.approx(60, rel=1e-13), pytest.approx(30, rel=1e-13)]]
    assert speed(book, "B") == pytest.approx(5 * cos(radians(60)) / cos(radians(30)), rel=1e-14)
    assert "AB" not in book.omega  # nobody asked for it, and the theorem does not give it
    assert "projections.across" not in keys(book)


def test_example_36_goes_on_with_the_components_across() -> None:
    book = solved("two_loop_mechanism", "M36", ("v_B", "v_E", "omega_DE"))
    assert angles(book)[0] == [pytest.approx(60, rel=1e-13), pytest.approx(30, rel=1e-13)]
    assert speed(book, "B") == pytest.approx(0.8 / sqrt(3), rel=1e-13)
    assert speed(book, "E") == pytest.approx(0.8 / sqrt(3), rel=1e-12)
    assert book.omega["DE"].size.exact == pytest.approx(2 / 3, rel=1e-12)
    assert keys(book).count("projections.across") == 2


def test_a_velocity_across_the_line_stops_the_other_point() -> None:
    book = solved("slider_crank", "hand-1", ("v_B",), phi=0.0)
    assert book.velocity["B"] == ()
    assert "projections.nothing" in keys(book)


def test_a_point_at_rest_stops_the_other_point() -> None:
    book = solved("ladder", "M23", ("v_B",), v_A=0.0)
    assert book.velocity["B"] == ()
    assert "projections.at_rest" in keys(book)


def test_a_path_across_the_line_is_left_to_other_methods() -> None:
    found, worked = case_of("ladder", "M23")
    book = Book(task(found, worked, ("v_B",)))
    side = book.geometry.vector("A", "B")
    assert not projections.applies(book, Dyad("AB", "A", PointPath("B", line=1j * side / abs(side))))
    assert projections.applies(book, Dyad("AB", "A", PointPath("B", line=1 + 0j)))
