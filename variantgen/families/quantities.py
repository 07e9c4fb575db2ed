"""The quantities that may be asked: their names, dimensions and values.

========================  ==============================================================================
name                      meaning
========================  ==============================================================================
``v_B  a_B``              magnitude of the velocity, acceleration of a point
``v_B.x  a_B.y``          component on paper (x to the right, y up)
``v_B.angle``             direction: angle from the x axis, -180 to 180 degrees, positive counter-clockwise
``omega_AB  epsilon_AB``  angular velocity, angular acceleration of a body, positive counter-clockwise
``omega_AB.abs``          its magnitude
``omega_AB.sense``        its sense: +1 counter-clockwise, -1 clockwise
``v_rel_C a_rel_C``       magnitude of the relative velocity, relative acceleration of a sliding point
``a_cor_C``               magnitude of its Coriolis acceleration (components and angle as above)
``P_AB.A``                distance of a point from the velocity centre P of a body
``Q_AB.A``                distance of a point from the acceleration centre Q of a body
``mu_AB``                 angle between accelerations and rays from Q: ``tan mu = |epsilon| / omega^2``
========================  ==============================================================================
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.units import UNITS, Unit, unit, usual_name
from variantgen.mechanism.centres import acceleration_centre, velocity_centre
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.mechanism.scene import Scene, fixed_points

_PATTERN = re.compile(
    r"(v_rel|a_rel|a_cor|v|a|omega|epsilon|mu|P|Q)_([A-Za-z][A-Za-z0-9]*)(?:\.([A-Za-z][A-Za-z0-9]*))?"
)
_ORDER = {"v": 1, "omega": 1, "v_rel": 1, "P": 1, "a": 2, "epsilon": 2, "a_rel": 2, "a_cor": 2, "Q": 2, "mu": 2}
_RECORDED = 8  # significant digits
# An angle of fewer degrees is noise about zero: the tolerance of an angle is some tenths of a degree.
_NO_ANGLE = 1e-9
_OF_POINT = ("", ".x", ".y", ".angle")
_OF_BODY = ("", ".abs", ".sense")


@dataclass(frozen=True)
class Quantity:
    """An asked quantity: ``kind`` (v, a, omega, ...), point or body, and what of it (see the table of the module)."""

    kind: str
    target: str
    component: str = ""
    wanted: str = ""  # the unit of its answer, if it is not that of the family

    @property
    def name(self) -> str:
        """The name as written in files, ``v_B.x``."""
        return f"{self.kind}_{self.target}" + (f".{self.component}" if self.component else "")

    @property
    def written(self) -> str:
        """The name with the unit that is wanted, ``v_B in ft/s``."""
        return f"{self.name} in {self.wanted}" if self.wanted else self.name

    @property
    def whole_name(self) -> str:
        """The name without what is asked of it, ``v_B``."""
        return f"{self.kind}_{self.target}"

    @property
    def order(self) -> int:
        """1 if velocities are enough to know it, 2 if accelerations are needed."""
        return _ORDER[self.kind]

    @property
    def is_vector(self) -> bool:
        """Whether it belongs to a vector of a point: its magnitude, a component, its angle."""
        return self.kind in ("v", "a", "v_rel", "a_rel", "a_cor")

    @property
    def is_rotation(self) -> bool:
        """Whether it belongs to the rotation of a body."""
        return self.kind in ("omega", "epsilon")

    @property
    def is_centre(self) -> bool:
        """Whether it is a distance from the velocity or acceleration centre."""
        return self.kind in ("P", "Q")

    @property
    def is_angle(self) -> bool:
        """Whether it is an angle: a direction, or that of the acceleration centre."""
        return self.component == "angle" or self.kind == "mu"

    @property
    def point(self) -> str:
        """The point it speaks of, or ''."""
        if self.is_centre:
            return self.component
        return self.target if self.is_vector else ""

    @property
    def whole(self) -> Quantity:
        """The magnitude or signed rate whose direction or sense this is; else the quantity itself."""
        return replace(self, component="") if self.component in ("angle", "sense") else self

    def unit(self, length: str) -> Unit:
        """The unit of its answer: the one that is wanted, or its own."""
        return unit(self.wanted) if self.wanted else self.own_unit(length)

    def own_unit(self, length: str) -> Unit:
        """The unit in which solutions work it out, for a family that gives lengths in the unit ``length``."""
        if self.is_angle:
            return unit("deg")
        if self.component == "sense":
            return unit("1")
        if self.is_centre:
            return unit(length)
        root = "rad" if self.is_rotation else length
        return unit(root + ("/s" if self.order == 1 else "/s^2"))

    def value(self, motion: Motion) -> Field:
        """Its value in SI, shape (N,); infinite for the distance from a centre at infinity."""
        if self.is_rotation:
            rate = (motion.omega if self.kind == "omega" else motion.epsilon)[self.target]
            if self.component == "sense":
                return np.sign(rate)
            return np.abs(rate) if self.component == "abs" else rate
        if self.is_centre:
            centre = (velocity_centre if self.kind == "P" else acceleration_centre)(motion, self.target)
            distance: Field = np.where(centre.finite, np.abs(motion.z[self.component] - centre.z), np.inf)
            return distance
        if self.kind == "mu":
            slope: Field = np.arctan2(np.abs(motion.epsilon[self.target]), motion.omega[self.target] ** 2)
            return slope
        vector = self._vector(motion)
        match self.component:
            case "x":
                return np.real(vector)
            case "y":
                return np.imag(vector)
            case "angle":
                return np.asarray(np.angle(vector))
            case _:
                return np.abs(vector)

    def _vector(self, motion: Motion) -> ComplexField:
        if self.kind in ("v", "a"):
            return (motion.v if self.kind == "v" else motion.a)[self.target]
        parts = relative_motion(motion, self.target, sliding_points(motion.scene)[self.target])
        found = {"v_rel": parts.velocity, "a_rel": parts.acceleration, "a_cor": parts.coriolis}[self.kind]
        if found is None:
            raise ValueError(f"{self.name} needs accelerations, which were not computed")
        return found


def parse_quantity(text: str, scene: Scene, key: str = "ask", offered: Sequence[str] = ()) -> Quantity:
    """The quantity of that name in a scene; InputError with the nearest (``offered``) names if it has none such."""
    known = quantity_names(scene)
    if text not in known:
        remedy = _proposed(text, known) or nearest(text, offered or known)
        raise InputError(Problem("unknown quantity", key=key, value=text, remedy=remedy))
    return split_name(text)


# How others write a quantity, and how it is written here.
_OTHERWISE = {"alpha": "epsilon", "eps": "epsilon", "w": "omega", "om": "omega", "vel": "v", "acc": "a"}
_POSITIONS = ("theta", "phi", "beta", "gamma", "psi", "x", "y", "z", "s", "l", "r", "angle")


def _proposed(text: str, known: Sequence[str]) -> str:
    """What to ask for in place of a quantity in other letters, or of a position; "" where nothing is known of it."""
    letter, _, target = text.partition("_")
    own = f"{_OTHERWISE.get(letter, letter)}_{target}"
    if letter in _OTHERWISE and own in known:
        return f"write {own}: angular velocities are omega, angular accelerations epsilon"
    if letter not in _POSITIONS or not target:
        return ""
    rates = [name for kind in ("omega", "v", "epsilon", "a") if (name := f"{kind}_{target}") in known]
    found = f" of {target}: " + ", ".join(rates) if rates else ""
    return f"positions (angles, lengths, coordinates) are given by the data and not asked; ask for a rate{found}"


def recorded(quantity: Quantity, value: float) -> float:
    """A value in its printed unit as keys and manifests have it.

    It has so many digits that the last bits of a machine change no byte; what is left of an angle of zero is zero.
    """
    if quantity.is_angle and abs(value) < _NO_ANGLE:
        return 0.0
    return float(f"{value:.{_RECORDED - 1}e}")


def split_name(text: str) -> Quantity:
    """The quantity of a name that is known to be one, with the unit that it may want; ValueError if it is none."""
    name, wanted = split_unit(text)
    match = _PATTERN.fullmatch(name)
    if match is None:
        raise ValueError(f"{text} is no name of a quantity")
    return Quantity(match[1], match[2], match[3] or "", wanted)


def split_unit(text: str) -> tuple[str, str]:
    """A name and the unit in which its answer is wanted: ``v_B in ft/s`` is ``v_B`` and ``ft/s``; "" without one."""
    name, _, wanted = text.partition(" in ")
    return name.strip(), usual_name(wanted)


def in_unit(quantity: Quantity, wanted: str, key: str) -> Quantity:
    """The quantity with the unit in which its answer is wanted. Raises InputError for a unit of another measure."""
    own = quantity.own_unit("m")
    fitting = (
        [own.name] if quantity.is_angle else [other.name for other in UNITS.values() if other.measures == own.measures]
    )
    if wanted not in fitting:
        message = f"{wanted} measures no {own.measures}" if wanted in UNITS else "unknown unit"
        raise InputError(
            Problem(message, key=key, value=f"{quantity.name} in {wanted}", remedy="use one of: " + ", ".join(fitting))
        )
    return replace(quantity, wanted=wanted)


def quantity_names(scene: Scene) -> list[str]:
    """Names of all quantities that a scene can be asked for."""
    moving = {p for members in scene.bodies.values() for p in members}
    moving |= {p for c in scene.constraints for shape in c.shapes() for p in shape.points}
    fixed = fixed_points(scene)
    points = [p for p in scene.points if p in moving and p not in fixed]
    sliding = list(sliding_points(scene))
    names = [f"{kind}_{p}{part}" for kind in ("v", "a") for p in points for part in _OF_POINT]
    names += [f"{kind}_{body}{part}" for kind in ("omega", "epsilon") for body in scene.bodies for part in _OF_BODY]
    names += [f"{kind}_{p}{part}" for kind in ("v_rel", "a_rel", "a_cor") for p in sliding for part in _OF_POINT]
    names += [f"{kind}_{body}.{p}" for kind in ("P", "Q") for body, members in scene.bodies.items() for p in members]
    return names + [f"mu_{body}" for body in scene.bodies]
