"""What the solved motion of a variant says of a name: the numbers against which a written solution is held.

All in printed units, angles in degrees. None stands for what a motion has no number for: a datum, a coordinate of a
method, a length on a drawing. Formulas here start from the solver's vectors alone and share nothing with the methods.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from msgspec import Struct

from variantgen.algebra.name import ON_LINE, Name
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity, line_ends
from variantgen.mechanism.drivers.extension import Extension
from variantgen.mechanism.motion import Motion
from variantgen.methods.linkage.problem import Task
from variantgen.methods.linkage.time_laws import laws

_NOTHING = 1e-9  # of the largest velocity: a smaller one has no direction


class SolvedMotion(Struct, frozen=True):
    """The motion of a task."""

    task: Task

    def vectors(self, name: Name) -> list[complex]:
        """The velocity or acceleration of that name: of a point, about a pole, relative, of transport, a component.

        There may be several where a point and its pole share no body: the point may move with any body of the pole.
        So has a pin in the slots of two bodies a relative motion on each. The task remembers them.
        """
        key, known = ("vectors", name), self.task.remembered
        if key not in known:
            known[key] = self._vectors(name)
        found: list[complex] = known[key]
        return found

    def _vectors(self, name: Name) -> list[complex]:
        now, point = self.task.now, name.of
        table = now.v if name.kind == "v" else now.a if name.kind == "a" else {}
        if point not in table or (name.about and name.about not in table):
            return []
        words = name.part.split()
        motion = next((word for word in words if word in ("rel", "tr", "cor")), "")
        if motion:
            rest = [word for word in words if word != motion]
            carriers = [path.body for path in self.task.linkage.slides if path.point == point] or [""]
            found = [self._compound(name.kind, point, motion, rest, carrier) for carrier in carriers]
            return [_component(whole, words) for whole in found if whole is not None]
        if name.about:
            return [_component(whole, words) for whole in self._about(name, words)]
        whole = table[point]
        if name.kind == "a" and {"n", "tau"} & set(words):
            along = _along(whole, now.v[point], self.task.largest_speed)
            return [whole - along if "n" in words else along]
        return [_component(whole, words)]

    def _about(self, name: Name, words: list[str]) -> Iterator[complex]:
        """The vector of a point about a pole, with the body of both, on which it slides, or any of the pole."""
        now, bodies = self.task.now, self.task.scene.bodies
        arm = now.z[name.of] - now.z[name.about]
        own = [body for body, members in bodies.items() if name.about in members]
        both = [body for body in own if name.of in bodies[body]]
        slides = [path for path in self.task.linkage.slides if path.point == name.of and path.body in own]
        paths = [path.body for path in slides]
        if any(q.group == "difference" and q.pair == (name.of, name.about) for q in self.task.asked):
            yield from self._difference(name, words)
        if not both and any(path.centre == name.about for path in slides):  # a rod in the place of a contact of circles
            yield self._of_a_rod(name, words)
        for body in both or paths or own:
            if name.kind == "v":
                yield 1j * now.omega[body] * arm
            else:
                normal, along = -(now.omega[body] ** 2) * arm, 1j * now.epsilon[body] * arm
                yield normal if "n" in words else along if "tau" in words else normal + along

    def _difference(self, name: Name, words: list[str]) -> Iterator[complex]:
        """The vector of one point seen from another, unless it is the part of one in a rotation."""
        table = self.task.now.v if name.kind == "v" else self.task.now.a
        if not {"n", "tau"} & {*words}:
            yield table[name.of] - table[name.about]

    def _of_a_rod(self, name: Name, words: list[str]) -> complex:
        """The vector of a point about another one to which it keeps its distance."""
        now = self.task.now
        if name.kind == "v":
            return now.v[name.of] - now.v[name.about]
        normal, along = now.normal(name.of, name.about), now.tangential(name.of, name.about)
        return normal if "n" in words else along if "tau" in words else normal + along

    def _compound(self, kind: str, point: str, motion: str, words: list[str], carrier: str) -> complex | None:
        """A vector of the compound motion of a point on a body: relative, of transport, or of Coriolis."""
        now, task = self.task.now, self.task
        if not carrier:
            return self._on_a_line(kind, point, motion, words)
        if kind == "v":
            return (now.transport_velocity if motion == "tr" else now.relative_velocity)(point, carrier)
        if motion == "cor":
            return now.coriolis(point, carrier)
        if motion == "rel":
            whole = now.relative_acceleration(point, carrier)
            along = _along(whole, now.relative_velocity(point, carrier), task.largest_speed)
            return whole - along if "n" in words else along if "tau" in words else whole
        pivot = task.linkage.pivot(carrier)
        if not words:
            return now.transport_acceleration(point, carrier)
        if pivot is None:
            return None
        arm = now.z[point] - now.z[pivot]
        return -(now.omega[carrier] ** 2) * arm if "n" in words else 1j * now.epsilon[carrier] * arm

    def _on_a_line(self, kind: str, point: str, motion: str, words: list[str]) -> complex | None:
        """The same of a point of a line that turns about another point of its own and grows: a cylinder."""
        drivers = self.task.scene.drivers
        base = next((d.start for d in drivers if isinstance(d, Extension) and d.end == point), None)
        if base is None:
            return None
        if kind == "v":
            along, across = self.task.now.growth(point, base)
            return along if motion == "rel" else across
        relative, normal, coriolis, tangential = self.task.now.growing_acceleration(point, base)
        if motion != "tr":
            return relative if motion == "rel" else coriolis
        return normal if "n" in words else tangential if "tau" in words else normal + tangential

    def component(self, vector: complex, word: str) -> float | None:
        """The component of a vector on an axis of the paper, or along or across a line; None for another word."""
        if word in ("x", "y"):
            return vector.real if word == "x" else vector.imag
        ends = line_ends(word.partition("_")[2], self.task.now.z) if word.startswith(ON_LINE) else None
        if ends is None:
            return None
        step = self.task.now.z[ends[1]] - self.task.now.z[ends[0]]
        seen = vector * step.conjugate() / abs(step)
        return seen.real if word.startswith(ON_LINE[0]) else seen.imag

    def rate(self, name: Name) -> float | None:
        """A rate of rotation, positive counter-clockwise: of a body, or of the line of two points."""
        now = self.task.now
        if name.kind in ("omega", "epsilon", "rotation"):
            order = name.dots if name.kind == "rotation" else 1 if name.kind == "omega" else 2
            return (now.omega if order == 1 else now.epsilon).get(name.of) if order else None
        if name.kind != "direction" or not name.dots or not {name.of, name.about} <= now.z.keys():
            return None
        arm, swing = (table[name.about] - table[name.of] for table in (now.z, now.v))
        if name.dots == 1:
            return (swing / arm).imag
        return ((now.a[name.about] - now.a[name.of]) / arm - (swing / arm) ** 2).imag

    def coordinate(self, name: Name) -> float | None:
        """A coordinate of a point, or its first or second derivative."""
        now = self.task.now
        if name.kind in ("x", "y") and name.body:
            place = self._place(name.of, name.body)
            return None if place is None else place.real if name.kind == "x" else place.imag
        if name.kind not in ("x", "y") or name.of not in now.z:
            return None
        vector = (now.z, now.v, now.a)[name.dots].get(name.of)
        return None if vector is None else vector.real if name.kind == "x" else vector.imag

    def arms(self, name: Name) -> tuple[complex, ...]:
        """The way between the two points of a length or direction, both sides of a corner; nothing for other names."""
        if name.kind in ("length", "direction") and not name.dots:
            places = [self._place(name.of, ""), self._place(name.about, name.body)]
        elif name.kind == "angle" and name.about.count(" ") == 1:
            start, end = name.about.split()
            at_vertex = name.part == "vertex"
            places = [
                self._place(name.of, name.body if at_vertex else ""),
                self._place(start, ""),
                self._place(end, "" if at_vertex else name.body),
            ]
        else:
            return ()
        first, *ends = places
        return () if first is None or None in ends else tuple(end - first for end in ends if end is not None)

    def _place(self, point: str, body: str) -> complex | None:
        """Where a point is, or the velocity (P) or acceleration centre (Q) of a body."""
        now = self.task.now
        if not body:
            return now.z.get(point)
        first, omega = self.task.scene.bodies[body][0], now.omega[body]
        if point == "P":
            return now.z[first] + 1j * now.v[first] / omega if omega else None
        turn = omega**2 - 1j * now.epsilon[body]
        return now.z[first] + now.a[first] / turn if turn else None

    def derived(self, name: Name, measure: str) -> list[float]:
        """The derived quantity of the family of that name; of another name that no datum bears, any law of time."""
        form = self.task.form
        if name.of in self.task.stated_rates:
            return []
        if name.kind != "parameter" or any(name.of == parameter.symbol for parameter in form.parameters.values()):
            return []
        names = [name.of] if name.of in form.derived else laws(form)
        names = [f"{law}{('', '_dot', '_ddot')[name.dots]}" for law in names]
        return [unit(self.task.unit_of(measure)).from_si(self.task.si[law]) for law in names]

    def answer(self, quantity: Quantity) -> float:
        """An asked quantity in its printed unit, angles in degrees; the task remembers it."""
        key, known = ("answer", quantity), self.task.remembered
        if key not in known:
            own = quantity.own_unit(self.task.variant.family.length_unit)
            known[key] = float(own.from_si(float(quantity.value(self._motion)[0])))
        found: float = known[key]
        return found

    @property
    def _motion(self) -> Motion:
        """The motion as a batch of one, in SI as the scene; the task remembers it, and with it a turn of the crank."""
        known = self.task.remembered
        if "motion in SI" not in known:
            known["motion in SI"] = self._in_metres()
        found: Motion = known["motion in SI"]
        return found

    def _in_metres(self) -> Motion:
        now, metres = self.task.now, self.task.length_unit
        vectors = [{name: np.array([n * metres]) for name, n in table.items()} for table in (now.z, now.v, now.a)]
        rates = [{body: np.array([number]) for body, number in table.items()} for table in (now.omega, now.epsilon)]
        return Motion(now.scene, np.zeros(1, dtype=np.int8), np.ones(1), *vectors, *rates)


def _component(whole: complex, words: list[str]) -> complex:
    """The component of a vector along an axis of the paper if one is named."""
    return complex(whole.real) if "x" in words else 1j * whole.imag if "y" in words else whole


def _along(vector: complex, way: complex, scale: float) -> complex:
    """The component of a vector along another one; all of it where that is zero: motion sets in along the path."""
    if abs(way) <= _NOTHING * scale:
        return vector
    unit = way / abs(way)
    return (vector * unit.conjugate()).real * unit
