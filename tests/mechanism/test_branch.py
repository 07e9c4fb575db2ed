"""The branch on which points placed together end is that of their picture, by a path followed in very small steps."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.joint_scenes import class_three
from variantgen.mechanism.assembly import assemble
from variantgen.mechanism.conditions.angle import LinkAngle
from variantgen.mechanism.conditions.distance import Distance
from variantgen.mechanism.conditions.line import PointOnLine

Array = NDArray[Any]
Picture = dict[str, Array]
Problem = tuple[Picture, dict[str, Array], list[Any]]  # picture, known points, conditions

COUNT, STEPS = 400, 1000


def left(conditions: list[Any], at: dict[str, Array]) -> Array:
    """What the conditions leave, shape (N, conditions): squares of distances, vector products."""
    found = []
    for item in conditions:
        if isinstance(item, Distance):
            found.append(np.abs(at[item.end] - at[item.start]) ** 2 - item.length**2)
            continue
        if isinstance(item, LinkAngle):
            way = (at[item.first[1]] - at[item.first[0]]) * np.exp(1j * item.size)
            link = at[item.second[1]] - at[item.second[0]]
        else:
            way = at[item.towards] - at[item.through] if item.towards else np.exp(1j * np.asarray(item.angle))
            link = at[item.point] - at[item.through]
        found.append(way.real * link.imag - way.imag * link.real)
    return np.stack(np.broadcast_arrays(*found), axis=-1)


def followed(problem: Problem, steps: int) -> tuple[Array, Array]:
    """Places at the end of ``left = (1 - s) left of the picture``, shape (N, points), and along the way the determinant
    of the Jacobian with rows of length one, positive in the picture, shape (steps, N).

    One step of Newton's method for each of s, some more at its end. The Jacobian is that of central differences, which
    are exact where all is quadratic.
    """
    picture, known, conditions = problem
    z = np.stack(list(picture.values()), axis=-1)

    def leaves(z: Array) -> Array:
        return left(conditions, {**known, **{name: z[:, i] for i, name in enumerate(picture)}})

    def jacobian(z: Array) -> Array:
        columns = []
        for i in range(z.shape[1]):
            for way in (1.0, 1.0j):
                move = np.zeros(z.shape[1], dtype=complex)
                move[i] = way
                columns.append((leaves(z + move) - leaves(z - move)) / 2)
        return np.stack(columns, axis=-1)

    start = leaves(z)
    determinants = []
    # The steps grow shorter towards the end, where a position may be nearly singular.
    for s in [*(1.0 - np.linspace(1.0, 0.0, steps + 1)[1:] ** 2), *np.ones(6)]:
        matrix = jacobian(z)
        determinants.append(np.linalg.det(matrix / np.linalg.norm(matrix, axis=2, keepdims=True)))
        matrix[np.abs(determinants[-1]) < 1e-13] = np.eye(matrix.shape[1])
        move = np.linalg.solve(matrix, ((1.0 - s) * start - leaves(z))[..., None])[..., 0]
        # A path that has come to its end would be thrown anywhere.
        move = np.where(np.max(np.abs(move), axis=-1, keepdims=True) > 1.0, 0.0, move)
        z = z + move[:, 0::2] + 1j * move[:, 1::2]
    return z, np.array(determinants) * np.sign(determinants[0])


def three_rods(count: int, random: np.random.Generator) -> Problem:
    """A plate on three rods of wildly varied lengths, of which many cannot be assembled or only past a dead point."""
    scene = class_three()
    at = {name: np.full(count, place) for name, place in (("D", 1.5 - 0.5j), ("E", 1.8 + 1.5j))}
    at["A"] = 0.3 * np.exp(1j * random.uniform(-0.5, 2.5, count))
    picture = {
        name: place + random.uniform(-0.1, 0.1, count) + 1j * random.uniform(-0.1, 0.1, count)
        for name, place in (("B", 0.9 + 0.45j), ("G", 1.35 + 0.35j), ("F", 1.15 + 0.8j))
    }
    conditions = [
        Distance(item.start, item.end, item.length * random.uniform(0.85, 1.15, count))
        for item in scene.conditions
        if isinstance(item, Distance)
    ]
    return picture, at, conditions


def nearly_concurrent(count: int, random: np.random.Generator) -> Problem:
    """A plate whose rods, when it is assembled, nearly meet in one point, so that it is nearly at a dead point."""
    plate = {"B": 0.0 + 0.0j, "G": 0.45 - 0.1j, "F": 0.25 + 0.35j}
    meet = random.uniform(0.6, 1.5, count) * np.exp(1j * random.uniform(-np.pi, np.pi, count))
    known, lengths = {}, {}
    for point, pivot in (("B", "A"), ("G", "D"), ("F", "E")):
        off = 10.0 ** -random.uniform(0.5, 4.0, count) * random.choice([-1.0, 1.0], count)
        way = (meet - plate[point]) / np.abs(meet - plate[point]) * np.exp(1j * off)
        lengths[point] = random.uniform(0.3, 1.2, count)
        known[pivot] = plate[point] + lengths[point] * way
    turned = np.exp(1j * random.uniform(-0.3, 0.3, count))
    moved = 0.1 * random.normal(size=count) + 0.1j * random.normal(size=count)
    picture = {name: z * turned + moved for name, z in plate.items()}
    sides = [Distance(p, q, abs(plate[q] - plate[p])) for p, q in (("B", "G"), ("G", "F"), ("F", "B"))]
    rods = [Distance(q, p, lengths[p]) for p, q in (("B", "A"), ("G", "D"), ("F", "E"))]
    return picture, known, [*rods, *sides]


def guided_plate(count: int, random: np.random.Generator) -> Problem:
    """A plate with two points in guides and a rod at its third."""
    angle = random.uniform(0.3, 1.3, count)
    turn = random.uniform(1.2, 1.9, count)
    picture = {
        "C": 0.4 * np.cos(angle) + 0.05j,
        "D": 0.4j * np.sin(angle) + 0.05,
        "B": random.uniform(0.4, 0.6, count) * (1.0 + 1.0j),
    }
    conditions = [
        PointOnLine("C", "E", 0.0),
        PointOnLine("D", "E", turn),
        Distance("C", "D", random.uniform(0.3, 0.5, count)),
        Distance("B", "C", random.uniform(0.4, 0.7, count)),
        Distance("B", "D", random.uniform(0.4, 0.7, count)),
        Distance("A", "B", random.uniform(0.3, 0.7, count)),
    ]
    at = {"E": np.zeros(count, dtype=complex), "A": 1.0 + 0.3j + 0.3 * np.exp(1j * random.uniform(-3.1, 3.1, count))}
    return picture, at, conditions


def rod_at_an_angle(count: int, random: np.random.Generator) -> Problem:
    """A slider-crank at the instant when crank and rod are at an angle, its slider on a line through two points."""
    picture = {
        "A": 0.2 * np.exp(1j * random.uniform(0.2, 2.9, count)),
        "B": random.uniform(0.3, 0.8, count) + 1j * random.uniform(-0.1, 0.1, count),
    }
    at = {
        "O": np.zeros(count, dtype=complex),
        "P": 1j * random.uniform(-0.2, 0.2, count),
        "Q": np.full(count, 1.0 + 0j),
    }
    conditions = [
        Distance("O", "A", random.uniform(0.1, 0.5, count)),
        Distance("A", "B", random.uniform(0.2, 0.9, count)),
        PointOnLine("B", "P", towards="Q"),
        LinkAngle(("A", "O"), ("A", "B"), random.uniform(0.5, 2.6, count)),
    ]
    return picture, at, conditions


@pytest.mark.parametrize("make", [three_rods, nearly_concurrent, guided_plate, rod_at_an_angle])
def test_the_branch_is_that_of_a_path_in_very_small_steps(make: Callable[..., Problem]) -> None:
    problem = make(COUNT, np.random.default_rng(7))
    places, found = assemble(*problem)
    z, determinants = followed(problem, STEPS)
    away = np.max(np.abs(np.stack(list(places.values()), axis=-1) - z), axis=1)
    least = np.min(determinants, axis=0)
    assert 0.1 < np.mean(found) < 1.0
    # What was found is where the path ends, and the path does not pass a singular position.
    assert np.max(away[found]) < 1e-10
    assert np.min(least[found]) > 0.0
    # What was refused comes to a singular position, or so near to one all the way that the steps would be too many.
    assert np.max(least[~found]) < 0.02


def test_a_variant_has_the_same_place_alone_and_in_a_batch() -> None:
    picture, known, conditions = three_rods(5000, np.random.default_rng(3))
    places, found = assemble(picture, known, conditions)
    for i in (*np.flatnonzero(found)[:5], *np.flatnonzero(~found)[:5], 4999):
        one = [Distance(c.start, c.end, c.length[i]) for c in conditions]
        alone, also = assemble({k: z[i] for k, z in picture.items()}, {k: z[i] for k, z in known.items()}, one)
        assert also.tolist() == [found[i]]
        assert all(alone[name][0] == places[name][i] for name in picture)
