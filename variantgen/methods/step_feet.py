"""Where the feet of perpendiculars are that a step names."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from variantgen.methods.linkage.problem import Task
from variantgen.methods.steps.step import Fact, Segment, Sentence, Step
from variantgen.methods.steps.step_geometry import MarkedFoot


def feet(task: Task, step: Step) -> Iterator[MarkedFoot]:
    """The feet of perpendiculars that the sentences of a step name."""
    z = task.now.z
    for item in step.items:
        facts: Mapping[str, Fact] = item.facts if isinstance(item, Sentence) else {}
        if isinstance(item, Sentence) and item.key.startswith("position.perpendicular"):
            down, to = facts["line"], facts["to"]
            assert isinstance(down, Segment)
            assert isinstance(to, Segment)
            start, way = z[to.start], z[to.end] - z[to.start]
            yield _foot(task, down.end, down.start, start, way, (to.start, to.end))
        elif isinstance(item, Sentence) and item.key == "position.projections":
            leg, along, corners = facts["leg"], facts["line"], facts["triangle"]
            assert isinstance(leg, Segment)
            assert isinstance(along, Segment)
            assert isinstance(corners, Segment)
            apex = corners.start.removeprefix(leg.start)
            yield _foot(task, leg.end, apex, z[leg.start], z[along.end] - z[along.start], (leg.start,))


def _foot(task: Task, letter: str, apex: str, start: complex, way: complex, line: tuple[str, ...]) -> MarkedFoot:
    """The foot of the perpendicular from a point to the line through a place."""
    way /= abs(way)
    place = start + ((task.now.z[apex] - start) * way.conjugate()).real * way
    return MarkedFoot(letter, place * task.length_unit, apex, line)
