"""The circles that joints take for granted: those of the figure must be the same."""

from __future__ import annotations

from variantgen.mechanism.joint import Joint, JointCircle
from variantgen.mechanism.joints.gears import Gears
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.joints.rolling_on_circle import RollingOnCircle
from variantgen.mechanism.joints.rope import Bend, Rope
from variantgen.mechanism.rows import Placement

# C is 5 from O: a triangle with the sides 3, 4, 5.
AT = Placement({"O": 0j, "C": 3 + 4j, "K": -2j})


def circles(joint: Joint) -> list[JointCircle]:
    return list(joint.circles(AT))


def test_gears_share_the_distance_of_their_centres_outside_and_differ_by_it_inside() -> None:
    outside = Gears("one", "C", 2.0, "O", "two")
    assert circles(outside) == [JointCircle("C", 2.0, "one"), JointCircle("O", 3.0, "two")]
    inside = Gears("one", "C", 2.0, "O", inside=True)
    assert circles(inside) == [JointCircle("C", 2.0, "one"), JointCircle("O", 7.0)]


def test_wheels_on_circles_and_lines() -> None:
    assert circles(RollingOnCircle("wheel", "C", 1.0, "O")) == [JointCircle("C", 1.0, "wheel"), JointCircle("O", 4.0)]
    assert circles(Rolling("wheel", "O", "K")) == [JointCircle("O", 2.0, "wheel")]


def test_pulleys_of_a_rope() -> None:
    rope = Rope((Bend("O", 1.5, 1.0, "drum"), Bend("C", 0.5, -1.0), Bend("K")))
    assert circles(rope) == [JointCircle("O", 1.5, "drum"), JointCircle("C", 0.5), JointCircle("K", 0.0)]


def test_other_joints_have_none() -> None:
    assert circles(Pivot("O")) == []
