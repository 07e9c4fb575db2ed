"""A scene: the mechanism of a problem as points, bodies, joints and drivers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Protocol

from variantgen.errors import InputError, Problem, nearest
from variantgen.mechanism.arithmetic import Complex, Flags
from variantgen.mechanism.assembly import Condition
from variantgen.mechanism.component import field_specs, parts
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.rows import Constraint, Frame, Pair


class Construction(Protocol):
    """A way to place a point (see :mod:`variantgen.mechanism.constructions`)."""

    @property
    def failure(self) -> Outcome:
        """The outcome of a variant for which the point does not exist."""
        ...

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether it exists."""
        ...


@dataclass(frozen=True)
class Scene:
    """Points by construction, rigid bodies as tuples of their points, joints, drivers, and the frame on paper.

    Numbers inside may be scalars or arrays over the batch (one entry per variant). A point that belongs to several
    bodies is a hinge of them. ``conditions`` place the points that are only said to be ``near`` somewhere.
    """

    points: Mapping[str, Construction]
    bodies: Mapping[str, tuple[str, ...]]
    joints: tuple[Pair, ...] = ()
    drivers: tuple[Constraint, ...] = ()
    frame: Frame = Frame()
    conditions: tuple[Condition, ...] = ()

    def __post_init__(self) -> None:
        problems = list(_reference_problems(self))
        if problems:
            raise InputError(problems)

    @property
    def constraints(self) -> tuple[Constraint, ...]:
        """Joints, then drivers."""
        return (*self.joints, *self.drivers)


def references(component: Any, kind: str) -> tuple[str, ...]:
    """Names of the given kind (``point`` or ``body``) that a component refers to, those of its parts included."""
    names: list[str] = []
    for part in parts(component):
        part_type: type = type(part)
        for spec in field_specs(part_type):
            value = getattr(part, spec.name)
            if spec.ref == kind and value is not None:
                names.extend(value if spec.many else (value,))
    return tuple(names)


def fixed_points(scene: Scene) -> set[str]:
    """Points that a joint holds in place by itself."""
    shapes = [shape for joint in scene.joints for shape in joint.shapes()]
    return {shape.lead for shape in shapes if shape.lead and not shape.bodies and len(shape.points) == 1}


def label(component: Any) -> str:
    """How messages call a joint or driver: its kind and what it acts on, ``guide of B``."""
    named = [getattr(part, f.name) for part in parts(component) for f in fields(part)]
    first = next((name for name in named if isinstance(name, str)), "nothing")
    kind = type(component).__name__
    words = "".join(" " + letter.lower() if letter.isupper() else letter for letter in kind).strip()
    return f"{words} of {first}"


def _reference_problems(scene: Scene) -> list[Problem]:
    found: list[Problem] = []
    for body, members in scene.bodies.items():
        key = f"bodies.{body}"
        if len(set(members)) < len(members) and len(set(members)) >= 2:
            twice = ", ".join(name for name in dict.fromkeys(members) if members.count(name) > 1)
            found.append(Problem("a body lists a point twice", key=key, value=twice, remedy="list it once"))
        if len(set(members)) < 2:
            found.append(
                Problem("a body needs at least two different points", key=key, value=", ".join(members) or "none")
            )
        found += [_unknown("point", name, key, scene.points) for name in members if name not in scene.points]
    owners: list[tuple[str, Any]] = [(f"points.{name}", item) for name, item in scene.points.items()]
    owners += [(f"joints.{label(item)}", item) for item in scene.joints]
    owners += [(f"drivers.{label(item)}", item) for item in scene.drivers]
    owners += [(f"conditions.{label(item)}", item) for item in scene.conditions]
    for key, item in owners:
        for kind, known in (("point", scene.points), ("body", scene.bodies)):
            found += [_unknown(kind, name, key, known) for name in references(item, kind) if name not in known]
        found += _foreign(item, key, scene)
    for key, item in owners[len(scene.points) :]:
        found += _repeated(item, key)
    found += _moving_rests(scene)
    for joint in scene.joints:
        if wrong := joint.mistake():
            found.append(Problem(wrong, key=f"joints.{label(joint)}"))
    return found


def _repeated(component: Any, key: str) -> list[Problem]:
    """Points or bodies that a joint, driver or condition names twice."""
    found = []
    for kind in ("point", "body"):
        names = references(component, kind)
        wheels = {name for part in parts(component) if (name := getattr(part, "body", None)) and part is not component}
        for name in dict.fromkeys(names):
            if names.count(name) > 1 and name not in wheels:
                found.append(Problem(f"names a {kind} twice", key=key, value=name, remedy=f"name another {kind}"))
    return found


def _moving_rests(scene: Scene) -> list[Problem]:
    """Points that a joint takes to be at rest and that belong to something that moves."""
    if any(name not in scene.points for joint in scene.joints for name in references(joint, "point")):
        return []
    fixed = fixed_points(scene)
    moving = {name for members in scene.bodies.values() for name in members}
    moving |= {name for c in scene.constraints for shape in c.shapes() for name in shape.points}
    return [
        Problem(
            "is taken to be at rest here, but it moves",
            key=f"joints.{label(joint)}",
            value=name,
            remedy="name the body that it belongs to, or hold it with a pivot",
        )
        for joint in scene.joints
        for name in joint.resting()
        if name in moving - fixed
    ]


def _foreign(component: Any, key: str, scene: Scene) -> list[Problem]:
    """Points that must be points of a body (``belongs`` of the component says of which) and are not."""
    found = []
    for part in parts(component):
        for points, owner in getattr(part, "belongs", {}).items():
            body, named = getattr(part, owner), getattr(part, points)
            if body not in scene.bodies or named is None:
                continue
            members = scene.bodies[body]
            for name in (named,) if isinstance(named, str) else named:
                if name in scene.points and name not in members:
                    remedy = f"add it to the list of points of {body}, or take one of: {', '.join(members)}"
                    found.append(
                        Problem(f"is no point of the body {body}", key=f"{key}.{points}", value=name, remedy=remedy)
                    )
    return found


def _unknown(kind: str, name: str, key: str, known: Mapping[str, Any]) -> Problem:
    return Problem(f"unknown {kind}", key=key, value=name, remedy=nearest(name, known))
