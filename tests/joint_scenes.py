"""One small scene for each kind of joint, driver and condition, written out by hand."""

from __future__ import annotations

import math
from typing import Any

from variantgen.mechanism.conditions.angle import LinkAngle
from variantgen.mechanism.conditions.distance import Distance
from variantgen.mechanism.conditions.line import PointOnLine
from variantgen.mechanism.constructions.circle_circle import CircleCircle
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.near import Near
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.circling import Circling
from variantgen.mechanism.drivers.extension import Extension
from variantgen.mechanism.drivers.relative_travel import RelativeTravel
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.drivers.vector_motion import VectorMotion
from variantgen.mechanism.joints.arc_slot import ArcSlot
from variantgen.mechanism.joints.gears import Gears
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.joints.rolling_on_circle import RollingOnCircle
from variantgen.mechanism.joints.rope import Bend, Rope
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.joints.translation import Translation
from variantgen.mechanism.scene import Scene

UP = math.pi / 2
ORIGIN = Coordinates(0.0, 0.0)


def wheel_between_racks(radius: Any, v: Any, a: Any, w: Any, b: Any) -> Scene:
    """Lower rack with v, a, upper rack with w, b (to the right)."""
    return Scene(
        {
            "K": ORIGIN,
            "O": Coordinates(0.0, radius),
            "L": Coordinates(0.0, 2 * radius),
            "K1": Coordinates(-1.0, 0.0),
            "K2": Coordinates(1.0, 0.0),
            "L1": Coordinates(-1.0, 2 * radius),
            "L2": Coordinates(1.0, 2 * radius),
        },
        {"wheel": ("O", "K", "L"), "low": ("K1", "K2"), "up": ("L1", "L2")},
        (
            Guide("K1"),
            Translation("low"),
            Guide("L1"),
            Translation("up"),
            Rolling("wheel", "O", "K", "low", "K1"),
            Rolling("wheel", "O", "L", "up", "L1", axle_held=True),
        ),
        (Travel("K1", v, a), Travel("L1", w, b)),
    )


def wheel_on_turning_plank(axle_held: bool = False) -> Scene:
    """A wheel rolls on a plank that turns about O; with ``axle_held`` a guide carries its axle."""
    points = {
        "O": ORIGIN,
        "B": Polar("O", 2.0, 0.3),
        "K": Polar("O", 1.2, 0.3),
        "W": Polar("K", 0.25, UP, "B"),
        "M": Polar("W", 0.25, 0.4),
    }
    bodies = {"plank": ("O", "B"), "wheel": ("W", "M")}
    rolling = Rolling("wheel", "W", "K", "plank", "O", axle_held)
    if axle_held:
        # The axle keeps its distance from the plank by a slot of the plank parallel to it.
        points |= {"S": Polar("O", 0.25, 0.3 + UP), "T": Polar("B", 0.25, 0.3 + UP)}
        bodies["plank"] = ("O", "B", "S", "T")
        joints: Any = (Pivot("O"), Slot("W", "plank", ("S", "T")), rolling)
    else:
        joints = (Pivot("O"), rolling)
    return Scene(points, bodies, joints, (Rotation("plank", 1.0, 0.7), Rotation("wheel", -2.0, 1.5)))


def disc_on_circle(distance: Any, radius: Any, omega: Any, epsilon: Any, inside: bool, drum: Any = None) -> Scene:
    """A disc rolls on a circle about C, fixed or the rim of a drum with (Omega, E)."""
    points = {"C": ORIGIN, "N": Coordinates(0.1, 0.0), "O": Polar("C", distance, -1.0), "M": Polar("O", radius, 0.4)}
    if drum is None:
        points.pop("N")
        joint = RollingOnCircle("disc", "O", radius, "C", inside)
        return Scene(points, {"disc": ("O", "M")}, (joint,), (Rotation("disc", omega, epsilon),))
    joint = RollingOnCircle("disc", "O", radius, "C", inside, "drum")
    bodies = {"disc": ("O", "M"), "drum": ("C", "N")}
    return Scene(points, bodies, (Pivot("C"), joint), (Rotation("disc", omega, epsilon), Rotation("drum", *drum)))


def epicyclic(arm: Any, planet: Any, omega: Any, epsilon: Any) -> Scene:
    """Carrier with a planet between a fixed ring and a sun (all about C)."""
    return Scene(
        {
            "C": ORIGIN,
            "O": Polar("C", arm, 1.0),
            "M": Polar("O", planet, 0.4),
            "S": Polar("C", arm - planet, 2.0),
        },
        {"carrier": ("C", "O"), "sun": ("C", "S"), "planet": ("O", "M")},
        (Pivot("C"), Gears("planet", "O", planet, "C", inside=True), Gears("planet", "O", planet, "C", "sun")),
        (Rotation("carrier", omega, epsilon),),
    )


def arc_yoke(crank: Any, radius: Any, phi: Any, omega: Any, epsilon: Any) -> Scene:
    """Crank OA, its pin in a circular slot (centre Q) of a yoke that slides along x; Q lies left of the pin."""
    return Scene(
        {
            "O": ORIGIN,
            "A": Polar("O", crank, phi),
            "Q": Coordinates(crank * math.cos(phi) - math.sqrt(radius**2 - (crank * math.sin(phi)) ** 2), 0.0),
            "E": Coordinates(3.0, 0.0),
        },
        {"OA": ("O", "A"), "yoke": ("Q", "E")},
        (Pivot("O"), Guide("Q"), Translation("yoke"), ArcSlot("A", "Q", "yoke")),
        (Rotation("OA", omega, epsilon),),
    )


def rod_in_fixed_arc() -> Scene:
    """End A of a rod on a line, end B on a fixed circle about C."""
    return Scene(
        {"C": ORIGIN, "B": Polar("C", 1.0, 1.0), "A": Coordinates(-0.9, -0.2)},
        {"AB": ("A", "B")},
        (Guide("A"), ArcSlot("B", "C")),
        (Travel("A", 1.0, 0.3),),
    )


def point_in_groove(omega: Any, epsilon: Any, u: Any, w: Any) -> Scene:
    """A point runs along a circular groove (centre Q) of a disc that turns about O, relative rates u, w."""
    return Scene(
        {"O": ORIGIN, "Q": Coordinates(0.3, 0.0), "M": Polar("Q", 0.2, 1.2)},
        {"disc": ("O", "Q")},
        (Pivot("O"), ArcSlot("M", "Q", "disc")),
        (Rotation("disc", omega, epsilon), Circling("M", "disc", "Q", u, w)),
    )


def bead_on_rod(distance: Any, offset: Any, omega: Any, epsilon: Any, u: Any, w: Any) -> Scene:
    """A bead on a straight line of a body that turns about O; the line passes O at ``offset``."""
    return Scene(
        {
            "O": ORIGIN,
            "S": Polar("O", offset, 0.7 + UP),
            "T": Polar("S", 1.0, 0.7),
            "M": Polar("S", distance, 0.7),
        },
        {"OST": ("O", "S", "T")},
        (Pivot("O"), Slot("M", "OST", ("S", "T"))),
        (Rotation("OST", omega, epsilon), RelativeTravel("M", "OST", ("S", "T"), u, w)),
    )


def hydraulic_boom(boom: Any, base: Any, length: Any, u: Any, w: Any) -> Scene:
    """Boom OB about O, cylinder FB of given length; OF = base along x."""
    return Scene(
        {"O": ORIGIN, "F": Coordinates(base, 0.0), "B": CircleCircle("O", boom, "F", length, 1.0)},
        {"OB": ("O", "B")},
        (Pivot("O"), Pivot("F")),
        (Extension("F", "B", u, w),),
    )


def plate(omega: Any, epsilon: Any, v: complex, a: complex) -> Scene:
    """A triangle with the motion of one vertex and the rotation given."""
    import cmath

    given = VectorMotion("A", abs(v), cmath.phase(v), abs(a), cmath.phase(a))
    points = {"A": ORIGIN, "B": Coordinates(1.0, 0.0), "D": Coordinates(0.5, 0.8)}
    return Scene(points, {"ABD": ("A", "B", "D")}, (), (Rotation("ABD", omega, epsilon), given))


def pulleys(v_a: Any, v_b: Any, a_a: Any = 0.0, a_b: Any = 0.0, radius: float = 0.1) -> Scene:
    """Loads A and B go down; between them a pulley (radius) hangs in the rope and does not slip."""
    up = 3 * radius
    return Scene(
        {
            "K": Coordinates(-2 * radius, 1.0),
            "L": Coordinates(2 * radius, 1.0),
            "C": ORIGIN,
            "D": Coordinates(radius, 0.0),
            "A": Coordinates(-up, 0.5),
            "B": Coordinates(up, 0.4),
        },
        {"pulley": ("C", "D")},
        (
            Guide("A", UP),
            Guide("B", UP),
            Guide("C", UP),
            Rope((Bend("A"), Bend("K", radius, 1.0, fixed=True), Bend("C", radius, -1.0, "pulley"))),
            Rope((Bend("C", radius, -1.0, "pulley"), Bend("L", radius, 1.0, fixed=True), Bend("B"))),
        ),
        (Travel("A", v_a, a_a, -UP), Travel("B", v_b, a_b, -UP)),
    )


def rope_over_free_pulley() -> Scene:
    """A crank pulls a rope over a fixed pulley; it runs round a free one on a slanting guide to an anchor."""
    return Scene(
        {
            "O": ORIGIN,
            "A": Polar("O", 0.4, 1.1),
            "K": Coordinates(1.0, 1.0),
            "L": Coordinates(1.5, 0.3),
            "F": Coordinates(2.0, 1.2),
        },
        {"OA": ("O", "A")},
        (
            Pivot("O"),
            Guide("L", 1.2),
            Rope((Bend("A"), Bend("K", 0.1, 1.0, fixed=True), Bend("L", 0.15, -1.0), Bend("F", fixed=True))),
        ),
        (Rotation("OA", 1.5, 0.7),),
    )


def crossed_belt(arm_rate: Any, relative: Any) -> Scene:
    """A crossed belt from a drum on a crank to a drum on a fixed axis; the first turns relative to the crank."""
    return Scene(
        {
            "O": ORIGIN,
            "A": Polar("O", 0.4, 1.1),
            "K": Coordinates(1.5, 0.2),
            "M": Polar("K", 0.1, 0.0),
            "N": Polar("A", 0.1, 0.3),
        },
        {"OA": ("O", "A"), "first": ("A", "N"), "second": ("K", "M")},
        (Pivot("O"), Pivot("K"), Rope((Bend("A", 0.12, 1.0, "first"), Bend("K", 0.2, -1.0, "second")))),
        (Rotation("OA", *arm_rate), Rotation("first", *relative, relative_to="OA")),
    )


def class_three(phi: Any = 0.9, omega: Any = 2.0, epsilon: Any = 1.0) -> Scene:
    """Crank OA, rod AB, ternary link BGF, rockers GD and FE: no dyad opens it; B, G, F from a picture."""
    return Scene(
        {
            "O": ORIGIN,
            "A": Polar("O", 0.3, phi),
            "D": Coordinates(1.5, -0.5),
            "E": Coordinates(1.8, 1.5),
            "B": Near(0.9, 0.45),
            "G": Near(1.35, 0.35),
            "F": Near(1.15, 0.8),
        },
        {"OA": ("O", "A"), "AB": ("A", "B"), "BGF": ("B", "G", "F"), "GD": ("G", "D"), "FE": ("F", "E")},
        (Pivot("O"), Pivot("D"), Pivot("E")),
        (Rotation("OA", omega, epsilon),),
        conditions=(
            Distance("A", "B", 0.74),
            Distance("B", "G", 0.46),
            Distance("G", "F", 0.49),
            Distance("F", "B", 0.43),
            Distance("G", "D", 0.86),
            Distance("F", "E", 0.95),
        ),
    )


def slider_crank_from_picture() -> Scene:
    """A slider-crank whose slider is placed by a distance and a line."""
    return Scene(
        {"O": ORIGIN, "A": Polar("O", 0.2, 1.0), "B": Near(0.6, 0.1)},
        {"OA": ("O", "A"), "AB": ("A", "B")},
        (Pivot("O"), Guide("B")),
        (Rotation("OA", 2.0, -1.0),),
        conditions=(Distance("A", "B", 0.6), PointOnLine("B", "O")),
    )


def crank_perpendicular_to_rod() -> Scene:
    """A slider-crank at the instant when the rod is perpendicular to the crank, which the solver finds."""
    return Scene(
        {"O": ORIGIN, "A": Near(0.1, 0.2), "B": Near(0.6, 0.0)},
        {"OA": ("O", "A"), "AB": ("A", "B")},
        (Pivot("O"), Guide("B")),
        (Rotation("OA", 2.0, -1.0),),
        conditions=(
            Distance("O", "A", 0.2),
            Distance("A", "B", 0.5),
            PointOnLine("B", "O"),
            LinkAngle(("A", "O"), ("A", "B"), math.pi / 2),
        ),
    )


SCENES = {
    "racks": wheel_between_racks(0.3, 1.0, 2.0, -3.0, 0.5),
    "plank": wheel_on_turning_plank(),
    "plank, axle held": wheel_on_turning_plank(True),
    "disc in a ring": disc_on_circle(0.7, 0.3, 2.0, 1.0, True),
    "disc on a drum": disc_on_circle(0.7, 0.3, 2.0, 1.0, False, (-1.0, 0.5)),
    "epicyclic": epicyclic(0.2, 0.05, 2.5, 1.0),
    "arc yoke": arc_yoke(0.2, 0.6, 1.0, 2.0, 1.0),
    "rod in a fixed arc": rod_in_fixed_arc(),
    "groove": point_in_groove(2.0, 1.0, 0.5, 0.7),
    "bead": bead_on_rod(0.6, 0.2, 2.0, 1.0, 0.5, 0.3),
    "boom": hydraulic_boom(1.0, 0.7, 0.9, 0.2, 0.05),
    "plate": plate(1.7, 1.0, 0.3 + 0.1j, 2.0 - 1.0j),
    "pulleys": pulleys(8.0, 4.0, 1.0, 2.0),
    "free pulley": rope_over_free_pulley(),
    "belt": crossed_belt((1.5, 0.7), (1.0, 2.0)),
    "class three": class_three(),
    "slider-crank from a picture": slider_crank_from_picture(),
    "crank and rod at a right angle": crank_perpendicular_to_rod(),
}
