"""The data of the page Play against kinematics that needs none of its code."""

from __future__ import annotations

import math
from typing import Any

import pytest

from tests.studio.asking import Asking
from variantgen.outputs.figures.svg import lettering
from variantgen.single import asked_quantities, one_variant
from variantgen.studio.motion import motion_of
from variantgen.wording.formula import Symbol


def played(family: str, form: str = "", ask: tuple[str, ...] = ()) -> dict[str, Any]:
    variant = one_variant(family, seed="11", form=form, ask=ask)
    return motion_of(variant, asked_quantities(variant, ask), "en")


def test_vectors_are_those_of_a_crank_that_turns_evenly() -> None:
    """A runs round O: its velocity is square to the crank and always as long, its acceleration points to O."""
    found = played("four_bar", "crank", ("v_B",))
    velocity, acceleration = found["velocities"]["vectors"][0], found["accelerations"]["vectors"][0]
    places = [complex(*place) for place in velocity["at"]]
    middle = sum(places[:-1]) / len(places[:-1])  # the centre of a whole turn in equal steps
    speed = abs(complex(*velocity["by"][0]))
    for place, by, bent in zip(places, velocity["by"], acceleration["by"], strict=True):
        arm, v, a = place - middle, complex(*by), complex(*bent)
        assert math.isclose(abs(v), speed, rel_tol=0.01)
        assert abs((arm.conjugate() * v).real) < 0.02 * abs(arm) * abs(v)
        assert abs((arm.conjugate() * a).imag) < 0.02 * abs(arm) * abs(a)
        assert (arm.conjugate() * a).real < 0


def test_the_centre_of_a_coupler_is_seen_square_to_its_velocities() -> None:
    found = played("four_bar", "crank")
    (centre,) = found["centres"]
    seen = 0
    for i, place in enumerate(centre["at"]):
        for one in found["velocities"]["vectors"] if place else ():
            arm, v = complex(*one["at"][i]) - complex(*place), complex(*one["by"][i])
            # Places are rounded to 0.01.
            assert abs((arm.conjugate() * v).real) <= 0.01 * (abs(arm) + abs(v) + 1)
            seen += 1
    assert seen > 300


def test_parts_of_a_motion_along_a_rocker_lead_from_its_own_to_the_whole() -> None:
    """Square to the slot, which leads to the pivot, is the motion of the rocker, along it that of the block."""
    found = played("quick_return_shaper")
    for kind, names in (("velocities", ["rel"]), ("accelerations", ["cor", "rel"])):
        vectors = found[kind]["vectors"]
        chain = [next(one for one in vectors if one["kind"] == name) for name in names]
        whole = next(one for one in vectors if not one["kind"] and one["at"] == chain[0]["at"])
        for i in range(0, len(found["frames"]), 7):
            ends = [complex(*chain[0]["start"][i])]
            for one in chain:
                assert abs(complex(*one["start"][i]) - ends[-1]) < 0.03
                ends.append(ends[-1] + complex(*one["by"][i]))
            assert abs(ends[-1] - complex(*whole["by"][i])) < 0.05
            carried, rel = ends[0] if kind == "velocities" else ends[1] - ends[0], complex(*chain[-1]["by"][i])
            assert abs((carried.conjugate() * rel).real) <= 0.02 * (abs(carried) + abs(rel) + 1)


def test_poles_of_plans_have_letters_of_their_own() -> None:
    """The pole is o, or p where a point O moves, of accelerations always pi, as in plans of worked solutions."""
    crank, wheel = played("four_bar", "crank"), played("rolling_wheel")
    assert any(one["end"] == lettering(Symbol("o")) for one in wheel["velocities"]["vectors"])
    assert [one["velocities"]["pole"] for one in (crank, wheel)] == [lettering(Symbol("o")), lettering(Symbol("p"))]
    assert crank["accelerations"]["pole"] == wheel["accelerations"]["pole"] == lettering(Symbol("pi"))


def test_way_and_frames_have_one_length() -> None:
    found = played("wheel_with_rod")
    size = len(found["way"]["values"])
    assert size == len(found["frames"]) and all(len(frame) == len(found["pens"]) for frame in found["frames"])
    lists = [one["at"] for one in found["names"] + found["velocities"]["vectors"]] + [
        c["values"] for c in found["curves"]
    ]
    assert {len(one) for one in lists} == {size}
    assert found["way"]["ends"] == ["", ""] or found["way"]["why"]


@pytest.mark.parametrize(
    "path",
    [
        "/motion/nothing/-/1", "/motion/four_bar/nothing/1", "/motion/four_bar/crank/-1", "/exam/motion/9/1",
        "/exam/motion/1/999", "/play?family=../exam", "/play?family=four_bar&form=..%2F", "/exam/play?problem=x",
    ],
)  # fmt: skip
def test_what_is_not_there_is_said(client: Asking, path: str) -> None:
    found = client.get(path)
    assert found.status == 400 and found.json()["problems"][0]["message"]


def test_a_sheet_of_the_exam_is_played(client: Asking) -> None:
    found = client.get("/exam/motion/1/2").json()
    assert found["label"] == "Problem 1, Variant 2" and found["before"] == "/exam/motion/1/1"
    assert found["command"].endswith("exam.toml --student 2 --problem 1 --motion motion.pdf")
