"""The form in which joints and drivers state their constraints at the levels of position, velocity, acceleration.

Every constraint is linear in the velocities: a :class:`ScalarRow` is one real equation, a :class:`VectorRow` gives
the velocity of one point by that of a pole and the angular velocities of bodies. At the level of accelerations the
same coefficients stand before the accelerations, and a term quadratic in the velocities is added.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol, TypeAlias

import numpy as np
from msgspec import Struct, field

from variantgen.mechanism.arithmetic import Complex, Real, from_parts, unit_vector


class Frame(Struct, frozen=True):
    """How a scene is laid on the paper: left and right exchanged (``sense`` -1), then a rotation (``turn``).

    Constructions work in the scene's own frame; everything after that works on paper. ``turn`` is a unit complex
    number, both may be arrays over the batch.
    """

    turn: Complex = 1.0
    sense: Real = 1.0

    @property
    def plain(self) -> bool:
        """Whether everything lies on paper as in the scene, for all variants."""
        return isinstance(self.turn, float) and isinstance(self.sense, float) and self.turn == self.sense == 1.0

    def place(self, z: Complex) -> Complex:
        """A point or vector of the scene, on paper."""
        if self.plain:
            return z
        result: Complex = self.turn * from_parts(self.sense * np.real(z), np.imag(z))
        return result

    def unplace(self, z: Complex) -> Complex:
        """The inverse of :meth:`place`: what is on paper, in the scene."""
        back = np.conj(self.turn) * z
        result: Complex = from_parts(self.sense * np.real(back), np.imag(back))
        return result

    def direction(self, angle: Real) -> Complex:
        """Unit vector on paper of a direction given in the scene's own frame (rad)."""
        return self.place(unit_vector(angle))


class Placement(Struct, frozen=True):
    """A configuration: positions of points (m) and, in verification, rotations of bodies since the start (rad)."""

    z: Mapping[str, Complex]
    frame: Frame = Frame()
    turned: Mapping[str, Real] = field(default_factory=dict)


class Speeds(Struct, frozen=True):
    """Velocities of points (m/s) and angular velocities of bodies (rad/s) that are already known."""

    v: Mapping[str, Complex]
    omega: Mapping[str, Real]


class Shape(Struct, frozen=True):
    """Which points and bodies a row couples.

    ``given_point`` names the point whose velocity a vector row gives, ``pole`` the point whose velocity it starts from.
    """

    points: tuple[str, ...] = ()
    bodies: tuple[str, ...] = ()
    given_point: str | None = None
    pole: str | None = None


class ScalarRow(Struct, frozen=True):
    """``sum Re(conj(c_P) v_P) + sum k_b omega_b = rate`` with ``points`` c_P and ``bodies`` k_b."""

    points: Mapping[str, Complex]
    bodies: Mapping[str, Real] = field(default_factory=dict)


class VectorRow(Struct, frozen=True):
    """``v_point = v_pole + sum c_b omega_b`` with ``bodies`` c_b (v_pole where the shape names a pole).

    At the level of accelerations the quadratic term is added.
    """

    point: str
    bodies: Mapping[str, Complex] = field(default_factory=dict)


Row: TypeAlias = ScalarRow | VectorRow


class Constraint(Protocol):
    """The interface of a joint or a driver for the solver and the verification, which know nothing else of it."""

    def shapes(self) -> tuple[Shape, ...]:
        """The structure of the rows, without numbers."""
        ...

    def rows(self, at: Placement) -> tuple[Row, ...]:
        """The rows with their coefficients, in the order of ``shapes``."""
        ...

    def rates(self, order: int) -> tuple[Real, ...]:
        """Right-hand side per row: prescribed velocity (order 1) or acceleration (order 2); zero for joints."""
        ...

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Per row, what the velocities add at the level of accelerations.

        Real and on the left-hand side for a scalar row, complex and on the right-hand side for a vector row.
        """
        ...

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """The residual of the constraint at the level of positions, ``time`` seconds after the start (m or rad).

        Written without the rows, so that the two can be checked against each other.
        """
        ...
