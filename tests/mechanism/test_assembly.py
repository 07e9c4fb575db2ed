"""Positions by conditions from a picture: the right branch, outcomes as values, messages for the author."""

from __future__ import annotations

from math import acos, cos, radians, sin, sqrt

import mpmath
import numpy as np
import pytest
from msgspec.structs import replace

from tests.joint_scenes import class_three
from variantgen.errors import InputError
from variantgen.mechanism.condition import Condition
from variantgen.mechanism.conditions.angle import LinkAngle
from variantgen.mechanism.conditions.distance import Distance
from variantgen.mechanism.conditions.line import PointOnLine
from variantgen.mechanism.constructions.circle_circle import CircleCircle
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.fraction import SegmentFraction
from variantgen.mechanism.constructions.near import Near
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import analyse


def dyad(picture: complex, phi: object = 1.0) -> Scene:
    """A four-bar's point B: by a picture and two distances, and (B2) by the circles for both sides."""
    return Scene(
        {
            "O": Coordinates(0.0, 0.0),
            "C": Coordinates(0.7, 0.0),
            "A": Polar("O", 0.2, phi),
            "B": Near(picture.real, picture.imag),
            "left": CircleCircle("A", 0.6, "C", 0.5, 1.0),
            "right": CircleCircle("A", 0.6, "C", 0.5, -1.0),
            "M": SegmentFraction("A", "B"),
        },
        {"OA": ("O", "A"), "AB": ("A", "B", "M"), "BC": ("C", "B")},
        (Pivot("O"), Pivot("C")),
        (Rotation("OA", 1.0),),
        conditions=(Distance("A", "B", 0.6), Distance("C", "B", 0.5)),
    )


@pytest.mark.parametrize(("picture", "side"), [(0.6 + 0.5j, "left"), (0.3 - 0.4j, "right"), (2.0 + 3.0j, "left")])
def test_the_branch_is_that_of_the_picture_for_a_whole_turn(picture: complex, side: str) -> None:
    scene = dyad(picture, np.linspace(-3.0, 3.0, 61))
    plan = analyse(scene)
    assert plan.together == ("B",)
    assert plan.later == ("M",)
    z = solve(scene, 0).z
    assert solve(scene, 0).solved.all()
    assert np.max(np.abs(z["B"] - z[side])) < 1e-14
    assert np.max(np.abs(z["M"] - (z["A"] + z["B"]) / 2)) < 1e-15


def test_what_cannot_be_assembled_is_an_outcome_per_variant() -> None:
    # Turning the crank of the class III chain all round: some positions cannot be reached.
    motion = solve(class_three(np.linspace(-3.0, 3.0, 25)))
    assert set(motion.outcome.tolist()) <= {int(o) for o in Outcome}
    assert 0 < np.sum(motion.solved) < 25
    assert np.all(motion.outcome[~motion.solved] == Outcome.NOT_ASSEMBLED)
    assert all(np.isfinite(z).all() for z in motion.z.values())


def test_class_three_group_against_mpmath() -> None:
    """Positions by mpmath's own root finder from the same picture, rates by differentiating the root."""
    scene = class_three(0.9, 2.0, 1.0)
    lengths = [(c.start, c.end, c.length) for c in scene.conditions]  # type: ignore[attr-defined]

    with mpmath.workdps(40):

        def chain(t: mpmath.mpf) -> list[mpmath.mpf]:
            angle = mpmath.mpf(0.9) + 2 * t + t**2 / 2
            fixed = {"A": 0.3 * mpmath.expj(angle), "D": mpmath.mpc(1.5, -0.5), "E": mpmath.mpc(1.8, 1.5)}

            def residual(*x: mpmath.mpf) -> list[mpmath.mpf]:
                at = {**fixed, "B": mpmath.mpc(*x[:2]), "G": mpmath.mpc(*x[2:4]), "F": mpmath.mpc(*x[4:])}
                return [abs(at[q] - at[p]) ** 2 - mpmath.mpf(length) ** 2 for p, q, length in lengths]

            return list(mpmath.findroot(residual, (0.9, 0.45, 1.35, 0.35, 1.15, 0.8), tol=1e-60))

        h = mpmath.mpf(10) ** -9
        before, now, after = chain(-h), chain(mpmath.mpf(0)), chain(h)
        v = [(q - p) / (2 * h) for p, q in zip(before, after, strict=True)]
        a = [(p - 2 * m + q) / h**2 for p, m, q in zip(before, now, after, strict=True)]
    motion = solve(scene)
    assert [len(block.unknowns) for block in analyse(scene).blocks] == [1, 4]
    for i, name in enumerate(("B", "G", "F")):
        assert motion.z[name][0] == pytest.approx(complex(*now[2 * i : 2 * i + 2]), rel=1e-13)
        assert motion.v[name][0] == pytest.approx(complex(*v[2 * i : 2 * i + 2]), rel=1e-11)
        assert motion.a[name][0] == pytest.approx(complex(*a[2 * i : 2 * i + 2]), rel=1e-10)


@pytest.mark.parametrize(
    ("conditions", "said"),
    [
        ((Distance("A", "B", 0.6),), ["1 points placed near somewhere need 2 conditions, there are 1"]),
        ((Distance("A", "B", 0.6), PointOnLine("M", "O")), ["constructed from the points it should place", "M"]),
        ((Distance("A", "B", 0.6), Distance("Q", "B", 0.6)), ["unknown point", "Q"]),
    ],
)
def test_wrong_conditions(conditions: tuple[Distance | PointOnLine, ...], said: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        analyse(replace(dyad(0.6 + 0.5j), conditions=conditions))
    assert all(part in str(caught.value) for part in said), str(caught.value)


@pytest.mark.parametrize(
    ("condition", "left"),
    [
        # |AB| = 5: (5^2 - 4^2) / (2 4)
        (Distance("A", "B", 4.0), 9 / 8),
        (Distance("A", "B", 5.0), 0.0),
        # P lies 2 to the left of the x direction through A, and AB x AP = 3 2 - 4 (-1)
        (PointOnLine("P", "A"), 2.0),
        (PointOnLine("P", "A", towards="B"), 10.0),
        # AP turned back by a right angle is (2, 1), and (3, 4) x (2, 1) = 3 - 8
        (LinkAngle(("A", "B"), ("A", "P"), np.pi / 2), -5.0),
    ],
)
def test_what_conditions_say_of_their_points(condition: Condition, left: float) -> None:
    at = {"A": 1.0 + 1.0j, "B": 4.0 + 5.0j, "P": 0.0 + 3.0j}
    said = condition.product()
    first = 1.0 if said.first is None else at[said.first[1]] - at[said.first[0]]
    second = at[said.second[1]] - at[said.second[0]]
    assert (said.factor * np.conj(first) * second).real - said.value == pytest.approx(left, abs=1e-14)


@pytest.mark.parametrize("size", [90.0, 60.0, 115.0])
def test_the_instant_at_which_two_links_are_at_an_angle(size: float) -> None:
    """A slider-crank at the instant when crank and rod are at an angle: the triangle OAB by the law of cosines."""
    scene = Scene(
        {"O": Coordinates(0.0, 0.0), "A": Near(0.05, 0.2), "B": Near(0.6, 0.0)},
        {"OA": ("O", "A"), "AB": ("A", "B")},
        (Pivot("O"), Guide("B")),
        (Rotation("OA", 3.0),),
        conditions=(
            Distance("O", "A", 0.2),
            Distance("A", "B", 0.5),
            PointOnLine("B", "O"),
            LinkAngle(("A", "O"), ("A", "B"), np.radians(size)),
        ),
    )
    motion = solve(scene, 0)
    assert motion.solved[0]
    third = sqrt(0.2**2 + 0.5**2 - 2 * 0.2 * 0.5 * cos(radians(size)))
    assert motion.z["B"][0] == pytest.approx(third, abs=1e-12)
    phi = acos((0.2**2 + third**2 - 0.5**2) / (2 * 0.2 * third))  # the corner at O
    assert motion.z["A"][0] == pytest.approx(0.2 * complex(cos(phi), sin(phi)), abs=1e-12)
