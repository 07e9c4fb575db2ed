"""Newton's method on all positions at once (scipy.optimize.root), then the dense linear system.

The equations are the definitions of all points in double precision; the start is the true position with every point
moved by a twentieth of the mechanism's size, which is what a sketch gives.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from msgspec.structs import replace

from variantgen.accuracy.algorithms.dense import from_places
from variantgen.accuracy.computed import CaseGroup, Computed
from variantgen.accuracy.reference.definitions import definition
from variantgen.accuracy.reference.exact_scene import double_scene, kind
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.motion import Motion, take_scene
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import Plan, analyse

TITLE = "Newton on the whole, then dense"
SHORT = "Newton on the whole"
DOUBLE = True
BATCH = 5

_OFF = 0.05  # of the size: how far the start is off
_TOLERANCE = 1e-14
_LEFT = 1e-8  # of the size: residuals above this are no convergence


def applies(group: CaseGroup) -> str:
    """Always."""
    return ""


def prepare(group: CaseGroup) -> Callable[[], Computed]:
    """The starts are drawn before."""
    plan = analyse(group.scene)
    motions = [solve(take_scene(group.scene, i, group.size), 0, plan) for i in range(group.size)]
    scenes = [double_scene(group.scene, i, group.size) for i in range(group.size)]
    rng = np.random.default_rng(1)
    steps = rng.uniform(0, 2 * np.pi, (group.size, len(group.scene.points)))
    starts = [
        {
            name: complex(motion.scene.frame.unplace(z[0])) + _OFF * motion.length_scale()[0] * np.exp(1j * step)
            for (name, z), step in zip(motion.z.items(), way, strict=True)
        }
        for motion, way in zip(motions, steps, strict=True)
    ]
    return lambda: _all([_one(*item, plan) for item in zip(scenes, motions, starts, strict=True)])


def _one(scene: Scene, motion: Motion, start: Mapping[str, complex], plan: Plan) -> Computed:
    from scipy.optimize import root

    names = [name for name, item in scene.points.items() if not isinstance(item, Coordinates)]
    given = {
        name: complex(item.x.value, item.y.value)
        for name, item in scene.points.items()
        if isinstance(item, Coordinates)
    }

    def left(x: Any) -> Any:
        at = {**given, **dict(zip(names, (x[0::2] + 1j * x[1::2]).tolist(), strict=True))}
        return np.array(_equations(scene, names, at))

    first = np.array([[start[name].real, start[name].imag] for name in names]).ravel()
    size = float(motion.length_scale()[0])
    found = root(left, first, tol=_TOLERANCE) if names else None
    at = dict(given)
    if found is not None:
        at |= dict(zip(names, (found.x[0::2] + 1j * found.x[1::2]).tolist(), strict=True))
    lost = found is not None and float(np.max(np.abs(found.fun))) > _LEFT * size
    z = {name: np.atleast_1d(motion.scene.frame.place(at[name])) for name in scene.points}
    return from_places(replace(motion, z=z), np.array([lost]))


def _equations(scene: Scene, names: list[str], at: Mapping[str, complex]) -> list[float]:
    found: list[float] = []
    for name in names:
        equations = definition(kind(scene.points[name]))
        assert equations is not None, "a test sees to it that every kind has one"
        found += equations(scene.points[name], at[name], at)
    for condition in scene.conditions:
        equations = definition(kind(condition))
        assert equations is not None, "a test sees to it that every kind has one"
        found += equations(condition, at)
    return found


def _all(parts: list[Computed]) -> Computed:
    """The variants as one batch."""

    def joined(table: str) -> dict[str, Any]:
        return {name: np.concatenate([getattr(p, table)[name] for p in parts]) for name in getattr(parts[0], table)}

    flags = {name: np.concatenate([getattr(p, name) for p in parts]) for name in ("refused", "lost")}
    return Computed(joined("z"), joined("v"), joined("a"), joined("omega"), joined("epsilon"), **flags)
