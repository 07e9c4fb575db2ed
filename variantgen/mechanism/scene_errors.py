"""What an author can get wrong in a scene, as far as names tell: found once, before the scene is analysed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from variantgen.errors import InputError, Problem, nearest
from variantgen.mechanism.component import field_specs, parts
from variantgen.mechanism.scene import Scene, fixed_points, label, references


def check_scene(scene: Scene) -> None:
    """Raise InputError with every mistake in the names of a scene.

    Unknown points and bodies, bodies without points, points that are not of the body they should be of,
    things named twice, points at rest that move, and what a joint itself finds wrong.
    """
    problems = _problems(scene)
    if problems:
        raise InputError(problems)


def _problems(scene: Scene) -> list[Problem]:
    found: list[Problem] = []
    for body, members in scene.bodies.items():
        key = f"bodies.{body}"
        if members and len(set(members)) < len(members):
            twice = ", ".join(name for name in dict.fromkeys(members) if members.count(name) > 1)
            found.append(Problem("a body lists a point twice", key=key, value=twice, remedy="list it once"))
        if not members:
            found.append(Problem("a body needs at least one point", key=key, value="none"))
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
    """Points or bodies that a joint, driver or condition names twice; two links may share a point."""
    found = []
    for kind in ("point", "body"):
        names = references(component, kind)
        for name in dict.fromkeys(names):
            # a rope may come to a point again
            if names.count(name) > 1 and len(parts(component)) == 1 and not _shared(component, name):
                found.append(Problem(f"names a {kind} twice", key=key, value=name, remedy=f"name another {kind}"))
    return found


def _shared(component: Any, name: str) -> bool:
    """Whether each time that a component names a point it is one of two, once in each pair: where two links meet."""
    kind: type = type(component)
    values = [getattr(component, spec.name) for spec in field_specs(kind) if spec.ref]
    return all(value.count(name) <= 1 if isinstance(value, tuple) else value != name for value in values)


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
                    remedy = (
                        f"add it to the list of points of {body}, or take one of: {', '.join(members)}; a place of"
                        f' {body} under {name} is a point of its own, E = "{name}" in [points], added to that list'
                    )
                    found.append(
                        Problem(f"is no point of the body {body}", key=f"{key}.{points}", value=name, remedy=remedy)
                    )
    return found


def _unknown(kind: str, name: str, key: str, known: Mapping[str, Any]) -> Problem:
    return Problem(f"unknown {kind}", key=key, value=name, remedy=nearest(name, known))
