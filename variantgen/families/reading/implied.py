"""What a file leaves unsaid: stations of ropes at rest, the ways of the blocks of a hoist, blocks that do not turn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

from variantgen.families.family import ComponentTemplate
from variantgen.families.parameters.expressions import FamilyExpression, number
from variantgen.families.quantities.kinds import ROPE
from variantgen.mechanism.component import field_specs
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.rope import Rope
from variantgen.mechanism.joints.translation import Translation

_BELT = ("point", "body", "radius", "side")  # what the ends of a belt that comes back have in common


def with_blocks(
    joints: Sequence[ComponentTemplate], drivers: Sequence[ComponentTemplate], bodies: Mapping[str, Sequence[str]]
) -> tuple[ComponentTemplate, ...]:
    """The joints, and a translation of each body of one point (a block, a load, a rack) that nothing turns."""
    turning = {
        part.fields.get(name)
        for item in (*joints, *drivers)
        for part in (item, *item.fields.get("path", ()))
        for name in ("body", "other", "sleeve")
    }
    blocks = [body for body, members in bodies.items() if len(members) == 1 and body not in turning]
    return (*joints, *(ComponentTemplate(Translation, {"body": body}) for body in blocks))


def with_stations(
    joints: Sequence[ComponentTemplate], drivers: Sequence[ComponentTemplate], bodies: Mapping[str, Sequence[str]]
) -> tuple[ComponentTemplate, ...]:
    """The joints with their ropes completed.

    A station that is named by ropes alone is at rest, unless the file says ``fixed = false``. In a ``parallel`` rope
    the pieces at a moving station run along the guide of this point, or of another point of a body in translation. A
    rope that turns a body on its way is one rope to this body and another one from it on: it does not slip there.
    """
    moving = {point for members in bodies.values() for point in members}
    moving |= {name for item in (*joints, *drivers) if item.component is not Rope for name in _points(item)}
    held = {item.fields["point"] for item in joints if item.component is Pivot}
    frames = [held | (_stations(joints) - moving), *map(set, bodies.values())]
    joints = [part for item in joints for part in _between_drums(item, frames)]
    ways = {item.fields["point"]: item.fields.get("angle") for item in joints if item.component is Guide}
    for item in joints:
        members = bodies.get(item.fields["body"], ()) if item.component is Translation else ()
        own = next((ways[point] for point in members if point in ways), None)
        ways |= {point: own for point in members if point not in ways and own is not None}
    return tuple(_completed(item, moving, ways) if item.component is Rope else item for item in joints)


def belt_words(joints: Sequence[ComponentTemplate]) -> dict[str, str]:
    """What stands in the symbol of the speed of a piece of a belt in place of the word for a rope, by its name."""
    belts = [item.fields["path"] for item in joints if item.component is Rope and item.fields.get("belt")]
    ends = [(a.fields["point"], b.fields["point"]) for path in belts for a, b in pairwise(path)]
    return {".".join((ROPE, *piece)): "belt" for start, end in ends for piece in ((start, end), (end, start))}


def _stations(joints: Sequence[ComponentTemplate]) -> set[str]:
    """The points that ropes pass."""
    return {bend.fields["point"] for item in joints if item.component is Rope for bend in item.fields["path"]}


def _between_drums(item: ComponentTemplate, frames: Sequence[set[str]]) -> list[ComponentTemplate]:
    """A rope in parts from body to body that it turns; any other joint as it is.

    A belt that comes back, with all its axles on one of the ``frames``, keeps its length if its other parts do: the
    last one is drawn only.
    """
    path: tuple[ComponentTemplate, ...] = item.fields.get("path", ()) if item.component is Rope else ()
    drums = [k for k in range(1, len(path) - 1) if path[k].fields.get("body")]
    if not drums:
        return [item]
    cuts = [0, *drums, len(path) - 1]
    parts = [{**item.fields, "path": path[first : last + 1]} for first, last in pairwise(cuts)]
    axles = _stations([item])
    if _same_drum(path[0], path[-1]):
        parts = [{**part, "belt": True} for part in parts]
        parts[-1]["closing"] = any(axles <= frame for frame in frames)
    return [ComponentTemplate(Rope, fields) for fields in parts]


def _same_drum(first: ComponentTemplate, last: ComponentTemplate) -> bool:
    """Whether two stations are one body that the rope turns the same way; else the last strand may contradict."""
    return bool(first.fields.get("body")) and all(_stated(first, k) == _stated(last, k) for k in _BELT)


def _stated(station: ComponentTemplate, field: str) -> object:
    """What a file says in a field: an expression is the same if its text is."""
    value = station.fields.get(field)
    return value.text if isinstance(value, FamilyExpression) else value


def _points(item: ComponentTemplate) -> list[str]:
    """The points that a joint or driver names."""
    named = [item.fields.get(spec.name) for spec in field_specs(item.component) if spec.ref == "point"]
    return [name for value in named if value for name in ((value,) if isinstance(value, str) else value)]


def _completed(
    rope: ComponentTemplate, moving: set[str], ways: Mapping[str, FamilyExpression | None]
) -> ComponentTemplate:
    parallel, bends = rope.fields.get("parallel", False), []
    for bend in rope.fields["path"]:
        found = dict(bend.fields)
        point = str(found["point"])
        found.setdefault("fixed", point not in moving and "body" not in found)
        if parallel and point in ways and "along" not in found and "body" not in found and not found["fixed"]:
            found["along"] = ways[point] or number(0.0, "angle")
        bends.append(ComponentTemplate(bend.component, found))
    return ComponentTemplate(rope.component, {**rope.fields, "path": tuple(bends)})
