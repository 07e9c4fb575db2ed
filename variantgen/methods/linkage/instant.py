"""The solved numbers of one variant: vectors of its points as complex numbers, rates of its bodies."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from variantgen.mechanism.motion import Motion, take_scene
from variantgen.mechanism.scene import Scene


class Instant(Struct, frozen=True):
    """Positions (m), velocities (m/s), accelerations (m/s^2) by point; omega (rad/s), epsilon (rad/s^2) by body.

    Accelerations and epsilons are empty where the motion was not solved so far.
    """

    scene: Scene
    z: Mapping[str, complex]
    v: Mapping[str, complex]
    a: Mapping[str, complex]
    omega: Mapping[str, float]
    epsilon: Mapping[str, float]

    @property
    def accelerated(self) -> bool:
        """Whether accelerations are known."""
        return bool(self.a)

    def normal(self, point: str, pole: str) -> complex:
        """The component along the line of two points that keep their distance (m/s^2), directed to the pole."""
        arm, swing = self.z[point] - self.z[pole], self.v[point] - self.v[pole]
        return -(abs(swing) ** 2) / abs(arm) ** 2 * arm

    def tangential(self, point: str, pole: str) -> complex:
        """The component across the line of two points that keep their distance (m/s^2)."""
        return self.a[point] - self.a[pole] - self.normal(point, pole)

    def transport_velocity(self, point: str, body: str) -> complex:
        """The velocity (m/s) of the point of a body that is at the place of another point."""
        pole = self.scene.bodies[body][0]
        return self.v[pole] + 1j * self.omega[body] * (self.z[point] - self.z[pole])

    def transport_acceleration(self, point: str, body: str) -> complex:
        """The acceleration (m/s^2) of the point of a body that is at the place of another point."""
        pole = self.scene.bodies[body][0]
        turn = 1j * self.epsilon[body] - self.omega[body] ** 2
        return self.a[pole] + turn * (self.z[point] - self.z[pole])

    def relative_velocity(self, point: str, body: str) -> complex:
        """The velocity (m/s) of a point relative to a body."""
        return self.v[point] - self.transport_velocity(point, body)

    def coriolis(self, point: str, body: str) -> complex:
        """The Coriolis acceleration (m/s^2) of a point that slides on a body."""
        return 2j * self.omega[body] * self.relative_velocity(point, body)

    def relative_acceleration(self, point: str, body: str) -> complex:
        """The acceleration (m/s^2) of a point relative to a body."""
        return self.a[point] - self.transport_acceleration(point, body) - self.coriolis(point, body)

    def growth(self, point: str, base: str) -> tuple[complex, complex]:
        """The velocity of a point about another one: along their line, which grows, and across it."""
        way = (self.z[point] - self.z[base]) / abs(self.z[point] - self.z[base])
        step = self.v[point] - self.v[base]
        along = (step * way.conjugate()).real * way
        return along, step - along

    def growing_acceleration(self, point: str, base: str) -> tuple[complex, complex, complex, complex]:
        """The acceleration of a point about another one on a line that turns and grows.

        Relative (along the line), normal and Coriolis acceleration, and the tangential one.
        """
        arm, step = self.z[point] - self.z[base], self.a[point] - self.a[base]
        along, across = self.growth(point, base)
        omega = (across / arm).imag
        normal, coriolis = -(omega**2) * arm, 2j * omega * along
        rest = step - normal - coriolis
        relative = (rest / arm).real * arm
        return relative, normal, coriolis, rest - relative


def instant(motion: Motion, index: int, length_unit: float = 1.0) -> Instant:
    """The numbers of one variant of a batch, in a unit of length (m)."""
    vectors = [
        {name: complex(values.item(index)) / length_unit for name, values in table.items()}
        for table in (motion.z, motion.v, motion.a)
    ]
    rates = [
        {body: float(values.item(index)) for body, values in table.items()} for table in (motion.omega, motion.epsilon)
    ]
    at_rest = dict.fromkeys(motion.z, 0j)  # what no equation speaks of: the centre of a fixed circle
    z, v, a = (vectors[0], *({**at_rest, **table} if table else {} for table in vectors[1:]))
    return Instant(take_scene(motion.scene, index, motion.size), z, v, a, rates[0], rates[1])
