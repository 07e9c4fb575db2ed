"""What solutions say of directions: of straight paths, of unknown vectors, of the centre that a contact moves."""

from __future__ import annotations

import re

import pytest

from tests.figure.reading import variants_of
from variantgen.single import one_variant


def text_of(name: str, form: str) -> str:
    """The solution of one variant in English."""
    return str(variants_of(name, form, 1)[0][0].explain(language="en")).replace("\n", " ")


@pytest.mark.parametrize("form", ["outside", "inside"])
def test_the_centre_is_told_to_move_with_or_against_the_contact(form: str) -> None:
    variants, motion, _ = variants_of("roller_on_drum", form, 8)
    against = 0
    for i, variant in enumerate(variants):
        text = str(variant.explain(language="en")).replace("\n", " ")
        with_contact = (complex(motion.v["O"][i]) * complex(motion.v["N"][i]).conjugate()).real > 0
        assert ("v⃗_O points the same way as v⃗_N." in text) == with_contact, variant.printed
        assert ("v⃗_O points opposite to v⃗_N." in text) != with_contact, variant.printed
        against += not with_contact
    assert against


@pytest.mark.parametrize(
    ("name", "form", "said"),
    [
        ("slider_crank", "central", "along the guide of B"),
        ("wedge_and_rod", "vertical", "along the guide of A"),
        ("spool", "", "along the straight path of O"),
        ("winch_with_pulley", "single", "along the straight path of C"),
        ("triangle_plate", "velocities", "along the line BD"),
    ],
)
def test_a_guide_is_named_where_there_is_one(name: str, form: str, said: str) -> None:
    text = text_of(name, form)
    assert said in text
    assert ("guide of" in text) == ("guide of" in said)


def test_an_unknown_vector_has_an_assumed_direction() -> None:
    variants, _, _ = variants_of("wedge_and_rod", "inclined", 6)
    texts = [str(variant.explain(language="en")) for variant in variants]
    for text in texts:
        rows = [line for line in text.splitlines() if line.endswith("unknown")]
        assert rows
        assert all(re.search(r", assumed \w+", row) for row in rows)
    assert any("against the assumed direction" in text for text in texts)


def test_lengths_of_points_that_are_not_shown_are_not_named() -> None:
    data = {"OA": 60, "OC": 32, "AB": 56, "h": 42, "phi": 90, "omega_OA": 3.5, "epsilon_OA": 2}
    text = str(one_variant("sleeve_on_crank", data).explain(language="en"))
    assert not re.search(r"\b[A-Z]*[GH][A-Z]* =", text)
