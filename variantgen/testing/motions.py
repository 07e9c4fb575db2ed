"""A motion from the arrays of any solver."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from variantgen.errors import InputError, Problem, nearest
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.joint import Pair
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.motion import Motion
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
    in any coherent units. Real numbers of the shape (2,) are one vector (x, y), never two variants that lie on the x
    axis: give those as complex numbers. ``bodies`` names the points of each rigid body. ``pivots`` are points at rest,
    ``slots`` says for a sliding point the body and two points of its straight slot, ``rolling`` for a wheel on a fixed
    rail its centre and its point of contact. What is left out cannot be looked at. Raises InputError for names that do
    not fit together.
    """
    tables = {name: {k: _vector(x) for k, x in (table or {}).items()} for name, table in (("z", z), ("v", v), ("a", a))}
    rates = {name: {k: np.asarray(x, dtype=float) for k, x in (table or {}).items()} for name, table in
             (("omega", omega), ("epsilon", epsilon))}  # fmt: skip
    slots, rolling = slots or {}, rolling or {}
    problems = [*_problems(bodies, tables, rates), *_joint_problems(bodies, tables, pivots, slots, rolling)]
    if problems:
        raise InputError(problems)
    shape = np.broadcast_shapes(
        (1,), *(x.shape for table in (*tables.values(), *rates.values()) for x in table.values())
    )

    def full(table: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
        return {name: np.broadcast_to(x, shape) for name, x in table.items()}

    joints: list[Pair] = [Pivot(point) for point in pivots]
    joints += [Slot(point, body, (start, end)) for point, (body, start, end) in slots.items()]
    joints += [Rolling(body, centre, contact) for body, (centre, contact) in rolling.items()]
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


def _problems(
    bodies: Mapping[str, Sequence[str]],
    tables: Mapping[str, Mapping[str, NDArray[Any]]],
    rates: Mapping[str, Mapping[str, NDArray[Any]]],
) -> Iterator[Problem]:
    """Bodies without points, points without a place or a velocity, and vectors and rates of what is not there."""
    for body, members in bodies.items():
        if not members:
            yield Problem("expected the names of its points", key=f"bodies.{body}", value=repr(members))
    needed = {point for members in bodies.values() for point in members}
    for name, table in tables.items():
        for point in sorted(needed - table.keys()) if name != "a" or table else ():
            yield Problem(f"the point {point} of a body is missing", key=name, remedy="give all points of all bodies")
        for point in [point for point in table if point not in tables["z"]]:
            yield Problem("has no place in z", key=name, value=point, remedy=nearest(point, tables["z"]))
    for name, table in rates.items():
        for body in [body for body in table if body not in bodies]:
            yield Problem("is no body", key=name, value=body, remedy=nearest(body, bodies))


def _joint_problems(
    bodies: Mapping[str, Sequence[str]],
    tables: Mapping[str, Mapping[str, NDArray[Any]]],
    pivots: Sequence[str],
    slots: Mapping[str, Any],
    rolling: Mapping[str, Any],
) -> Iterator[Problem]:
    """What pivots, slots and rolling wheels name and is not there."""

    def moving(point: str, key: str) -> Iterator[Problem]:
        lacking = [name for name, table in tables.items() if point not in table and (name != "a" or table)]
        if lacking:
            message = f"this point is missing in {', '.join(lacking)}"
            yield Problem(message, key=key, value=point, remedy=nearest(point, tables["z"]))

    def of_body(key: str, body: str, *points: str) -> Iterator[Problem]:
        if body not in bodies:
            yield Problem("is no body", key=key, value=body, remedy=nearest(body, bodies))
        for point in points if body in bodies else ():
            if point not in bodies[body]:
                yield Problem(f"is no point of {body}", key=key, value=point, remedy=nearest(point, bodies[body]))

    for point in pivots:
        yield from moving(point, "pivots")
    for point, given in slots.items():
        yield from moving(point, "slots")
        if _are_names(given, 3):
            yield from of_body(f"slots.{point}", *given)
        else:
            yield Problem("expected a body and two of its points", key=f"slots.{point}", value=repr(given))
    for body, given in rolling.items():
        if not _are_names(given, 2):
            yield Problem("expected its centre and its point of contact", key=f"rolling.{body}", value=repr(given))
            continue
        centre, contact = given
        yield from of_body("rolling" if body not in bodies else f"rolling.{body}", body, centre)
        if contact not in tables["z"]:
            remedy = nearest(contact, tables["z"])
            yield Problem("has no place in z", key=f"rolling.{body}", value=contact, remedy=remedy)


def _are_names(given: Any, count: int) -> bool:
    return isinstance(given, list | tuple) and len(given) == count and all(isinstance(name, str) for name in given)
