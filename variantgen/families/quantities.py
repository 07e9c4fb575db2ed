"""The quantities that may be asked: their names, dimensions and values.

``v_B a_B`` (magnitudes of a point's velocity and acceleration), ``v_B.x a_B.y`` (components, on paper), ``omega_AB
epsilon_AB`` (of a body, positive counter-clockwise), ``v_rel_C a_rel_C a_cor_C`` (magnitudes for a sliding point).
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.units import Unit, unit
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.mechanism.scene import Scene, fixed_points

_PATTERN = re.compile(r"(v_rel|a_rel|a_cor|v|a|omega|epsilon)_([A-Za-z][A-Za-z0-9]*)(?:\.([xy]))?")
_ORDER = {"v": 1, "omega": 1, "v_rel": 1, "a": 2, "epsilon": 2, "a_rel": 2, "a_cor": 2}


@dataclass(frozen=True)
class Quantity:
    """An asked quantity: ``kind`` (v, a, omega, epsilon, v_rel, a_rel, a_cor), point or body, component or ''."""

    kind: str
    target: str
    component: str = ""

    @property
    def name(self) -> str:
        """The name as written in files, ``v_B.x``."""
        return f"{self.kind}_{self.target}" + (f".{self.component}" if self.component else "")

    @property
    def order(self) -> int:
        """1 if velocities are enough to know it, 2 if accelerations are needed."""
        return _ORDER[self.kind]

    @property
    def of_body(self) -> bool:
        """Whether it belongs to a body (and not to a point)."""
        return self.kind in ("omega", "epsilon")

    @property
    def signed(self) -> bool:
        """Whether the value carries a sign."""
        return self.of_body or bool(self.component)

    def unit(self, length: str) -> Unit:
        """The unit it is printed in, for a family that gives lengths in the unit ``length``."""
        root = "rad" if self.of_body else length
        return unit(root + ("/s" if self.order == 1 else "/s^2"))

    def value(self, motion: Motion) -> Field:
        """Its value in SI, shape (N,)."""
        if self.of_body:
            return (motion.omega if self.kind == "omega" else motion.epsilon)[self.target]
        if self.kind in ("v", "a"):
            vector = (motion.v if self.kind == "v" else motion.a)[self.target]
        else:
            parts = relative_motion(motion, self.target, sliding_points(motion.scene)[self.target])
            found = {"v_rel": parts.velocity, "a_rel": parts.acceleration, "a_cor": parts.coriolis}[self.kind]
            if found is None:
                raise ValueError(f"{self.name} needs accelerations, which were not computed")
            vector = found
        match self.component:
            case "x":
                return np.real(vector)
            case "y":
                return np.imag(vector)
            case _:
                return np.abs(vector)


def parse_quantity(text: str, scene: Scene, key: str = "ask") -> Quantity:
    """The quantity of that name in a scene; InputError with the nearest names if the scene has none such."""
    known = quantity_names(scene)
    if text not in known:
        raise InputError(Problem("unknown quantity", key=key, value=text, remedy=nearest(text, known)))
    match = _PATTERN.fullmatch(text)
    assert match is not None
    return Quantity(match[1], match[2], match[3] or "")


def quantity_names(scene: Scene) -> list[str]:
    """Names of all quantities that a scene can be asked for."""
    moving = {p for members in scene.bodies.values() for p in members}
    moving |= {p for c in scene.constraints for shape in c.shapes() for p in shape.points}
    fixed = fixed_points(scene)
    points = [p for p in scene.points if p in moving and p not in fixed]
    sliding = list(sliding_points(scene))
    names = [f"{kind}_{p}{part}" for kind in ("v", "a") for p in points for part in ("", ".x", ".y")]
    names += [f"{kind}_{body}" for kind in ("omega", "epsilon") for body in scene.bodies]
    return names + [
        f"{kind}_{p}{part}" for kind in ("v_rel", "a_rel", "a_cor") for p in sliding for part in ("", ".x", ".y")
    ]
