"""Names of the quantities of a solution, apart from how a language or a markup writes them."""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

AXES = ("x", "y", "on_n", "on_tau", "xi", "eta")  # of the paper, and those that a solution lays along its vectors
OWN_AXES = AXES[2:]
ON_LINE = ("along_", "across_")  # before the points of a line on which or across which a component is taken
COMPONENTS = ("n", "tau", *AXES)


class Name(Struct, frozen=True):
    """The name of a quantity of a solution, apart from its symbol in a language.

    ``kind``: ``v a omega epsilon``, ``x y`` (coordinates), ``length`` (of a segment), ``angle`` (a corner of a
    triangle), ``inclination`` (a further angle, by its letter), ``direction`` (the angle of a ray with the x axis),
    ``parameter``, ``radius``. ``of`` is the point, the body or the first point of a segment; ``about`` the pole
    (v_BA), the second point, or the number of a further radius of a body; ``part``: words from ``n tau rel tr cor`` and
    AXES (such as ``rel tau``), or ``centre`` where the second point of a segment is the velocity (P) or acceleration
    centre (Q) of the body ``body``. An ``angle`` has its vertex at ``of`` and the points ``about`` on its sides
    (``"B P"``); ``part`` tells which is such a centre: ``centre`` the second of them, ``vertex`` the vertex. ``mu`` is
    the angle between accelerations of a body and the rays to Q.

    In graphical solutions: ``drawn`` is the length on paper of a vector with that index (``body``: ``v``, ``a``) or of
    a segment (``l``), ``scale`` the scale of a plan (``of``: ``v``, ``a``, ``l``), ``pole`` its pole (``of`` is the
    letter), ``image`` the end of the vector of a point in the plan ``body``, with ``part`` ``tr`` that of the point of
    the carrier below it.

    Coordinates of a method that differentiates: ``rotation`` (angle through which the body ``of`` has turned),
    ``slide`` (way of the point ``of`` along a line), ``offset`` (how far that line passes by the pole), ``arc`` (angle
    of the point ``of`` on a circle), ``swing`` (direction of a piece of rope or of a line of centres); ``dots`` counts
    derivatives by time. A rate with the ``part`` ``z`` counts as positive counter-clockwise. ``cosine`` is that of the
    angle between the vector ``body`` (``v``, ``a``) of a point and the axis ``part``. ``curvature`` is the radius of
    curvature of the path of a point, ``ratio`` that of the angular velocities of the bodies ``of`` and ``about``,
    ``rope`` the speed of a rope between two stations.
    ``turn`` is a quantity of a whole turn of the crank, by its name; ``limit`` the distance of a point from the pivot
    of the crank in the limit position ``about``, ``limit_corner`` a corner at ``body`` there, ``turn_between`` what the
    crank turns between them beyond half a turn. An
    ``x`` or ``y`` with a ``body`` is that of its centre ``of`` (P, Q).
    """

    kind: str
    of: str
    about: str = ""
    part: str = ""
    body: str = ""
    dots: int = 0

    @property
    def whole(self) -> Name:
        """The vector of which this is a component: ``a_B`` of ``a^n_B``."""
        left = " ".join(word for word in self.part.split() if word not in COMPONENTS and not word.startswith(ON_LINE))
        return replace(self, part=left)

    def component(self, word: str) -> Name:
        """A component of this vector: one of COMPONENTS, or along or across a line (``along_AC``)."""
        part = f"{self.part} {word}" if self.part else word
        return Name(self.kind, self.of, self.about, part, self.body, self.dots)
