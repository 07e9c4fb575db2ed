"""Other ways to compute a four-bar and a slider-crank, variant by variant the same numbers as the program's solver.

Each way takes arrays of lengths, angles and rates and finds place, velocity and acceleration of B: a closed form in
plain numpy, the same lines compiled by numba, scipy (a root of the loop equations from a guess that is 0.1 rad off,
rates by linear systems) and pylinkage (one object for each variant, told where B nearly is).
"""

from __future__ import annotations

import importlib
from cmath import phase
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, partial
from math import cos, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import root

from benchmarks import textbook

Columns = Mapping[str, NDArray[np.float64]]
Table = NDArray[np.float64]  # rows: x and y of B, of its velocity, of its acceleration; a column for each variant
Way = Callable[[], Table]
EXTRA = 'pip install ".[bench]"'
_OFF = 0.1  # rad, of the guesses


@dataclass(frozen=True)
class Mechanism:
    """A form of the catalogue that other ways compute, too.

    ``inputs`` makes the arguments of the closed form from the parameters of variants. The others take the same
    arguments for one variant and a place near B.
    """

    family: str
    form: str
    inputs: Callable[[Columns], list[NDArray[np.float64]]]
    closed: Callable[..., tuple[Any, ...]]
    by_root: Callable[..., tuple[float, ...]]
    by_object: Callable[..., tuple[float, ...]]


def numpy_way(mechanism: Mechanism, inputs: list[NDArray[np.float64]]) -> Way:
    """The closed form on arrays."""
    return lambda: np.array(mechanism.closed(*inputs)[:6])


def numba_way(mechanism: Mechanism, inputs: list[NDArray[np.float64]]) -> Way:
    """The closed form, compiled, variant by variant on one thread."""
    every, table = _compiled(mechanism.closed, len(inputs)), np.array(inputs)
    return lambda: every(table)


@cache
def _compiled(closed: Callable[..., tuple[Any, ...]], count: int) -> Callable[[Table], Table]:
    """A loop over the columns of a table with the arguments of a closed form."""
    numba = importlib.import_module("numba")
    single, spread = numba.njit(closed), numba.njit(_SPREAD[count])

    @numba.njit
    def every(table: Table) -> Table:
        found = np.empty((6, table.shape[1]))
        for i in range(table.shape[1]):
            made = spread(single, table[:, i])
            for k in range(6):
                found[k, i] = made[k]
        return found

    return every  # type: ignore[no-any-return]


# numba cannot spread an array over the arguments of a function.
_SPREAD: dict[int, Callable[..., Any]] = {
    6: lambda f, x: f(x[0], x[1], x[2], x[3], x[4], x[5]),
    8: lambda f, x: f(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]),
}


def root_way(mechanism: Mechanism, inputs: list[NDArray[np.float64]]) -> Way:
    """``scipy.optimize.root`` for each variant, then linear systems."""
    return _one_by_one(mechanism.by_root, mechanism, inputs)


def object_way(mechanism: Mechanism, inputs: list[NDArray[np.float64]]) -> Way:
    """An object of pylinkage for each variant."""
    return _one_by_one(partial(mechanism.by_object, importlib.import_module("pylinkage")), mechanism, inputs)


def _one_by_one(
    function: Callable[..., tuple[float, ...]], mechanism: Mechanism, inputs: list[NDArray[np.float64]]
) -> Way:
    known = zip(*(x.tolist() for x in mechanism.closed(*inputs)[:2]), strict=True)  # where B is: guesses start from it
    rows = [(*values, complex(*place)) for *values, place in zip(*(x.tolist() for x in inputs), known, strict=True)]
    return lambda: np.array([function(*row) for row in rows]).T


WAYS: dict[str, Callable[[Mechanism, list[NDArray[np.float64]]], Way]] = {
    "closed form, plain numpy": numpy_way,
    "closed form, numba": numba_way,
    "scipy root, linear systems": root_way,
    "pylinkage, an object each": object_way,
}


def ways(mechanism: Mechanism, inputs: list[NDArray[np.float64]]) -> Iterator[tuple[str, Way | None]]:
    """All ways on some variants by name; None where a package is missing."""
    for name, prepare in WAYS.items():
        try:
            yield name, prepare(mechanism, inputs)
        except ImportError:
            yield name, None


def four_bar_by_root(
    a: float, b: float, c: float, d: float, phi: float, w: float, e: float, side: float, known: complex
) -> tuple[float, ...]:
    """Unknown angles of coupler and rocker."""
    ax, ay = a * cos(phi), a * sin(phi)

    def loop(x: Table) -> list[float]:
        t, u = x.tolist()
        return [ax + b * cos(t) - c * cos(u) - d, ay + b * sin(t) - c * sin(u)]

    def jacobian(x: Table) -> list[list[float]]:
        t, u = x.tolist()
        return [[-b * sin(t), c * sin(u)], [b * cos(t), -c * cos(u)]]

    x = root(loop, [phase(known - complex(ax, ay)) + _OFF, phase(known - d) + _OFF], jac=jacobian, tol=1e-14).x
    matrix = jacobian(x)
    (by, cy), (bx, cx) = [-matrix[0][0], matrix[0][1]], [matrix[1][0], -matrix[1][1]]
    w2, w3 = np.linalg.solve(matrix, [w * ay, -w * ax]).tolist()
    qx = -e * ay - w * w * ax - w2 * w2 * bx + w3 * w3 * cx
    qy = e * ax - w * w * ay - w2 * w2 * by + w3 * w3 * cy
    _, e3 = np.linalg.solve(matrix, [-qx, -qy]).tolist()
    return d + cx, cy, -w3 * cy, w3 * cx, -e3 * cy - w3 * w3 * cx, e3 * cx - w3 * w3 * cy


def slider_crank_by_root(
    a: float, b: float, h: float, phi: float, w: float, e: float, known: complex
) -> tuple[float, ...]:
    """Unknown angle of the coupler and place of the slider."""
    ax, ay = a * cos(phi), a * sin(phi)

    def loop(x: Table) -> list[float]:
        t, along = x.tolist()
        return [ax + b * cos(t) - along, ay + b * sin(t) - h]

    def jacobian(x: Table) -> list[list[float]]:
        t, _ = x.tolist()
        return [[-b * sin(t), -1.0], [b * cos(t), 0.0]]

    x = root(loop, [phase(known - complex(ax, ay)) + _OFF, known.real + _OFF * b], jac=jacobian, tol=1e-14).x
    matrix = jacobian(x)
    bx, by = matrix[1][0], -matrix[0][0]
    w2, v = np.linalg.solve(matrix, [w * ay, -w * ax]).tolist()
    qx, qy = -e * ay - w * w * ax - w2 * w2 * bx, e * ax - w * w * ay - w2 * w2 * by
    _, acceleration = np.linalg.solve(matrix, [-qx, -qy]).tolist()
    return float(x[1]), h, v, 0.0, acceleration, 0.0


def four_bar_by_object(
    pylinkage: Any, a: float, b: float, c: float, d: float, phi: float, w: float, e: float, side: float, known: complex
) -> tuple[float, ...]:
    """A crank and a dyad of two hinged rods."""
    first, second = pylinkage.Ground(0.0, 0.0), pylinkage.Ground(d, 0.0)
    crank = pylinkage.Crank(anchor=first, radius=a, initial_angle=phi)
    dyad = pylinkage.RRRDyad(crank.output, second, b, c, known.real + _OFF * b, known.imag)
    return _of_linkage(pylinkage.Linkage([first, second, crank, dyad]), crank, w, e)


def slider_crank_by_object(
    pylinkage: Any, a: float, b: float, h: float, phi: float, w: float, e: float, known: complex
) -> tuple[float, ...]:
    """A crank and a dyad of a rod and a slider."""
    first, left, right = pylinkage.Ground(0.0, 0.0), pylinkage.Ground(0.0, h), pylinkage.Ground(1.0, h)
    crank = pylinkage.Crank(anchor=first, radius=a, initial_angle=phi)
    dyad = pylinkage.RRPDyad(crank.output, left, right, b, known.real + _OFF * b, known.imag)
    return _of_linkage(pylinkage.Linkage([first, left, right, crank, dyad]), crank, w, e)


def _of_linkage(linkage: Any, crank: Any, w: float, e: float) -> tuple[float, ...]:
    """What one step without motion finds for the last component."""
    linkage.set_input_velocity(crank, omega=w, alpha=e)
    places, velocities, accelerations = next(linkage.step_with_derivatives(1, dt=0))
    return (*places[-1], *velocities[-1], *accelerations[-1])


MECHANISMS = (
    Mechanism(
        "four_bar",
        "crank",
        lambda p: [
            *(p[name] for name in ("OA", "AB", "BC", "OC", "phi")),
            p["sense"] * p["omega_OA"],
            p["epsilon_OA"],
            p["side"],
        ],
        textbook.four_bar,
        four_bar_by_root,
        four_bar_by_object,
    ),
    Mechanism(
        "slider_crank",
        "offset",
        lambda p: [p["OA"], p["AB"], p["above"] * p["e"], p["phi"], p["sense"] * p["omega_OA"], p["epsilon_OA"]],
        textbook.slider_crank,
        slider_crank_by_root,
        slider_crank_by_object,
    ),
)
