"""Velocities by the velocity centre, against the worked examples of the guide (23-29, 32, 36) and hand numbers."""

from __future__ import annotations

from math import asin, cos, radians, sin, sqrt, tan

import pytest
from msgspec.structs import replace

from tests.methods.given_data import worked_book
from tests.solved_cases import case_of, task
from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.methods.agreement import deviation
from variantgen.methods.by_groups import solve_groups
from variantgen.methods.centres.known_centre import divide
from variantgen.methods.centres.velocity_centre import carry, distance
from variantgen.methods.solution.book import Book, Rate, resultant
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.methods.steps.step import Sentence, Term
from variantgen.methods.vectors import given_motion
from variantgen.methods.vectors.points import vector
from variantgen.outputs.single.explanation import explain
from variantgen.single import one_variant

STYLE = MethodStyle("velocity_centre", "acceleration_pole")


def book_of(family: str, case: str, names: tuple[str, ...], **changed: float) -> Book:
    """The book of a case, with some given numbers (SI) changed, before anything is worked out."""
    found, worked = case_of(family, case)
    return Book(task(found, replace(worked, given={**worked.given, **changed}), names), style=STYLE)


def solved(family: str, case: str, names: tuple[str, ...], **changed: float) -> Book:
    book = book_of(family, case, names, **changed)
    solve_groups.velocities(book)
    assert deviation(book) < 1e-12
    return book


def speed(book: Book, point: str) -> float:
    return abs(resultant(book.velocity[point]))


def keys(book: Book) -> list[str]:
    return [item.key for step in book.steps for item in step.items if isinstance(item, Sentence)]


def arm(book: Book, body: str, point: str) -> float:
    return book.centres["P", body].rays[point].arm.exact


def test_examples_23_and_25_the_perpendiculars_meet_in_the_corner_of_a_rectangle() -> None:
    book = solved("ladder", "M23", ("v_B", "omega_AB", "v_C"))
    assert arm(book, "AB", "A") == pytest.approx(sqrt(3), rel=1e-14)
    assert arm(book, "AB", "B") == pytest.approx(1, rel=1e-14)
    assert arm(book, "AB", "C") == pytest.approx(1, rel=1e-14)
    assert book.omega["AB"].size.exact == pytest.approx(5 / sqrt(3), rel=1e-14)
    assert book.omega["AB"].sense == 1  # A goes down on the left of P
    assert speed(book, "B") == pytest.approx(5 / sqrt(3), rel=1e-14)
    # C is half the sides of the rectangle to the left of P and below it.
    assert resultant(book.velocity["C"]) == pytest.approx(5 / sqrt(3) * (0.5 - 0.5j * sqrt(3)), rel=1e-13)
    assert "perpendiculars.right_at_centre" in keys(book)


def test_example_24_the_contact_of_a_wheel() -> None:
    book = solved("rolling_wheel", "M24", ("v_A", "v_B", "v_D", "v_P", "v_M"))
    assert (book.omega["wheel"].size.exact, book.omega["wheel"].sense) == (4, -1)
    assert resultant(book.velocity["A"]) == pytest.approx(2 + 2j, rel=1e-14)
    assert resultant(book.velocity["D"]) == pytest.approx(2 - 2j, rel=1e-14)
    assert resultant(book.velocity["B"]) == pytest.approx(4, rel=1e-14)
    assert book.velocity["P"] == ()
    # M is 45 degrees in front of the top: PM = 2 R cos 22.5 degrees.
    assert speed(book, "M") == pytest.approx(4 * 2 * 0.5 * cos(radians(22.5)), rel=1e-14)
    # That the contact is the centre is said with the condition of rolling, and not again.
    assert keys(book).count("rolling.omega") == 1
    assert "known_centre.named_contact" not in keys(book)


def test_example_26_an_equilateral_triangle() -> None:
    book = solved("four_bar", "M26", ("v_B", "omega_AB", "omega_BC", "v_M"))
    assert (arm(book, "AB", "A"), arm(book, "AB", "B")) == (pytest.approx(40), pytest.approx(40))
    assert book.omega["AB"].size.exact == pytest.approx(1, rel=1e-13)
    assert book.omega["BC"].size.exact == pytest.approx(1, rel=1e-13)
    assert speed(book, "B") == pytest.approx(40, rel=1e-13)
    assert speed(book, "M") == pytest.approx(20 * sqrt(3), rel=1e-13)
    assert "perpendiculars.equilateral" in keys(book)


def test_example_27_the_contact_of_a_planet_gear() -> None:
    book = solved("planetary_pair", "M27", ("v_B",))
    assert book.omega["gear1"].size.exact == pytest.approx(10, rel=1e-14)
    assert speed(book, "B") == pytest.approx(50 * sqrt(2), rel=1e-13)
    assert "gears.rest_v" in keys(book)  # says already that the contact is the velocity centre
    assert "known_centre.contact" not in keys(book)


def test_example_28_a_centre_at_infinity() -> None:
    book = solved("slider_crank_with_second_rod", "M28", ("v_B", "v_C", "omega_AB", "omega_BC"))
    assert book.centres["P", "AB"].infinite
    assert (book.omega["AB"].size.exact, book.omega["AB"].sense) == (0.0, 0)  # not merely small
    assert speed(book, "B") == pytest.approx(40, rel=1e-15)
    assert arm(book, "BC", "B") == pytest.approx(30, rel=1e-14)
    assert arm(book, "BC", "C") == pytest.approx(10 * sqrt(3), rel=1e-14)
    assert book.omega["BC"].size.exact == pytest.approx(4 / 3, rel=1e-14)
    assert speed(book, "C") == pytest.approx(40 / sqrt(3), rel=1e-14)


def test_distance_from_a_centre_at_infinity() -> None:
    book = solved("slider_crank_with_second_rod", "M28", ("omega_AB",))
    assert distance(book, "AB", "A").exact == float("inf")


@pytest.mark.parametrize(("below", "omega", "middle"), [(4, 20, 6), (-4, 60, 2)], ids=["one sense", "opposite"])
def test_example_29_the_line_of_the_points_is_divided(below: float, omega: float, middle: float) -> None:
    # The rim points D, 8 m/s upwards, and G, on the other side of the pulley of the radius 0.1 m.
    book = book_of("movable_pulley", "M29", ("v_C",))
    for point, rate in (("D", 8.0), ("G", float(below))):
        angle = Value(None, "angle", 90.0 if rate > 0 else -90.0)
        size = Value(Name("v", point), "velocity", abs(rate))
        book.velocity[point] = (Term(Name("v", point), size, angle, Sentence("ways.given")),)
    with book.step("velocity_centre.link"):
        rate = divide(book, "pulley", "G", "D")
    assert rate.size.exact == pytest.approx(omega, rel=1e-14)
    assert rate.sense == -1  # D, on the left, rises faster
    assert arm(book, "pulley", "D") == pytest.approx(8 / omega, rel=1e-14)
    assert arm(book, "pulley", "G") == pytest.approx(4 / omega, rel=1e-14)
    assert resultant(vector(book.at(1, carry), "C")) == pytest.approx(1j * middle, rel=1e-13)


def test_equal_velocities_across_the_line_of_the_points_are_a_translation() -> None:
    book = book_of("movable_pulley", "M29", ("v_C",))
    for point in ("D", "G"):
        size = Value(Name("v", point), "velocity", 8.0)
        book.velocity[point] = (Term(Name("v", point), size, Value(None, "angle", 90.0), Sentence("ways.given")),)
    with book.step("velocity_centre.link"):
        assert divide(book, "pulley", "D", "G").sense == 0
    assert book.centres["P", "pulley"].infinite


def test_a_rim_point_at_rest_is_the_centre() -> None:
    book = book_of("movable_pulley", "M29", ("v_C",))
    book.velocity["G"] = ()
    size = Value(Name("v", "D"), "velocity", 3.0)
    book.velocity["D"] = (Term(Name("v", "D"), size, Value(None, "angle", 90.0), Sentence("ways.given")),)
    with book.step("velocity_centre.link"):
        rate = divide(book, "pulley", "G", "D")
    assert (rate.size.exact, rate.sense) == (pytest.approx(15, rel=1e-14), -1)
    assert book.centres["P", "pulley"].at == "G"


def test_example_32_the_angular_velocity_of_the_ladder() -> None:
    book = solved("ladder", "M32", ("omega_AB",))
    assert book.omega["AB"].size.exact == pytest.approx(2 * sqrt(3), rel=1e-13)


def test_example_36_a_point_in_the_middle_leads_on() -> None:
    book = solved("two_loop_mechanism", "M36", ("v_E", "omega_AB", "omega_DE"))
    assert arm(book, "AB", "A") == pytest.approx(1.4 * cos(radians(30)), rel=1e-13)
    assert arm(book, "AB", "B") == pytest.approx(0.7, rel=1e-13)
    assert arm(book, "AB", "D") == pytest.approx(0.7, rel=1e-13)
    assert arm(book, "DE", "D") == pytest.approx(1.2 / (2 * cos(radians(30))), rel=1e-12)
    assert book.omega["AB"].size.exact == pytest.approx(8 / (7 * sqrt(3)), rel=1e-13)
    assert book.omega["DE"].size.exact == pytest.approx(2 / 3, rel=1e-12)
    assert [speed(book, p) for p in "BDE"] == pytest.approx([0.8 / sqrt(3)] * 3, rel=1e-12)
    assert {"centre.equilateral", "perpendiculars.isosceles"} <= set(keys(book))


def test_at_a_dead_centre_the_slider_is_the_centre() -> None:
    book = solved("slider_crank", "hand-1", ("v_B", "omega_AB"), phi=0.0)
    crank, rod = (book.task.given[name].exact for name in ("OA", "AB"))
    assert book.velocity["B"] == ()
    assert book.centres["P", "AB"].at == "B"
    assert book.omega["AB"].size.exact == pytest.approx(book.omega["OA"].size.exact * crank / rod, rel=1e-13)
    assert book.omega["AB"].sense == -book.omega["OA"].sense


def test_a_body_whose_pole_stands_still_is_at_rest() -> None:
    book = solved("ladder", "M23", ("v_B", "omega_AB"), v_A=0.0)
    assert book.velocity["B"] == ()
    assert book.omega["AB"].sense == 0
    assert "velocity_centre.at_rest" in keys(book)


@pytest.mark.parametrize("off", [1e-2, 1e-4, 1e-6])
def test_a_centre_far_away_costs_no_more_digits_than_it_is_far(off: float) -> None:
    book = book_of("slider_crank_with_second_rod", "M28", ("v_B", "omega_AB"), phi=radians(90 + off))
    book = Book(book.task, style=replace(STYLE, strict=True))  # else a vector equation takes its place
    solve_groups.velocities(book)
    far = arm(book, "AB", "A") / book.task.size
    assert far > 0.3 / radians(off) / 10
    assert deviation(book) < 1e-9
    assert book.omega["AB"].size.exact == pytest.approx(abs(book.exact_rate("AB")), rel=1e-15 * far + 1e-12)


@pytest.mark.parametrize(("phi", "remote"), [(60, False), (70, False), (78, True), (85, True)])
def test_a_remote_centre_is_not_looked_for_unless_it_is_wished(phi: float, remote: bool) -> None:
    """With OA = 10 and AB = 30 AP is ``AB cos(psi) / cos(phi)``, some 4.5 AB at 78 degrees and 2.8 AB at 70."""
    data = {"OA": 10, "AB": 30, "phi": phi, "omega_OA": 2}
    psi = asin(sin(radians(phi)) / 3)
    assert (cos(psi) / cos(radians(phi)) > 4) == remote
    book = worked_book("slider_crank", "central", "v_B omega_AB", **data)
    assert (("P", "AB") in book.centres) != remote
    assert speed(book, "B") == pytest.approx(20 * sin(radians(phi) + psi) / cos(psi))
    assert book.omega["AB"].size.exact == pytest.approx(20 * cos(radians(phi)) / (30 * cos(psi)))
    assert ("pole.choose_v" in keys(book)) == remote


@pytest.mark.parametrize(("phi", "beside"), [(2, True), (5, False)])
def test_a_centre_beside_a_hinge_is_not_looked_for(phi: float, beside: bool) -> None:
    """P is on OA, above or below B: BP is ``OB tan(phi)``, with OA = 10 and AB = 30 1.4 at 2 degrees and 3.5 at 5."""
    psi = asin(sin(radians(phi)) / 3)
    length = (10 * cos(radians(phi)) + 30 * cos(psi)) * tan(radians(phi))
    assert (length < 0.07 * 30) == beside
    book = worked_book("slider_crank", "central", "v_B omega_AB", OA=10, AB=30, phi=phi, omega_OA=2)
    assert (("P", "AB") in book.centres) != beside
    assert ("pole.choose_v" in keys(book)) == beside
    assert speed(book, "B") == pytest.approx(20 * sin(radians(phi) + psi) / cos(psi))


def test_where_only_the_velocity_is_asked_the_projections_give_it() -> None:
    book = worked_book("slider_crank", "central", "v_B", OA=10, AB=30, phi=60, omega_OA=2)
    assert "projections.theorem" in keys(book)
    assert not book.centres
    psi = asin(sin(radians(60)) / 3)
    assert speed(book, "B") == pytest.approx(20 * sin(radians(60) + psi) / cos(psi))


def test_by_one_velocity_and_the_rate() -> None:
    # A plate with v_A = 3 to the right that turns clockwise at 2: P is 1.5 below A.
    book = book_of("triangle_plate", "hand-2", ("v_D",))
    given_motion.enter_given_motion(book)
    right = Value(None, "angle", 0.0)
    book.velocity["A"] = (Term(Name("v", "A"), Value(Name("v", "A"), "velocity", 3.0), right, Sentence("ways.given")),)
    book.omega["ABD"] = Rate(Value(Name("omega", "ABD"), "angular velocity", 2.0), -1)
    found = distance(book, "ABD", "A")
    assert found.exact == pytest.approx(1.5, rel=1e-14)
    assert book.centres["P", "ABD"].rays["A"].angle.exact == -90.0
    # B is 1 m to the right of A: BP^2 = 1 + 1.5^2.
    assert distance(book, "ABD", "B").exact == pytest.approx(sqrt(3.25), rel=1e-14)


def test_projections_do_not_check_what_the_centre_gave() -> None:
    variant = one_variant("crank_and_disc", form="relative", seed="17")
    assert "equal components" not in str(explain(variant, language="en", methods=["velocity_centre"]))
