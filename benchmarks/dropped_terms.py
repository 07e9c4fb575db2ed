"""Mistakes worked out anew for the benchmark of marking: the equations of a mechanism with a term dropped or turned.

Nothing of the table that marking searches enters. The unknowns are the accelerations of points, the angular ones of
bodies and the relative ones of sliding points; for points P, Q of a body, r from P to Q, and a point S that slides on
it along u, all as complex numbers:

- ``a_Q = a_P + i epsilon r - omega^2 r`` (the last term is the normal one), pivots have ``a = 0``;
- ``a_S = a_P + i epsilon r - omega^2 r + 2 i omega v_rel + a_rel u`` (the last but one is that of Coriolis);
- a point in a guide keeps to its line, what is driven has its given acceleration.

They are solved by least squares. Mechanisms with other joints have no such equations here. Angles in degrees for
radians, and the other branch where it is a choice of the family, are variants with another datum.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from math import degrees

import numpy as np
from msgspec.structs import replace

from variantgen.exam.sheets import Answer
from variantgen.families.quantities import motion_order
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.scene import Scene
from variantgen.variants.variant import Variant, solve_variants

_SAME = 1e-6  # relative
_KINDS = ("a", "epsilon", "a_rel")
Shares = Mapping[str, float]  # of terms by name: 0 where one is dropped, -1 where it is turned


@dataclass(frozen=True)
class _Row:
    """An equation: its coefficients by unknown, and the other side."""

    coefficients: Mapping[tuple[str, str], complex]
    side: complex


class Mistaken:
    """The accelerations of one solved motion, arrays of shape (1,), by equations with terms left out."""

    def __init__(self, motion: Motion) -> None:
        self.motion, self.scene = motion, motion.scene
        self.z, self.v, self.a = ({n: complex(x[0]) for n, x in t.items()} for t in (motion.z, motion.v, motion.a))
        self.omega = {body: float(x[0]) for body, x in motion.omega.items()}
        self.epsilon = {body: float(x[0]) for body, x in motion.epsilon.items()}
        found = self.solved({})
        size = max(map(abs, self.a.values()))
        self.usable = has_own_equations(self.scene) and all(
            abs(found["a", point] - self.a[point]) <= _SAME * size
            for points in self.scene.bodies.values()
            for point in points
        )

    def names(self) -> list[str]:
        """The terms that may be dropped or turned."""
        turning = [f"normal acceleration of {body}" for body, omega in self.omega.items() if omega]
        sliding = [f"Coriolis acceleration of {joint.point}" for joint in self._slots() if self.omega[joint.body]]
        return [*turning, *sliding, "given accelerations"]

    def solved(self, shares: Shares) -> dict[tuple[str, str], complex]:
        """The unknowns by kind and name."""
        rows = [*self._bodies(shares), *self._sliding(shares), *self._held(shares)]
        names = list(dict.fromkeys(name for row in rows for name in row.coefficients))
        places = {name: k for k, name in enumerate(names)}
        table, sides = np.zeros((2 * len(rows), 2 * len(names))), np.zeros(2 * len(rows))
        for k, row in enumerate(rows):
            for name, c in row.coefficients.items():
                j = 2 * places[name]
                table[2 * k : 2 * k + 2, j : j + 2] = [[c.real, -c.imag], [c.imag, c.real]]
            sides[2 * k : 2 * k + 2] = row.side.real, row.side.imag
        real = [2 * places[name] + 1 for name in names if name[0] != "a"]
        table[:, real] = 0.0  # rates and ways along a line are real numbers
        found = np.linalg.lstsq(table, sides, rcond=None)[0]
        return {name: complex(found[2 * k], found[2 * k + 1]) for name, k in places.items()}

    def value(self, answer: Answer, shares: Shares) -> float | None:
        """What an answer becomes, in its unit; None for what these equations do not tell."""
        asked = answer.quantity
        if asked.kind not in _KINDS:
            return None
        found = self.solved(shares)
        if asked.kind == "a_rel":
            value = abs(found.get(("a_rel", asked.target), np.nan)) if not asked.component else np.nan
        else:
            kind = {asked.kind: {asked.target: np.array([found.get((asked.kind, asked.target), np.nan)])}}
            if asked.kind == "epsilon":
                kind["epsilon"] = {asked.target: kind["epsilon"][asked.target].real}
            value = float(asked.value(replace(self.motion, **kind))[0])  # type: ignore[arg-type]
        return answer.unit.from_si(float(value)) if np.isfinite(value) else None

    def _slots(self) -> list[Slot]:
        return [joint for joint in self.scene.joints if isinstance(joint, Slot)]

    def _bodies(self, shares: Shares) -> Iterator[_Row]:
        for body, (first, *others) in self.scene.bodies.items():
            for other in others:
                r = self.z[other] - self.z[first]
                normal = -shares.get(f"normal acceleration of {body}", 1.0) * self.omega[body] ** 2 * r
                yield _Row({("a", other): 1, ("a", first): -1, ("epsilon", body): -1j * r}, normal)

    def _sliding(self, shares: Shares) -> Iterator[_Row]:
        for joint in self._slots():
            point, body, (first, second) = joint.point, joint.body, joint.along
            r, u = self.z[point] - self.z[first], self.z[second] - self.z[first]
            u, omega = u / abs(u), self.omega[body]
            sliding = self.v[point] - self.v[first] - 1j * omega * r
            side = -shares.get(f"normal acceleration of {body}", 1.0) * omega**2 * r
            side += shares.get(f"Coriolis acceleration of {point}", 1.0) * 2j * omega * sliding
            unknown = {("a", point): 1, ("a", first): -1, ("epsilon", body): -1j * r, ("a_rel", point): -u}
            yield _Row(unknown, side)
            if joint.sleeve is not None:
                yield _Row({("epsilon", body): 1, ("epsilon", joint.sleeve): -1}, 0)

    def _held(self, shares: Shares) -> Iterator[_Row]:
        given = shares.get("given accelerations", 1.0)
        for joint in self.scene.joints:
            if isinstance(joint, Pivot):
                yield _Row({("a", joint.point): 1}, 0)
            elif isinstance(joint, Guide) and self.v[joint.point]:
                way = self.v[joint.point] / abs(self.v[joint.point])
                yield _Row({("a", joint.point): 1, ("along", joint.point): -way}, 0)
        for driver in self.scene.drivers:
            if isinstance(driver, Rotation):
                yield _Row({("epsilon", driver.body): 1}, given * self.epsilon[driver.body])
            elif isinstance(driver, Travel):
                yield _Row({("a", driver.point): 1}, given * self.a[driver.point])


def has_own_equations(scene: Scene) -> bool:
    """Whether all joints and drivers of a mechanism are of kinds that have equations here."""
    return all(isinstance(joint, Pivot | Guide | Slot) for joint in scene.joints) and all(
        isinstance(driver, Travel) or (isinstance(driver, Rotation) and driver.relative_to is None)
        for driver in scene.drivers
    )


def planted_anew(variant: Variant, answers: Sequence[Answer]) -> Iterator[tuple[str, int, float]]:
    """Mistakes of one variant: the name, the place of the answer, what the answer becomes in its unit."""
    motion = solve_variants([variant], 2)
    if has_own_equations(motion.scene) and motion_order([answer.quantity for answer in answers]) == 2:
        mistaken = Mistaken(motion)
        for name in mistaken.names() if mistaken.usable else ():
            for how, share in (("forgotten", 0.0), ("reversed", -1.0)):
                for place, answer in enumerate(answers):
                    value = mistaken.value(answer, {name: share})
                    if value is not None:
                        yield f"{name} {how}", place, value
    for name, other in _other_data(variant):
        wrong = solve_variants([other], motion_order([answer.quantity for answer in answers]))
        if wrong.solved[0]:
            for place, answer in enumerate(answers):
                yield name, place, float(answer.unit.from_si(float(answer.quantity.value(wrong)[0])))


def _other_data(variant: Variant) -> Iterator[tuple[str, Variant]]:
    """The variant with an angle of so many radians as it has degrees, or on the other branch."""
    for name, parameter in variant.form.parameters.items():
        if parameter.given and parameter.unit is not None and parameter.unit.name == "deg":
            turned = Decimal(repr(degrees(float(variant.printed[name]))))
            yield f"{name} in degrees for radians", replace(variant, printed={**variant.printed, name: turned})
        elif name == "branch":
            yield "branch", replace(variant, printed={**variant.printed, name: -variant.printed[name]})
