"""Numerical continuation of a motion: predictor and corrector on the closing equations, without leaving the branch.

The way s is that of the leading driver; every driver is displaced by ``s`` times its share. A step goes along the
tangent and is corrected by Newton's method. It is taken back and shortened where the correction is large against the
step, where the tangent bends sharply, or where a joint is not intact any more; so the ends of the way are found by
bisection.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from enum import Enum

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import dot
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.verification.closure_residuals import ClosureResiduals, Vector

# Largest rotation of a body (rad) and displacement (in sizes of the mechanism) of one step.
_STEP = 0.1
# Factor by which a step is shortened; not a half, or steps would meet again the point where one has failed.
_SHORTER = 0.47
# Shortest step, of a full turn or of the size: how well the ends of the way are known.
_SHORTEST = 1e-8
# Of the step: how far the corrector may move, and by how much the tangent may change.
_CORRECTION, _BEND = 0.25, 1.0
# A point where the equations are singular is passed only if the tangent goes straight on.
_STRAIGHT = 0.1
_ITERATIONS, _CLOSED = 12, 1e-12
# Singular values (of the largest) that the differences of the Jacobian cannot tell from zero.
_SINGULAR = 1e-7
# Growth of the tangent by which a dead point is distinguished from a joint that is at its limit.
_BLOWN_UP = 100.0
# Of the size squared: a point that just touches the end of its rod may go on.
_TOUCHING = 1e-9


class StopReason(Enum):
    """Why a way cannot go on."""

    DEAD_POINT = "dead point"
    JOINT = "joint"
    LENGTH = "length"


class PathState(Struct, frozen=True):
    """A position on the way: displacements q, shape (U,); tangent dq/ds; sign of the determinant; its placement."""

    way: float
    q: Vector
    tangent: Vector
    sign: float
    placement: Placement


class Continuation:
    """The closing equations of one variant with its drivers displaced; see the module.

    ``shares``: displacement of each row of the drivers per unit of the way. ``limits``: triples (point, start,
    towards), the point stays on the side of ``start`` where ``towards`` is.
    """

    def __init__(self, motion: Motion, shares: Vector, limits: Sequence[tuple[str, str, str]] = ()) -> None:
        self.chain = ClosureResiduals(motion)
        self.scene = motion.scene
        self.size = float(self.chain.length[0])
        count = len(shares)
        lengths = self.chain.lengths[len(self.chain.lengths) - count :]
        self.shares = np.where(lengths, shares / self.size, shares)
        self.limits = limits
        self.fastest = float(np.max(np.abs(self.shares[lengths]), initial=0.0))
        self.longest, self.most_turned = np.inf, np.inf
        self.turns = np.array([3 * i + 2 for i in range(len(motion.scene.bodies))], dtype=int)
        self.start = Placement(motion.z, motion.frame, {body: np.zeros(1) for body in motion.scene.bodies})
        origin = np.zeros(self.chain.unknowns)
        jacobian = self.chain.jacobian(origin[None])[0]
        self.origin = PathState(0.0, origin, self._tangent(jacobian), float(np.linalg.slogdet(jacobian)[0]), self.start)

    def bound(self, sizes: float, turned: float) -> None:
        """Bound the displacement of the drivers (sizes of the mechanism) and the rotation of bodies (rad)."""
        self.longest = sizes / self.fastest if self.fastest > 0 else np.inf
        self.most_turned = turned

    @property
    def turning(self) -> float:
        """Largest rotation of a body (rad) per displacement of the drivers by the size of the mechanism, at first."""
        fastest = float(np.max(np.abs(self.origin.tangent[self.turns]), initial=0.0))
        return fastest / self.fastest if self.fastest > 0 else np.inf

    def run(self, end: float) -> tuple[list[PathState], StopReason | None]:
        """States from the instant to beyond the given way, or to where something stops it; and what does."""
        states = [self.origin]
        sense = float(np.sign(end))
        shortest = _SHORTEST * (2 * np.pi if np.isinf(self.longest) else self.longest)
        step, growth = np.inf, 1.0
        while sense * (end - states[-1].way) > 0:
            last = states[-1]
            step = min(growth * step, _STEP / max(float(np.max(np.abs(last.tangent))), 1e-9))
            found = self._step(last, last.way + sense * step)
            if isinstance(found, PathState):
                states.append(found)
                # After a failure the same step is tried twice before a longer one: the end is found by bisection.
                growth = min(2.0, growth / _SHORTER)
            elif step < shortest:
                return states, self._cause(found, last)
            else:
                growth = _SHORTER
        return states, None

    def _cause(self, stop: StopReason, last: PathState) -> StopReason:
        """What stops the way: near a dead point the tangent grows beyond all bounds."""
        if stop is StopReason.LENGTH:
            return stop
        grown = np.max(np.abs(last.tangent)) > _BLOWN_UP * np.max(np.abs(self.origin.tangent))
        return StopReason.DEAD_POINT if grown else StopReason.JOINT

    def _step(self, last: PathState, way: float) -> PathState | StopReason:
        """The state at the given way, or what is in its way."""
        if abs(way) > self.longest:
            return StopReason.LENGTH
        predicted = last.q + (way - last.way) * last.tangent
        q = self._correct(predicted, last, way)
        if q is None:
            return StopReason.DEAD_POINT
        placement = self._placement(q)
        if np.max(np.abs(q[self.turns]), initial=0.0) > self.most_turned:
            return StopReason.LENGTH
        if not self._possible(placement, last.placement):
            return StopReason.JOINT
        jacobian = self.chain.jacobian(q[None], last.placement)[0]
        sign = float(np.linalg.slogdet(jacobian)[0])
        if sign == 0.0:
            return StopReason.DEAD_POINT
        tangent = self._tangent(jacobian)
        bend = np.max(np.abs(tangent - last.tangent)) / max(float(np.max(np.abs(last.tangent))), 1e-300)
        if not bend <= (_BEND if sign == last.sign else _STRAIGHT):
            return StopReason.DEAD_POINT
        return PathState(way, q, tangent, sign, placement)

    def _correct(self, predicted: Vector, last: PathState, way: float) -> Vector | None:
        """Newton's method from the prediction; None where it does not converge or leads too far from it."""
        still = np.zeros(1)
        q: Vector = predicted
        stride = abs(way - last.way) * float(np.max(np.abs(last.tangent)))
        try:
            inverse = np.linalg.inv(self.chain.jacobian(predicted[None], last.placement)[0])
        except np.linalg.LinAlgError:
            return None
        allowed = _CORRECTION * stride + 1e-13
        for _ in range(_ITERATIONS):
            residual = self.chain.residual(q[None], still, last.placement)[0]
            residual[len(residual) - len(self.shares) :] -= (way - last.way) * self.shares
            change = inverse @ residual
            q = np.asarray(q - change, dtype=np.float64)
            if not np.max(np.abs(q - predicted)) <= allowed:
                return None
            if np.max(np.abs(change)) < 1e-14:
                break
        return q if np.max(np.abs(residual)) < _CLOSED else None

    def _tangent(self, jacobian: Vector) -> Vector:
        """``dq/ds`` from ``J dq = shares ds``."""
        right = np.zeros(len(jacobian))
        right[len(right) - len(self.shares) :] = self.shares
        return np.asarray(np.linalg.solve(jacobian, right), dtype=np.float64)

    def _placement(self, q: Vector) -> Placement:
        """Positions (shape (1,)) with the marked places, and rotations since the instant."""
        at = self.chain.placement(q[None])
        return Placement({**at.z, **self.marked(at)}, at.frame, at.turned)

    def marked(self, at: Placement) -> dict[str, ComplexField]:
        """Places (m), shape (N,) each, that joints mark and no body carries along: contacts of wheels."""
        return {name: z for joint in self.scene.joints for name, z in joint.marked(at, self.start).items()}

    def _possible(self, now: Placement, before: Placement) -> bool:
        """Whether all joints are intact and all points within their limits."""
        turned = {body: turn - before.turned[body] for body, turn in now.turned.items()}
        since = Placement(now.z, now.frame, turned)
        if not all(np.all(joint.intact(since, before)) for joint in self.scene.joints):
            return False
        return all(
            dot(now.z[towards] - now.z[start], now.z[point] - now.z[start])[0] >= -_TOUCHING * self.size**2
            for point, start, towards in self.limits
        )

    def between(self, states: Sequence[PathState], ways: Field) -> tuple[dict[str, Field], dict[str, ComplexField]]:
        """Rotations of bodies (rad) and places of points (m) at the given ways, all within the states; shape (K,) each.

        Each is interpolated between two neighbours on the path and corrected by Newton's method, all at once.
        """
        knots = np.array([state.way for state in states])
        index = np.asarray(np.clip(np.searchsorted(knots, ways, side="right") - 1, 0, max(len(states) - 2, 0)), np.intp)
        q = self._interpolated(states, knots, index, ways)
        since = self._gathered(states, index)
        displaced = (ways - knots[index])[:, None] * self.shares
        inverse = np.linalg.pinv(self.chain.jacobian(q[:, None], since)[:, 0], rcond=_SINGULAR)
        still = np.zeros((len(ways), 1))
        for _ in range(_ITERATIONS):
            residual = self.chain.residual(q[:, None], still, since)[:, 0]
            residual[:, residual.shape[1] - len(self.shares) :] -= displaced
            change = np.einsum("kij,kj->ki", inverse, residual)
            q = q - change
            if np.max(np.abs(change)) < 1e-14:
                break
        at = self.chain.placement(q[:, None])
        places = {name: np.asarray(z) for name, z in {**at.z, **self.marked(at)}.items()}
        flat = {name: z[:, 0] if z.ndim == 2 else np.broadcast_to(z, len(ways)) for name, z in places.items()}
        return {body: turn[:, 0] for body, turn in at.turned.items()}, flat

    def _interpolated(self, states: Sequence[PathState], knots: Field, index: NDArray[np.intp], ways: Field) -> Vector:
        """Cubic interpolation with the tangents."""
        table, slopes = np.array([s.q for s in states]), np.array([s.tangent for s in states])
        if len(states) == 1:
            return np.repeat(table, len(ways), axis=0)
        width = (knots[index + 1] - knots[index])[:, None]
        t = (ways - knots[index])[:, None] / width
        first, second = table[index], table[index + 1]
        rise = second - first
        a, b = slopes[index] * width - rise, rise - slopes[index + 1] * width
        result: Vector = first + t * rise + t * (1 - t) * ((1 - t) * a + t * b)
        return result

    def _gathered(self, states: Sequence[PathState], index: NDArray[np.intp]) -> Placement:
        """The placements of the chosen states as one, shape (K, 1)."""

        def gather(table: Callable[[PathState], Mapping[str, ComplexField]]) -> dict[str, ComplexField]:
            names = table(states[0])
            return {name: np.array([np.ravel(table(s)[name])[0] for s in states])[index][:, None] for name in names}

        turned = {name: np.real(turn) for name, turn in gather(lambda s: s.placement.turned).items()}
        return Placement(gather(lambda s: s.placement.z), self.start.frame, turned)
