"""Inextensible thread off a drum, over a fixed pulley, to a load or an anchor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Real, along
from variantgen.mechanism.component import Angle, BodyName, Length, PointName, Side
from variantgen.mechanism.constructions.tangent import thread_direction
from variantgen.mechanism.rows import Joint, Placement, ScalarRow, Shape, Speeds


@dataclass(frozen=True)
class Thread(Joint):
    """A thread leaves the drum of ``body`` (centre, radius), runs straight to ``pulley`` and on to ``load``.

    The pulley (fixed centre, ``pulley_radius``; zero for a mere point) sends it to the load, which moves in the
    direction ``load_angle`` (rad, scene frame); without a load the thread is fastened there. The thread touches the
    drum on ``side`` and the pulley on ``pulley_side`` of its way drum -> pulley. With u the direction of the
    straight piece, l its length, s = side (+1 left), w the direction of the load::

        u.v_centre - s r omega - w.v_load = 0
        u.a_centre - s r epsilon - w.a_load - (n.v_centre)^2 / l = 0,   n = i u

    because the piece turns at the rate ``-n.v_centre / l`` when the centre moves across it.
    """

    body: BodyName
    centre: PointName
    radius: Length
    side: Side
    pulley: PointName
    pulley_radius: Length = 0.0
    pulley_side: Side = 1.0
    load: PointName | None = None
    load_angle: Angle = 0.0

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the drum's centre, the drum and the load."""
        points = (self.centre,) if self.load is None else (self.centre, self.load)
        return (Shape(points=points, bodies=(self.body,)),)

    def _straight(self, at: Placement) -> tuple[Complex, Real]:
        sense = at.frame.sense
        ray, length, _ = thread_direction(
            at.z[self.centre],
            self.radius,
            sense * self.side,
            at.z[self.pulley],
            self.pulley_radius,
            sense * self.pulley_side,
        )
        return ray, length

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """The velocity row of the class docstring."""
        ray, _ = self._straight(at)
        points = {self.centre: ray}
        if self.load is not None:
            points[self.load] = -at.frame.direction(self.load_angle)
        return (ScalarRow(points, {self.body: -at.frame.sense * self.side * self.radius}),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """``-(n.v_centre)^2 / l``."""
        ray, length = self._straight(at)
        swing = along(1j * ray, speeds.v[self.centre])
        return (-swing * swing / length,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Change of the thread's length (m): straight piece, wraps on drum and pulley, way of the load."""
        before, length_before = self._straight(start)
        after, length_after = self._straight(moved)
        swung = np.angle(after / before)
        drum = start.frame.sense * self.side * self.radius * (swung - moved.turned[self.body])
        pulley = start.frame.sense * self.pulley_side * self.pulley_radius * swung
        change = length_after - length_before + pulley - drum
        if self.load is not None:
            way = moved.z[self.load] - start.z[self.load]
            change = change + along(start.frame.direction(self.load_angle), way)
        return (change,)
