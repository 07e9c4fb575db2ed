"""The speed of a rope between two of its stations: how fast its material runs there."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, dot
from variantgen.mechanism.joints.rope import Bend, Rope
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import Scene


class RopeWay(Struct, frozen=True):
    """The way from an end of a rope to one of its pieces: the bends passed, the end first.

    ``pieces`` are the numbers of the straight pieces on it, ``sense`` is -1 where it leads from the last bend.
    """

    rope: Rope
    bends: tuple[Bend, ...]
    pieces: tuple[int, ...]
    sense: int

    def rays(self, at: Placement) -> list[Complex]:
        """The unit vectors on paper along its pieces, away from the end."""
        found = self.rope.pieces(at)
        return [self.sense * found[number][0] for number in self.pieces]

    def rim(self, at: Placement) -> float:
        """What the rotation of the drum at the end is multiplied by to give the velocity of the rope away from it."""
        end = self.bends[0]
        return float(-self.sense * at.frame.sense * end.side * end.radius)


class RopePiece(Struct, frozen=True):
    """The straight piece of a rope from the bend with this number to the next one."""

    rope: Rope
    number: int

    @property
    def ends(self) -> tuple[str, str]:
        """The points of the bends at its ends."""
        first, second = self.rope.path[self.number : self.number + 2]
        return first.point, second.point

    def run(self, resting: Collection[str]) -> int:
        """The number of the first piece from which the rope runs on over pulleys at rest alone, so equally fast."""
        number, path = self.number, self.rope.path
        while number and path[number].point in resting:
            number -= 1
        return number

    def way(self, resting: Collection[str]) -> RopeWay | None:
        """The way over fewest moving pulleys from an end whose motion tells that of the rope; None for no such end."""
        last = len(self.rope.path) - 1
        ways = (
            RopeWay(self.rope, self.rope.path[: self.number + 1], tuple(range(self.number + 1)), 1),
            RopeWay(self.rope, self.rope.path[: self.number : -1], tuple(range(last - 1, self.number - 1, -1)), -1),
        )
        known = [way for way in ways if way.bends[0].body is None or way.bends[0].point in resting]
        return min(known, key=lambda way: sum(bend.point not in resting for bend in way.bends[1:]), default=None)


def rope_pieces(scene: Scene) -> list[RopePiece]:
    """The straight pieces of all ropes."""
    ropes = [joint for joint in scene.joints if isinstance(joint, Rope)]
    return [RopePiece(rope, number) for rope in ropes for number in range(len(rope.path) - 1)]


def rope_piece(scene: Scene, first: str, second: str) -> RopePiece | None:
    """The straight piece of a rope between two stations.

    None where no rope runs so, or several of them with speeds of their own: strands of a tackle, two belts.
    """
    resting = Linkage(scene).resting
    found = [piece for piece in rope_pieces(scene) if {*piece.ends} == {first, second} and not piece.rope.closing]
    if len({(id(piece.rope), piece.run(resting)) for piece in found}) > 1:
        return None
    closing = (piece for piece in rope_pieces(scene) if {*piece.ends} == {first, second})
    return next(iter(found), next(closing, None))


def rope_velocity(motion: Motion, piece: RopePiece) -> Field:
    """The velocity of the rope along a piece (m/s), shape (N,), positive towards the last bend.

    At the first bend ``w_0 = u_0.v_0 - s_0 r_0 omega_0`` (of a drum; the end of a rope has no radius), behind a pulley
    with the velocity v ``w_j = w_(j-1) + (u_j - u_(j-1)).v``, as the rope keeps its speed relative to the pulley.
    """
    rope, frame = piece.rope, motion.scene.frame
    rays = [ray for ray, _ in rope.pieces(Placement(motion.z, frame))]

    def carried(bend: Bend, way: object) -> Field:
        return np.zeros(motion.size) if bend.fixed else np.asarray(dot(way, motion.v[bend.point]))

    first = rope.path[0]
    speed = carried(first, rays[0])
    if first.body is not None:
        speed = speed - frame.sense * first.side * first.radius * motion.omega[first.body]
    for number in range(1, piece.number + 1):
        speed = speed + carried(rope.path[number], rays[number] - rays[number - 1])
    return np.asarray(speed)


def rope_speed(motion: Motion, piece: RopePiece) -> Field:
    """The magnitude of the velocity of the rope along a piece (m/s), shape (N,)."""
    return np.abs(rope_velocity(motion, piece))
