"""Textbook linkages as scenes, written out by hand (not read from the catalogue); in SI and radians."""

from __future__ import annotations

import math
from typing import Any

from variantgen.mechanism.constructions.circle_circle import CircleCircle
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.fraction import SegmentFraction
from variantgen.mechanism.constructions.line_circle import LineCircle
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.joints.rope import Bend, Rope
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene


def four_bar(
    a: Any,
    b: Any,
    c: Any,
    d: Any,
    phi: Any,
    omega: Any,
    epsilon: Any = 0.0,
    side: Any = 1.0,
    frame: Frame | None = None,
) -> Scene:
    """Crank a at O, coupler b, rocker c at C, base d along x; M is the midpoint of the coupler."""
    return Scene(
        {
            "O": Coordinates(0.0, 0.0),
            "C": Coordinates(d, 0.0),
            "A": Polar("O", a, phi),
            "B": CircleCircle("A", b, "C", c, side),
            "M": SegmentFraction("A", "B"),
        },
        {"OA": ("O", "A"), "AB": ("A", "B", "M"), "BC": ("C", "B")},
        (Pivot("O"), Pivot("C")),
        (Rotation("OA", omega, epsilon),),
        frame or Frame(),
    )


def slider_crank(a: Any, b: Any, offset: Any, phi: Any, omega: Any, epsilon: Any = 0.0, guide: float = 0.0) -> Scene:
    """Crank a at O, rod b, slider B on a line at the given offset, turned by the angle ``guide`` with everything."""
    return Scene(
        {
            "O": Coordinates(0.0, 0.0),
            "E": Polar("O", offset, guide + math.pi / 2),
            "A": Polar("O", a, phi + guide),
            "B": LineCircle("E", "A", b, guide),
        },
        {"OA": ("O", "A"), "AB": ("A", "B")},
        (Pivot("O"), Guide("B", guide)),
        (Rotation("OA", omega, epsilon),),
    )


def sleeve_on_crank(oa: Any, oc: Any, ab: Any, h: Any, phi: Any, omega: Any, epsilon: Any = 0.0) -> Scene:
    """Golden case K27 in general: rod BD hinged to the slider B passes through the sleeve C on the crank OA."""
    return Scene(
        {
            "O": Coordinates(0.0, 0.0),
            "A": Polar("O", oa, phi),
            "C": Polar("O", oc, phi),
            "G": Coordinates(0.0, h),
            "B": LineCircle("G", "A", ab),
            "D": SegmentFraction("B", "C", 1.5),
        },
        {"OA": ("O", "A", "C"), "AB": ("A", "B"), "BD": ("B", "D")},
        (Pivot("O"), Guide("B"), Slot("C", "BD", ("B", "D"))),
        (Rotation("OA", omega, epsilon),),
    )


def wheel(radius: Any, v: Any, a: Any = 0.0) -> Scene:
    """A wheel on the x axis, driven at its centre; A is behind, T on top."""
    return Scene(
        {
            "P": Coordinates(0.0, 0.0),
            "O": Coordinates(0.0, radius),
            "A": Coordinates(-radius, radius),
            "T": Coordinates(0.0, 2 * radius),
        },
        {"wheel": ("O", "P", "A", "T")},
        (Rolling("wheel", "O", "P"),),
        (Travel("O", v, a),),
    )


def spool(r: Any, big: Any, v: Any, a: Any = 0.0, side: float = 1.0, pulley: Any = None) -> Scene:
    """A spool on the x axis; a thread off its drum runs over a pulley to the load B, which falls with v, a."""
    centre = pulley or Coordinates(3 * big, big + side * r - 0.1)
    return Scene(
        {
            "P": Coordinates(0.0, 0.0),
            "O": Coordinates(0.0, big),
            "A": Coordinates(-big, big),
            "K": centre,
            "B": Coordinates(3 * big + 0.1, 0.0),
        },
        {"spool": ("O", "P", "A")},
        (
            Rolling("spool", "O", "P"),
            Guide("B", math.pi / 2),
            Rope((Bend("O", r, side, "spool"), Bend("K", 0.1, 1.0, fixed=True), Bend("B"))),
        ),
        (Travel("B", v, a, -math.pi / 2),),
    )
