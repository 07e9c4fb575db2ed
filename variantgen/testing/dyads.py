"""Random chains: a crank and dyads (Assur groups of two links) after it, placed so that they assemble."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable

from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.fraction import SegmentFraction
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joint import Pair
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.scene import Construction, Scene

Choices = tuple[float, float, float, float, float]

# Angles between the two rods of a dyad, and between a rod and its guide, that keep away from dead points (rad).
_BETWEEN, _OFF_GUIDE = (math.radians(40), math.radians(140)), math.radians(50)
_LENGTHS, _APART = (0.3, 1.2), 0.2  # m, of rods; of hinges that two rods join


def chain(crank: float, phi: float, omega: float, epsilon: float, dyads: Iterable[Choices]) -> Scene:
    """A crank OA (m) at the angle phi (rad) with its rates, and a dyad for each five numbers from 0 to 1.

    The numbers choose kind, hinge, direction, size and angle of the dyad. Its first rod starts from a hinge that is
    there; points are placed by coordinates, so that every dyad assembles.
    """
    build = _Chain(crank, phi)
    for choices in dyads:
        build.add(*choices)
    return Scene(build.points, build.bodies, tuple(build.joints), (Rotation("OA", omega, epsilon),))


class _Chain:
    """What there is of a chain, with the places of its moving hinges (m)."""

    def __init__(self, crank: float, phi: float) -> None:
        self.moving = {"A": cmath.rect(crank, phi)}
        self.points: dict[str, Construction] = {"O": Coordinates(0.0, 0.0), "A": _at(self.moving["A"])}
        self.bodies: dict[str, tuple[str, ...]] = {"OA": ("O", "A")}
        self.joints: list[Pair] = [Pivot("O")]

    def add(self, kind: float, hinge: float, direction: float, size: float, angle: float) -> None:
        """A further dyad, by numbers from 0 to 1."""
        number = len(self.moving)
        names = list(self.moving)
        start = names[min(int(hinge * number), number - 1)]
        others = [name for name in names if abs(self.moving[name] - self.moving[start]) > _APART]
        length = _LENGTHS[0] + size * (_LENGTHS[1] - _LENGTHS[0])
        way = cmath.rect(length, 2 * math.pi * direction)
        joint, pivot = f"B{number}", f"C{number}"
        if kind < 0.3:
            self._two_rods(start, joint, pivot, way, angle)
        elif kind < 0.5 and others:
            self._bridge(start, others[-1], joint, angle)
        elif kind < 0.75:
            self._slider(start, joint, way, angle)
        else:
            self._rocker(start, pivot, f"D{number}", way)

    def _two_rods(self, start: str, joint: str, pivot: str, way: complex, angle: float) -> None:
        """Rods from a hinge to a new one and from there to a fixed pivot."""
        place = self._hinge(start, joint, self.moving[start] + way)
        between = _BETWEEN[0] + angle * (_BETWEEN[1] - _BETWEEN[0])
        self._pivot(pivot, place - 0.9 * way * cmath.exp(1j * between))
        self.bodies[pivot + joint] = (pivot, joint)

    def _bridge(self, start: str, other: str, joint: str, angle: float) -> None:
        """Rods from two moving hinges to a new one, on the bisector between them."""
        first, second = self.moving[start], self.moving[other]
        between = _BETWEEN[0] + angle * (_BETWEEN[1] - _BETWEEN[0])
        aside = 0.5j * (second - first) / math.tan(0.5 * between)
        self._hinge(start, joint, 0.5 * (first + second) + aside)
        self.bodies[other + joint] = (other, joint)

    def _slider(self, start: str, joint: str, way: complex, angle: float) -> None:
        """A rod to a slider on a fixed guide."""
        self._hinge(start, joint, self.moving[start] + way)
        self.joints.append(Guide(joint, cmath.phase(way) + (2 * angle - 1) * _OFF_GUIDE))

    def _rocker(self, start: str, pivot: str, end: str, way: complex) -> None:
        """A rocker about a fixed pivot with a slot in which a hinge slides; its end is a hinge for more."""
        self._pivot(pivot, self.moving[start] - way)
        self.points[end] = SegmentFraction(pivot, start, 1.5)
        self.moving[end] = self.moving[start] + 0.5 * way
        self.bodies[pivot + end] = (pivot, end)
        self.joints.append(Slot(start, pivot + end, (pivot, end)))

    def _hinge(self, start: str, joint: str, place: complex) -> complex:
        """A new hinge at the end of a rod from another one."""
        self.points[joint], self.moving[joint] = _at(place), place
        self.bodies[start + joint] = (start, joint)
        return place

    def _pivot(self, name: str, place: complex) -> None:
        self.points[name] = _at(place)
        self.joints.append(Pivot(name))


def _at(place: complex) -> Coordinates:
    return Coordinates(place.real, place.imag)
