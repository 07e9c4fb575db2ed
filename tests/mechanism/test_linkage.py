"""What a reader of the figure sees in a mechanism: stations of ropes whose places must be told."""

from __future__ import annotations

import math

import pytest

from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.rope import Bend, Rope
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.rows import Frame, Placement
from variantgen.mechanism.scene import Scene

AT = {"A": 0j, "D": -1.0 + 0j, "K": 0.2 + 3j, "B": 1.4 + 1j}
PLAIN, TURNED = Frame(), Frame(1j, -1.0)
A, B = Bend("A"), Bend("B")
LEFT, RIGHT = (Bend("K", 0.2, side=side, fixed=True) for side in (1.0, -1.0))  # seen from A, the rope goes there


def _seen(rope: Rope, angle: float, frame: Frame = PLAIN) -> list[str]:
    """With A on a guide."""
    at = Placement({name: frame.place(z) for name, z in AT.items()}, frame)
    return Linkage(Scene({}, {}, (rope, Guide("A", angle)), (), frame=frame)).aslant_stations(at)


@pytest.mark.parametrize("frame", [PLAIN, TURNED])
def test_a_station_is_told_where_its_rope_runs_aslant_to_a_guide(frame: Frame) -> None:
    """The left side of the pulley is straight above A: a rope there runs along an upright guide, across a level one."""
    assert not _seen(Rope((A, LEFT, B)), math.pi / 2, frame)
    assert _seen(Rope((A, LEFT, B)), 0.0, frame) == ["K"]
    assert _seen(Rope((A, RIGHT, B)), math.pi / 2, frame) == ["K"]


@pytest.mark.parametrize(
    "rope",
    [
        Rope((A, Bend("K", 0.2, body="drum"))),  # a body has a place of its own
        Rope((A, Bend("K", 0.2), B)),  # it moves
        Rope((Bend("A", along=math.pi / 2), LEFT, B), parallel=True),  # upright wherever the pulley is
        Rope((Bend("D"), LEFT, B)),  # no end of it is on a guide
    ],
)
def test_other_stations_need_no_place(rope: Rope) -> None:
    assert not _seen(rope, 0.0)
