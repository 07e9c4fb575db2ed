"""What solutions say of directions: of straight paths, of unknown vectors, of the centre that a contact moves."""

from __future__ import annotations

import re

import pytest

from tests.figure.reading import variants_of
from variantgen.outputs.single.explanation import explain
from variantgen.single import asked_quantities, one_variant
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement


def text_of(name: str, form: str) -> str:
    """The solution of one variant in English."""
    return str(explain(variants_of(name, form, 1)[0][0], language="en")).replace("\n", " ")


@pytest.mark.parametrize("form", ["outside", "inside"])
def test_the_centre_is_told_to_move_with_or_against_the_contact(form: str) -> None:
    variants, motion, _ = variants_of("roller_on_drum", form, 8)
    against = 0
    for i, variant in enumerate(variants):
        text = str(explain(variant, language="en")).replace("\n", " ")
        with_contact = (complex(motion.v["O"][i]) * complex(motion.v["N"][i]).conjugate()).real > 0
        assert ("v⃗_O points the same way as v⃗_N, " in text) == with_contact, variant.printed
        assert ("v⃗_O points opposite to v⃗_N, " in text) != with_contact, variant.printed
        against += not with_contact
    assert against


@pytest.mark.parametrize(
    ("name", "form", "said"),
    [
        ("slider_crank", "central", "along the guide of B"),
        ("wedge_and_rod", "vertical", "along the guide of A"),
        ("triangle_plate", "velocities", "along the line BD"),
    ],
)
def test_a_guide_is_named_where_there_is_one(name: str, form: str, said: str) -> None:
    text = text_of(name, form)
    assert said in text
    assert ("guide of" in text) == ("guide of" in said)


@pytest.mark.parametrize(("name", "form", "centre"), [("spool", "", "O"), ("winch_with_pulley", "single", "C")])
def test_a_vector_on_a_level_or_upright_path_has_its_side_alone(name: str, form: str, centre: str) -> None:
    text = re.sub(r"\s+", " ", text_of(name, form))
    assert f"the path of {centre}" not in text
    assert re.search(rf"a⃗_{centre} (to the left|to the right|upwards|downwards);", text)


@pytest.mark.parametrize(("name", "form", "count"), [("wedge_and_rod", "inclined", 4), ("ladder", "driven_at_wall", 2)])
@pytest.mark.parametrize("depth", ["full", "short"])
def test_an_unknown_vector_gets_its_sense_before_its_equation(name: str, form: str, count: int, depth: str) -> None:
    for variant in variants_of(name, form, 6)[0]:
        text = str(explain(variant, language="en", depth=depth))
        said = re.sub(r"\s+", " ", text)
        sense = r"(?:so|shows that) \(?[va]⃗[^.:]* points (?:to the (?:left|right)|up|down)"
        assert len(re.findall(sense, said)) == count
        assert not re.search("assumed|minus sign", said)


@pytest.mark.parametrize(
    ("name", "form", "reason"),
    [
        ("wheel_between_racks", "one_fixed", "There is no slip."),
        ("wheel_between_racks", "two_moving", "There is no slip."),
        ("movable_pulley", "two_loads", "The cord neither stretches nor slips."),
    ],
)
def test_a_reason_for_two_contacts_is_given_once(name: str, form: str, reason: str) -> None:
    assert text_of(name, form).count(reason) == 1


def test_lengths_of_points_that_are_not_shown_are_not_named() -> None:
    data = {"OA": 60, "OC": 32, "AB": 56, "h": 42, "phi": 90, "omega_OA": 3.5, "epsilon_OA": 2}
    text = str(explain(one_variant("sleeve_on_crank", data), language="en"))
    assert not re.search(r"\b[A-Z]*[GH][A-Z]* =", text)


@pytest.mark.parametrize(
    ("name", "form", "length", "points"),
    [
        ("spool", "", "PS = ", ("the point P of the spool", "S is where")),
        ("wheel_between_racks", "two_moving", "KL = ", ("The point K of the wheel", "The point L of the wheel")),
        ("wheel_with_rod", "driven_by_slider", "AP = ", ("the contact P",)),
    ],
)
def test_points_of_contact_are_introduced_before_their_distances(
    name: str, form: str, length: str, points: tuple[str, ...]
) -> None:
    text = text_of(name, form)
    assert all(text.index(point) < text.index(length) for point in points)


def test_that_the_contact_is_the_velocity_centre_is_said_once() -> None:
    for name, form in (("rolling_wheel", ""), ("wheel_with_rod", "driven_by_slider")):
        text = re.sub(r"\s+", " ", text_of(name, form))
        assert len(re.findall("contact P is (the|its) instantaneous centre", text)) == 1


@pytest.mark.parametrize(("language", "word"), [("en", "cord"), ("ru", "нить")])
@pytest.mark.parametrize(("name", "form"), [("winch_with_pulley", "single"), ("movable_pulley", "anchored")])
def test_statements_and_solutions_call_a_cord_the_same(name: str, form: str, language: str, word: str) -> None:
    variant = variants_of(name, form, 1)[0][0]
    output = statement(variant, asked_quantities(variant), load_language(language)).text
    assert word in "".join(part for part in output if isinstance(part, str)).lower()
    assert word in str(explain(variant, language=language)).lower()


def test_the_senses_at_two_contacts_are_said() -> None:
    """The cord passes over a fixed pulley: where it leaves the movable one it goes down when the load goes up."""
    variants, motion, _ = variants_of("movable_pulley", "two_loads", 8)
    for i, variant in enumerate(variants):
        text = re.sub(r"\s+", " ", str(explain(variant, language="en")))
        at_d, at_g = ("downwards" if complex(motion.v[load][i]).imag > 0 else "upwards" for load in "AB")
        said = f"v⃗_D points {at_d}, v⃗_G points {at_g}; both are perpendicular to DG"
        alike = f"v⃗_D and v⃗_G point {at_d}, perpendicular to DG"
        assert (alike if at_d == at_g else said) in text, variant.printed


def test_of_a_uniform_relative_motion_it_is_said_what_is_zero() -> None:
    assert "so a⃗_rel M = (a⃗_rel M)_n" in text_of("parallelogram_with_disc", "moving_point")
    uniform = 0
    for variant in variants_of("hydraulic_hoist", "boom", 30)[0]:
        said = "there is no relative acceleration" in re.sub(r"\s+", " ", str(explain(variant, language="en")))
        assert said == (variant.printed["w"] == 0), variant.printed
        uniform += said
    assert uniform


@pytest.mark.parametrize(
    ("name", "form"),
    [
        ("parallelogram_with_disc", "moving_point"),
        ("ladder", "oblique"),
        ("guided_plate", ""),
        ("two_loop_mechanism", "inclined"),
    ],
)
def test_a_letter_of_an_angle_is_introduced(name: str, form: str) -> None:
    named = 0
    for variant in variants_of(name, form, 13)[0]:
        text = str(explain(variant, language="en"))
        for line in re.finditer(r"\n +([βγδλψ]) = ", text):
            before = re.sub(r"\s+", " ", text[: line.start()])
            assert before.count(f"{line[1]} is the acute angle") == 1, line[1]
            named += 1
    assert named
