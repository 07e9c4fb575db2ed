"""The vectors of points and the rates of bodies under their names in a solution: what figures of its motion draw."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from msgspec import Struct

from variantgen.algebra.name import AXES, Name


class Arrow(Struct, frozen=True):
    """A vector (m/s or m/s^2); ``sought`` says that an equation starts from its direction ``way`` (a unit vector)."""

    name: Name
    vector: complex
    sought: bool = False
    way: complex = 0j


class Axis(Struct, frozen=True):
    """An axis on which an equation is projected: its direction (a unit vector) and its letter in the text, if any."""

    way: complex
    letter: str = ""


class PointEquation(Struct, frozen=True):
    """A vector equation about a point of the ``bodies``; the vector of any other point is one arrow.

    ``terms`` are the vectors of both sides as they are written, ``axes`` those on which it is projected; ``step`` is
    the place of its step in the solution, -1 where no line shows it. ``rods`` are the ends of links that take the place
    of the mechanism.
    """

    point: str
    left: tuple[Arrow, ...]
    right: tuple[Arrow, ...]
    bodies: tuple[str, ...] = ()
    terms: tuple[Arrow, ...] = ()
    axes: tuple[Axis, ...] = ()
    step: int = -1
    rods: tuple[tuple[str, str], ...] = ()


class PointVectors(Struct, frozen=True):
    """What a solution says of one order (1 velocities, 2 accelerations).

    ``own`` are the vectors of the points themselves, ``compound`` the points whose motion is compound; ``rates`` are
    the names of the rates of all bodies.
    """

    own: Mapping[str, Arrow]
    rates: Mapping[str, Name]
    compound: frozenset[str]
    equations: tuple[PointEquation, ...]

    def terms(self, point: str) -> Iterator[Arrow]:
        """What the vector of a point is put together from, in the order of the equations.

        At B with ``a^n_B + a^tau_B = a_A + a^n_BA + a^tau_BA`` these are all five vectors.
        """
        known = {self.own[point].name}
        for equation in self.equations:
            for arrow in (*equation.left, *equation.right) if equation.point == point else ():
                if arrow.name not in known and not set(AXES) & set(arrow.name.part.split()):
                    known.add(arrow.name)
                    yield arrow
