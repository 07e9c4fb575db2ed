"""The closing equations of one variant on series in time: shared points stay together, joints and drivers are kept.

The unknowns are displacements of the first point of each body (in sizes of the mechanism) and its rotation (rad), then
displacements of points of no body, as series ``q(t) = q1 t + q2 t^2``. The equations of joints and drivers are their
residuals, the same that the independent verification of every variant uses, with numbers of many digits.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from variantgen.accuracy.reference.series import Series, series
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import Scene


class ClosureEquations:
    """Equations of an exact scene that is placed at ``z`` (on paper); ``size`` is the unit of displacements (m)."""

    def __init__(self, scene: Scene, z: Mapping[str, Any], size: Any) -> None:
        self.scene, self.size = scene, size
        self.z = {name: series(place) for name, place in z.items()}
        self.start = Placement(self.z, scene.frame)
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
        self.unknowns = 3 * len(scene.bodies) + 2 * len(self.single)

    def placement(self, q: Sequence[Series]) -> Placement:
        """Places of points and rotations of bodies for displacements q."""
        at = dict(self.z)
        moves = self._moves(q)
        for point, body in self.home.items():
            at[point] = self._carried(point, body, moves)
        for k, point in enumerate(self.single):
            i = 3 * len(self.scene.bodies) + 2 * k
            at[point] = self.z[point] + (q[i] + 1j * q[i + 1]) * self.size
        turned = {body: q[3 * i + 2] for i, body in enumerate(self.scene.bodies)}
        return Placement(at, self.scene.frame, turned)

    def residual(self, q: Sequence[Series], time: Series) -> list[Series]:
        """What is left of all equations (m or rad)."""
        at, moves = self.placement(q), self._moves(q)
        found: list[Series] = []
        for point, body in self.hinges:
            gap = self._carried(point, body, moves) - at.z[point]
            found += [gap.real, gap.imag]
        for constraint in self.scene.constraints:
            found += [series(r) for r in constraint.residual(at, self.start, time)]
        return found

    def _moves(self, q: Sequence[Series]) -> dict[str, tuple[Series, Series]]:
        """Of each body: displacement of its first point (m), and ``exp(i turn) - 1``."""
        return {
            body: ((q[3 * i] + 1j * q[3 * i + 1]) * self.size, (1j * q[3 * i + 2]).exp() - 1)
            for i, body in enumerate(self.scene.bodies)
        }

    def _carried(self, point: str, body: str, moves: Mapping[str, tuple[Series, Series]]) -> Series:
        shift, swing = moves[body]
        arm = self.z[point] - self.z[self.scene.bodies[body][0]]
        return self.z[point] + shift + swing * arm
