"""What follows in a mechanism from some wrong velocities and accelerations, by the theorems of a rigid body alone.

Everything that is known is kept as a list of candidates: the right value, the student's, and what theorems make of
them in a few rounds, in every mixture. For points P, Q of one body, r from P to Q, all as complex numbers:

- ``omega = r x (v_Q - v_P) / r^2`` and ``v_Q = v_P + i omega r``, likewise for a point between two others;
- equal projections, ``v_Q . r = v_P . r``, where the direction of ``v_Q`` is known;
- ``a_Q = a_P + (i epsilon - omega^2) r`` and from it ``epsilon``, or ``a_Q`` where its direction is known;
- ``a_n = v^2 / rho`` on a known path, so that ``a_n`` changes as the square of ``v``;
- two bodies that touch without slip have the same velocity there.

Which of them a solution uses is not asked: a number that it gives is confirmed where some chain of these gives it too.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from msgspec import Struct
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.families.quantities import Quantity
from variantgen.marking.diagnosis.candidates import SMALL, Candidates, each, few, projecting, without_noise
from variantgen.mechanism.arithmetic import cross
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.mechanism.rows import Placement

_ROUNDS = 2


class DerivedMotion:
    """The candidates for velocities and accelerations of a motion of one variant with wrong answers (SI) in it."""

    def __init__(self, motion: Motion, wrong: Mapping[Quantity, float]) -> None:
        self._motion = motion
        self._z = {name: complex(z[0]) for name, z in motion.z.items()}
        self._bodies = {body: list(points) for body, points in motion.scene.bodies.items()}
        self._right_v = without_noise(motion.v)
        self._right_a = without_noise(motion.a)
        self._add_contacts()
        self._slides = [
            _Slide(point, body, complex(own.velocity[0]))
            for point, body in sliding_points(motion.scene).items()
            for own in (relative_motion(motion, point, body),)
            if own.velocity[0]
        ]
        self.v_rel = {slide.point: np.array([slide.velocity]) for slide in self._slides}
        self.v = {name: np.array([v]) for name, v in self._right_v.items()}
        self.a = {name: np.array([a]) for name, a in self._right_a.items()}
        self.omega = {body: np.array([complex(x[0])]) for body, x in motion.omega.items()}
        self.epsilon = {body: np.array([complex(x[0])]) for body, x in motion.epsilon.items()}
        self._factors = [1.0]  # of velocities
        self._stretched = [1.0]  # of accelerations
        self.given = [
            quantity.target for quantity in wrong if quantity.group == "vector" and quantity.kind == "v"
        ]  # points with a wrong velocity
        self._driven = {
            shape.bodies[0]
            for driver in motion.scene.drivers
            for shape in driver.shapes()
            if not shape.points and len(shape.bodies) == 1
        }
        self._begin(wrong)
        for _ in range(_ROUNDS):
            self._round()

    def values(self, asked: Quantity) -> NDArray[np.float64]:
        """All that an asked quantity may be, shape (K,)."""
        if asked.kind in ("v_rel", "a_cor") and asked.target in self.v_rel and not asked.component:
            own = self.v_rel[asked.target]
            body = next(slide.body for slide in self._slides if slide.point == asked.target)
            return np.abs(own) if asked.kind == "v_rel" else np.abs(2.0 * each(np.multiply, own, self.omega[body]))
        table = self._table(asked.kind)
        if asked.target not in table:
            return np.empty(0)
        own = table[asked.target]
        own = own if asked.kind in "va" else own.real
        full: dict[str, Any] = {asked.kind: {**getattr(self._motion, asked.kind), asked.target: own}}
        return np.ravel(asked.value(replace(self._motion, **full)))

    def in_proportion(self, body: str) -> Candidates:
        """The angular velocity of a body, right and in proportion to each wrong velocity; of a driven one the right."""
        factors = np.array([1.0] if body in self._driven else self._factors, dtype=np.complex128)
        return factors * complex(self.omega[body][0])

    def _table(self, kind: str) -> dict[str, Candidates]:
        """The candidates of a kind of quantity, by point or body."""
        tables = {"v": self.v, "a": self.a, "omega": self.omega, "epsilon": self.epsilon, "v_rel": self.v_rel}
        return tables.get(kind, {})

    def _add_contacts(self) -> None:
        """Where two bodies touch is a point of both, and moves as one; its acceleration differs and is left out."""
        at = Placement(self._motion.z, self._motion.scene.frame)
        for number, joint in enumerate(self._motion.scene.joints):
            contact = joint.contact_at(at)
            if contact is None:
                continue
            body, point = contact.body
            name = f"\0{number}"  # no point has such a name
            place = complex(np.ravel(contact.place)[0])
            self._z[name] = place
            turning = 1j * float(self._motion.omega[body][0]) * (place - self._z[point])
            self._right_v[name] = self._right_v[point] + turning
            for own in (body, *([contact.other[0]] if contact.other else [])):
                self._bodies.setdefault(own, []).append(name)

    def _begin(self, wrong: Mapping[Quantity, float]) -> None:
        for quantity, value in wrong.items():
            right = float(quantity.value(self._motion)[0])
            table = self._table(quantity.kind)
            if not right or quantity.target not in table:
                continue
            factor = value / right
            table[quantity.target] = np.append(table[quantity.target], factor * table[quantity.target][0])
            if quantity.order == 1:
                self._factors.append(factor)
            elif quantity.order == 2:
                self._stretched.append(factor)

    def _round(self) -> None:
        """One more theorem on all that is known."""
        known = self.v, self.a, self.omega, self.epsilon
        v, a, omega, epsilon = ({name: [own] for name, own in table.items()} for table in known)
        for body, points in self._bodies.items():
            for start in points:
                for end in points:
                    r = self._z[end] - self._z[start]
                    if start == end or not r:
                        continue
                    if body in omega:
                        self._velocities(body, start, end, r, v, omega, points)
                    if body in epsilon and start in self.a and end in self.a:
                        self._accelerations(body, start, end, r, a, epsilon)
        for name in a:
            a[name] += self._natural(name)
        for name in v:
            v[name] += self._dyads(name)
        for slide in self._slides:
            self._sliding(slide, v, omega)
        for body in self._driven:  # nobody works out what is given
            omega[body] = [self.omega[body]]
            epsilon |= {body: [self.epsilon[body]]} if body in epsilon else {}
        self.v, self.a, self.omega, self.epsilon = (
            {name: few(own) for name, own in table.items()} for table in (v, a, omega, epsilon)
        )

    def _velocities(
        self,
        body: str,
        start: str,
        end: str,
        r: complex,
        v: dict[str, list[Candidates]],
        omega: dict[str, list[Candidates]],
        points: Sequence[str],
    ) -> None:
        led = projecting(self._right_v[end], r, self.v[start])
        sign = np.sign(self._motion.omega[body][0])
        for gap in (each(np.subtract, self.v[end], self.v[start]), *([led - self.v[start]] if led.size else [])):
            turning = np.imag(np.conj(r) * gap) / abs(r) ** 2
            omega[body] += [turning + 0j, sign * np.abs(gap) / abs(r) + 0j]
        v[end] += [each(np.add, self.v[start], 1j * r * self.omega[body]), led]
        self._between(v, self.v, start, end, points)

    def _accelerations(
        self,
        body: str,
        start: str,
        end: str,
        r: complex,
        a: dict[str, list[Candidates]],
        epsilon: dict[str, list[Candidates]],
    ) -> None:
        gap = each(np.subtract, self.a[end], self.a[start])
        epsilon[body].append(np.imag(np.conj(r) * gap) / abs(r) ** 2 + 0j)
        normal = each(np.subtract, self.a[start], self.omega[body] ** 2 * r)
        a[end].append(each(np.add, normal, 1j * r * self.epsilon[body]))
        for way, known in self._paths(end):
            led = known + projecting(way, r, normal - known)
            a[end].append(led)
            if led.size:
                epsilon[body].append(np.imag(np.conj(r) * (led - normal)) / abs(r) ** 2 + 0j)
        self._between(a, self.a, start, end, [point for point in self._bodies[body] if point in self.a])

    def _arms(self, point: str, apart: str) -> Iterator[tuple[str, str, complex]]:
        """Other bodies that a point belongs to, with other points of them and the vectors from these to it."""
        for body, points in self._bodies.items():
            if body != apart and point in points:
                yield from ((body, other, r) for other in points if (r := self._z[point] - self._z[other]))

    def _dyads(self, point: str) -> Iterator[Candidates]:
        """The velocities of a hinge of two bodies by equal projections on both: ``v_C . r = v_A . r``."""
        arms = list(self._arms(point, ""))
        for k, (_, first, one) in enumerate(arms):
            for _, second, two in arms[k + 1 :]:
                across = cross(one, two)
                if abs(across) > SMALL * abs(one) * abs(two):
                    left = (self.v[first] * np.conj(one)).real
                    right = (self.v[second] * np.conj(two)).real
                    yield each(np.subtract, -1j * two * left / across, -1j * one * right / across)

    def _between(
        self,
        found: dict[str, list[Candidates]],
        known: Mapping[str, Candidates],
        start: str,
        end: str,
        points: Sequence[str],
    ) -> None:
        """The vectors of other points of the body by those of two: ``w_C = w_A + (w_B - w_A) AC / AB``."""
        for other in points:
            if other not in (start, end):
                part = (self._z[other] - self._z[start]) / (self._z[end] - self._z[start])
                found[other].append(each(np.add, (1 - part) * known[start], part * known[end]))

    def _paths(self, point: str) -> Iterator[tuple[complex, complex]]:
        """The direction that an unknown part of an acceleration has, and the part that is known: a_n by each factor."""
        own, speed = self._right_a[point], self._right_v[point]
        yield own, 0j
        if speed:
            along = speed / abs(speed)
            normal = own - (own * np.conj(along)).real * along
            for factor in self._factors:
                yield along, factor**2 * normal

    def _natural(self, point: str) -> list[Candidates]:
        """The accelerations with another normal part, as the square of the velocity changes it."""
        own, speed = self._right_a[point], self._right_v[point]
        if not speed or not own:
            return []
        along = speed / abs(speed)
        tangential = (own * np.conj(along)).real * along
        normal = own - tangential
        lengths = np.abs(self.v[point]) / abs(speed)
        parts = each(np.multiply, (self.a[point] * np.conj(along)).real * along, np.array(self._stretched) + 0j)
        return [each(np.add, parts, lengths**2 * normal)]

    def _sliding(self, slide: _Slide, v: dict[str, list[Candidates]], omega: dict[str, list[Candidates]]) -> None:
        """A point P that slides on a body along u: ``v_P = v_A + i omega r + v_rel`` for each point A of the body."""
        point, body, u = slide.point, slide.body, slide.velocity / abs(slide.velocity)
        found = [self.v_rel[point]]
        for start in self._bodies[body]:
            r = self._z[point] - self._z[start]
            if start == point or not r:
                continue
            across = cross(1j * r, u)
            gap = each(np.subtract, self.v[point], self.v[start])
            if abs(across) > SMALL * abs(r):
                omega[body].append(cross(gap, u) / across + 0j)
                found.append(cross(1j * r, gap) / across * u)
            led = each(np.add, self.v[start], 1j * r * self.omega[body])
            v[point].append(each(np.add, led, self.v_rel[point]))
            way = self._right_v[point]
            if abs(cross(way, u)) > SMALL * abs(way):
                whole = cross(led, u) / cross(way, u) * way
                v[point].append(whole)
                found.append(whole - led)
            for second, other, arm in self._arms(point, body):  # this body leads it too: equal projections on its arm
                if abs(along := (u * np.conj(arm)).real) > SMALL * abs(arm):
                    slid = (np.subtract.outer(self.v[other], led) * np.conj(arm)).real / along * u
                    turned = cross(arm, led + slid - self.v[other][:, None]) / abs(arm) ** 2
                    found.append(np.ravel(slid))
                    v[point].append(np.ravel(led + slid))
                    omega[second].append(np.ravel(turned) + 0j)
        self.v_rel[point] = few(found)


class _Slide(Struct, frozen=True):
    """A point that slides on a body, and its right relative velocity."""

    point: str
    body: str
    velocity: complex
