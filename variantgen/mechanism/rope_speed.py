"""The speed of a rope between two of its stations: how fast its material runs there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from variantgen.mechanism.arithmetic import dot
from variantgen.mechanism.joints.rope import Bend, Rope
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import Scene


@dataclass(frozen=True)
class RopePiece:
    """The straight piece of a rope from the bend with this number to the next one."""

    rope: Rope
    number: int

    def ways(self) -> tuple[tuple[Bend, ...], ...]:
        """The bends from each end of the rope to the piece, the end first."""
        return self.rope.path[: self.number + 1], self.rope.path[: self.number : -1]

    @property
    def ends(self) -> tuple[str, str]:
        """The points of the bends at its ends."""
        first, second = self.rope.path[self.number : self.number + 2]
        return first.point, second.point

    def ray_at(self, end: Bend, at: Placement) -> complex:
        """The direction (unit vector on paper) of the straight piece at an end of the rope."""
        return complex(self.rope.pieces(at)[0 if end is self.rope.path[0] else -1][0])


def rope_pieces(scene: Scene) -> list[RopePiece]:
    """The straight pieces of all ropes."""
    ropes = [joint for joint in scene.joints if isinstance(joint, Rope)]
    return [RopePiece(rope, number) for rope in ropes for number in range(len(rope.path) - 1)]


def rope_piece(scene: Scene, first: str, second: str) -> RopePiece | None:
    """The straight piece of a rope between two stations; None where no rope runs so."""
    return next((piece for piece in rope_pieces(scene) if {*piece.ends} == {first, second}), None)


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
