"""Groups: the parts of a mechanism that are solved one after the other, from the given motion to what is asked.

A group is found from names alone, the way a student looks for the next link: a body that turns about a fixed point and
of which one point is known, a body with a known point and another whose track is known, a point that slides on a body.
The same groups are gone through for velocities and then for accelerations.
"""

from __future__ import annotations

from msgspec import Struct

from variantgen.mechanism.joint import Sliding


class PointPath(Struct, frozen=True):
    """The fixed path of a point: a straight line in the direction ``line`` (unit vector on paper) or a circle.

    The circle is about the point ``centre``; ``body`` is the one that leads the point round it, if a body does.
    """

    point: str
    line: complex = 0j
    centre: str = ""
    body: str = ""

    @property
    def straight(self) -> bool:
        """Whether the path is a line."""
        return not self.centre


class PivotedLink(Struct, frozen=True):
    """``body`` turns about the fixed point ``pivot``; its rate is found from its point ``point``, which is known."""

    body: str
    pivot: str
    point: str


class RollingWheel(Struct, frozen=True):
    """The wheel ``body`` (``centre``) rolls on something at rest; ``joint`` is the number of the joint of the scene.

    ``around``: centre of the circle on which it rolls, empty for a straight line. ``contact``: the named contact.
    """

    body: str
    centre: str
    joint: int
    contact: str = ""
    around: str = ""


class Dyad(Struct, frozen=True):
    """``body`` has the known point ``pole`` and another one, ``point_path.point``, whose path is known."""

    body: str
    pole: str
    point_path: PointPath


class FloatingDyad(Struct, frozen=True):
    """Two bodies share the hinge ``point``; of each another point, its pole, is known."""

    point: str
    bodies: tuple[str, str]
    poles: tuple[str, str]


class SlidingPair(Struct, frozen=True):
    """A point slides on a body: the relative motion gives what is unknown of the two.

    ``carrier`` is the body it slides on, ``pole`` a known point of it (empty where it only translates), ``turning``
    whether the rate of the carrier is unknown. ``body`` is the body of the point if its rate is unknown, with
    ``own_pole`` a known point of it; ``point_path`` the path of the point if that is what is known of it;
    ``carrier_path`` the path of a carrier that only translates, if it is unknown. With none of these the point is
    known or, where its relative motion is given (``driven``), sought.
    """

    path: Sliding
    carrier: str
    pole: str
    turning: bool
    body: str = ""
    own_pole: str = ""
    point_path: PointPath | None = None
    carrier_path: PointPath | None = None
    driven: bool = False


class RelativeRotation(Struct, frozen=True):
    """The rotation of ``body`` relative to ``other`` is given: their rates add."""

    body: str
    other: str
    driver: int


class FixedSleeve(Struct, frozen=True):
    """``body`` is fixed to a sleeve on ``other`` (or has the line of its sleeve): the two turn alike."""

    body: str
    other: str


class ContactGroup(Struct, frozen=True):
    """A contact or thread (the joint's number) that gives the rate of ``body`` or the motion of its centre ``point``.

    Gears, threads, racks: see :mod:`variantgen.methods.groups.contact_laws`. With a ``second`` contact of the same body
    (number of its joint, or -1) both are found at once. ``point_path`` is the path of the point.
    """

    joint: int
    body: str = ""
    point: str = ""
    second: int = -1
    point_path: PointPath | None = None


class ExtendingLink(Struct, frozen=True):
    """The distance from ``base``, which is known, to ``point`` grows as given (driver number).

    This gives the rate of ``body``, which turns about ``pivot`` and has the point.
    """

    driver: int
    body: str
    pivot: str
    point: str
    base: str


class RollingContactPole(Struct, frozen=True):
    """The contact of a wheel with something at rest, taken as its pole: ``v_P = 0``, ``a_P`` towards the centre."""

    body: str
    centre: str
    contact: str


class TwoPointBody(Struct, frozen=True):
    """Two points of ``body`` are known; its rate follows from their relative motion."""

    body: str
    pole: str
    point: str


class Support(Struct, frozen=True):
    """What holds a point of a body: its ``point_path``, or the body ``rod`` with the known point ``far``."""

    point: str
    point_path: PointPath | None = None
    rod: str = ""
    far: str = ""


class ThirdClassGroup(Struct, frozen=True):
    """``body`` has no known point but three supports, so that they can only be treated together.

    ``point_path`` is the path of one of its points, which is the pole; ``supports`` are the two others.
    """

    body: str
    point_path: PointPath
    supports: tuple[Support, Support]


Group = (
    PivotedLink
    | RollingWheel
    | Dyad
    | FloatingDyad
    | SlidingPair
    | RelativeRotation
    | FixedSleeve
    | ContactGroup
    | ExtendingLink
    | RollingContactPole
    | TwoPointBody
    | ThirdClassGroup
)
