"""A motion from the arrays of any solver."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from variantgen.errors import InputError, Problem, nearest
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Pair
from variantgen.mechanism.scene import Scene

Vectors = Mapping[str, ArrayLike]


def motion_of(
    bodies: Mapping[str, Sequence[str]],
    z: Vectors,
    v: Vectors,
    a: Vectors | None = None,
    omega: Vectors | None = None,
    epsilon: Vectors | None = None,
    *,
    pivots: Sequence[str] = (),
    slots: Mapping[str, tuple[str, str, str]] | None = None,
    rolling: Mapping[str, tuple[str, str]] | None = None,
) -> Motion:
    """A motion from positions, velocities and accelerations of points and rotations of bodies, by any solver.

    Vectors are complex numbers x + iy or pairs (x, y), of one variant or of N: of the shape (), (N,), (2,) or (N, 2);
    in any coherent units. ``bodies`` names the points of each rigid body. ``pivots`` are points at rest, ``slots`` says
    for a sliding point the body and two points of its straight slot, ``rolling`` for a wheel on a fixed rail its centre
    and its point of contact. What is left out cannot be looked at. Raises InputError for names that do not fit
    together.
    """
    tables = {name: {k: _vector(x) for k, x in (table or {}).items()} for name, table in (("z", z), ("v", v), ("a", a))}
    rates = {name: {k: np.asarray(x, dtype=float) for k, x in (table or {}).items()} for name, table in
             (("omega", omega), ("epsilon", epsilon))}  # fmt: skip
    _check(bodies, tables, rates)
    shape = np.broadcast_shapes(
        (1,), *(x.shape for table in (*tables.values(), *rates.values()) for x in table.values())
    )

    def full(table: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
        return {name: np.broadcast_to(x, shape) for name, x in table.items()}

    joints: list[Pair] = [Pivot(point) for point in pivots]
    joints += [Slot(point, body, (start, end)) for point, (body, start, end) in (slots or {}).items()]
    joints += [Rolling(body, centre, contact) for body, (centre, contact) in (rolling or {}).items()]
    places = full(tables["z"])
    scene = Scene(
        {name: Coordinates(np.real(place), np.imag(place)) for name, place in places.items()},
        {body: tuple(members) for body, members in bodies.items()},
        tuple(joints),
    )
    v_a = full(tables["v"]), full(tables["a"])
    return Motion(
        scene, np.zeros(shape, np.int8), np.ones(shape), places, *v_a, full(rates["omega"]), full(rates["epsilon"])
    )


def _vector(x: ArrayLike) -> NDArray[np.complex128]:
    given = np.asarray(x)
    if not np.iscomplexobj(given) and given.shape[-1:] == (2,):
        return np.asarray(given[..., 0] + 1j * given[..., 1])
    return given.astype(complex)


def _check(
    bodies: Mapping[str, Sequence[str]],
    tables: Mapping[str, Mapping[str, NDArray[Any]]],
    rates: Mapping[str, Mapping[str, NDArray[Any]]],
) -> None:
    """Raise InputError for a point of a body without a place or a velocity, and for rates of what is no body."""
    needed = {point for members in bodies.values() for point in members}
    problems = [
        Problem(f"the point {point} of a body is missing", key=name, remedy="give all points of all bodies")
        for name, table in tables.items()
        for point in sorted(needed - table.keys())
        if name != "a" or table
    ]
    problems += [
        Problem("is no body", key=name, value=body, remedy=nearest(body, bodies))
        for name, table in rates.items()
        for body in table
        if body not in bodies
    ]
    if problems:
        raise InputError(problems)
