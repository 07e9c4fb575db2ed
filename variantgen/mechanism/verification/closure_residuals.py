"""The closing equations of a scene in displacements and rotations of its bodies, without anything of the solver.

The unknowns are, for each rigid body, the displacement of its first point (in units of the mechanism's size) and its
rotation since the instant of the problem (rad), and the displacements of points that belong to no body. The equations
are that shared points stay together and that the residuals of joints and drivers vanish.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import Real, from_parts
from variantgen.mechanism.motion import ComplexField, Motion
from variantgen.mechanism.rows import Placement

_JACOBIAN_STEP = 1e-6

Vector = NDArray[np.float64]


class _Carriage(Struct, frozen=True):
    """Points carried by bodies: places and arms from the bodies' first points at the instant (m, shape (N, points)).

    ``body``: the numbers of the bodies, shape (points,).
    """

    start: ComplexField
    arm: ComplexField
    body: NDArray[np.int64]


class ClosureResiduals:
    """The closing equations of a scene in displacements and rotations of its bodies."""

    def __init__(self, motion: Motion) -> None:
        scene = motion.scene
        self.motion = motion
        self.start = Placement(motion.z, scene.frame)
        self.length = motion.length_scale()
        self.home: dict[str, str] = {}
        self.hinges: list[tuple[str, str]] = []
        for body, members in scene.bodies.items():
            for point in members:
                if point in self.home:
                    self.hinges.append((point, body))
                else:
                    self.home[point] = body
        named = {point for c in scene.constraints for shape in c.shapes() for point in shape.points}
        self.single = [point for point in scene.points if point in named and point not in self.home]
        self.material = [*self.home, *self.single]
        self.unknowns = 3 * len(scene.bodies) + 2 * len(self.single)
        self.lengths = self._length_rows()
        self._at_home, self._again = self._carriage(list(self.home.items())), self._carriage(self.hinges)

    def _length_rows(self) -> NDArray[np.bool_]:
        """Which residuals are lengths (to be divided by the size of the mechanism) and not angles."""
        flags = [True, True] * len(self.hinges)
        for c in self.motion.scene.constraints:
            for shape in c.shapes():
                flags += [True] * (2 if shape.given_point else 1) if shape.points else [False]
        return np.array(flags)

    def placement(self, q: Vector) -> Placement:
        """Positions and rotations for displacements q, shape (..., N, unknowns)."""
        z: dict[str, ComplexField] = dict(self.motion.z)
        carried = self._carried(q, self._at_home)
        z.update((point, carried[..., k]) for k, point in enumerate(self.home))
        for k, point in enumerate(self.single):
            i = 3 * len(self.motion.scene.bodies) + 2 * k
            z[point] = self.motion.z[point] + (q[..., i] + 1j * q[..., i + 1]) * self.length
        turned = {body: q[..., 3 * i + 2] for i, body in enumerate(self.motion.scene.bodies)}
        return Placement(z, self.start.frame, turned)

    def _carriage(self, pairs: Sequence[tuple[str, str]]) -> _Carriage:
        """What it takes to move points with bodies, for (point, body) pairs."""
        z, scene = self.motion.z, self.motion.scene
        bodies = list(scene.bodies)
        table = np.zeros((self.motion.size, 0), dtype=complex)
        starts = np.stack([z[point] for point, _ in pairs], axis=-1) if pairs else table
        poles = np.stack([z[scene.bodies[body][0]] for _, body in pairs], axis=-1) if pairs else table
        return _Carriage(starts, starts - poles, np.array([bodies.index(body) for _, body in pairs], dtype=int))

    def _carried(self, q: Vector, by: _Carriage) -> ComplexField:
        """Points as carried by bodies: ``z0 + shift + (exp(i turn) - 1) (z0 - pole)``, shape (..., N, points)."""
        bodies = 3 * len(self.motion.scene.bodies)
        half = 0.5 * q[..., 2:bodies:3]
        sine = np.sin(half)
        swing = from_parts(-2.0 * sine * sine, 2.0 * sine * np.cos(half))
        shift = from_parts(q[..., 0:bodies:3], q[..., 1:bodies:3]) * self.length[:, None]
        result: ComplexField = by.start + shift[..., by.body] + swing[..., by.body] * by.arm
        return result

    def residual(self, q: Vector, time: Vector, since: Placement | None = None) -> Vector:
        """All residuals, lengths in units of the mechanism's size, shape (..., N, equations).

        ``since`` is the placement from which joints and drivers count (with the rotations that it has already); without
        it they count from the instant of the problem. Residuals of wheels, gears and ropes may only be trusted for
        rotations of less than half a turn, so a long way is gone from placement to placement.
        """
        at, start = self.placement(q), since or self.start
        counted = at
        if since is not None:
            turned = {body: turn - since.turned[body] for body, turn in at.turned.items()}
            counted = Placement(at.z, at.frame, turned)
        parts: list[Real] = []
        again = self._carried(q, self._again)
        for k, (point, _) in enumerate(self.hinges):
            gap = again[..., k] - at.z[point]
            parts += [np.real(gap), np.imag(gap)]
        for constraint in self.motion.scene.constraints:
            parts += constraint.residual(counted, start, time)
        found = np.empty((*time.shape, len(parts)))
        for row, part in enumerate(parts):
            found[..., row] = part
        return found / np.where(self.lengths, self.length[:, None], 1.0)

    def jacobian(self, q: Vector | None = None, since: Placement | None = None) -> Vector:
        """Derivative of the residuals at q (None: at the instant) by central differences.

        Shape (..., N, equations, unknowns) for q of shape (..., N, unknowns).
        """
        count, size = self.unknowns, self.motion.size
        place = np.zeros((size, count)) if q is None else q
        steps = np.eye(count).reshape((count,) + (1,) * (place.ndim - 1) + (count,)) * _JACOBIAN_STEP
        still = np.zeros((count, *place.shape[:-1]))
        ahead, behind = (self.residual(place + step, still, since) for step in (steps, -steps))
        return np.moveaxis((ahead - behind) / (2 * _JACOBIAN_STEP), 0, -1)
