"""Where the angles of which a step speaks are in its figure: corners, given angles, those with letters of their own."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import permutations

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.families.hints import DIRECTIONS
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solved_motion import SolvedMotion
from variantgen.methods.step_feet import feet
from variantgen.methods.steps.point_vectors import Arrow, PointVectors
from variantgen.methods.steps.step import Fact, Segment, Sentence, Step, VectorOf
from variantgen.methods.steps.step_geometry import Corner

_ON_LINE = 1e-6  # sine of the angle within which a point is on a line
_SAME = 0.02  # degrees: the angle that is drawn is the one that is printed


class StepAngles:
    """The angles of the steps of a solution: where each letter is, said in one step and used in this and later ones."""

    def __init__(self, task: Task, steps: Sequence[Step], vectors: Sequence[PointVectors]) -> None:
        self._task = task
        self._vectors = vectors
        self._segments: dict[Name, tuple[str, str]] = {}
        self._vector_angles: dict[Name, tuple[str, complex, complex]] = {}
        self._feet: dict[str, complex] = {}
        for step in steps:
            self._feet |= {foot.letter: foot.place / task.length_unit for foot in feet(task, step)}
            for item in step.items:
                if isinstance(item, Sentence):
                    self._read(item.key, item.facts)

    def _read(self, key: str, facts: Mapping[str, Fact]) -> None:
        """The sides of an angle that a sentence introduces."""
        angle, segment, vector, line = (facts.get(word) for word in ("angle", "segment", "vector", "line"))
        if not isinstance(angle, Value) or angle.name is None:
            return
        if isinstance(segment, Segment):
            self._segments[angle.name] = (segment.start, segment.end)
        elif isinstance(vector, VectorOf) and (first := self._direction(vector)) and (way := self._direction(line)):
            across = key == "axes.angle_across"
            self._vector_angles[angle.name] = (vector.name.of, first, 1j * way if across else way)

    def _direction(self, line: Fact | None) -> complex:
        """The unit vector along a vector or a segment; 0 where there is none."""
        way = 0j
        if isinstance(line, Segment) and {line.start, line.end} <= set(self._task.now.z):
            way = self._task.now.z[line.end] - self._task.now.z[line.start]
        elif isinstance(line, VectorOf):
            ways = (arrow.vector or arrow.way for arrow in self._arrows() if arrow.name == line.name)
            way = next((found for found in ways if found), 0j)
        return way / abs(way) if way else 0j

    def _arrows(self) -> Iterator[Arrow]:
        for found in self._vectors:
            yield from found.own.values()
            for equation in found.equations:
                yield from (*equation.terms, *equation.left, *equation.right)

    def corner(self, value: Value, number: int) -> Corner | None:
        """Where an angle is that the step of a number names; None for what is no angle at a point."""
        name = value.name
        if name is None or value.measure != "angle":
            return None
        if name.kind == "parameter":
            found = _given(self._task, value, name) or _turned(self._task, value)
        elif name in self._segments:
            found = _with_line(self._task, value, *self._segments[name])
        elif name in self._vector_angles:
            found = self._with_vector(value, name, number)
        else:
            if name.kind != "angle":
                return None
            sides = SolvedMotion(self._task).arms(name) or self._to_foot(name)
            if len(sides) != 2:
                return None
            ends = tuple(end for end in name.about.split() if end not in self._feet)
            found = Corner(value, name.of, (sides[0], sides[1]), ends, name.body, name.part == "vertex")
        return found if found is not None and _is_true(found) else None

    def _to_foot(self, name: Name) -> tuple[complex, ...]:
        """The sides of a corner one of which leads to the foot of a perpendicular; nothing for another one."""
        z = {**self._feet, **self._task.now.z}
        ends = name.about.split()
        return tuple(z[end] - z[name.of] for end in ends) if {name.of, *ends} <= z.keys() else ()

    def _with_vector(self, value: Value, name: Name, number: int) -> Corner | None:
        """The acute angle of a vector with a line: at the point of the step's equation, where its vectors stand."""
        point, first, second = self._vector_angles[name]
        for equation in (equation for found in self._vectors for equation in found.equations):
            if equation.step == number:
                point = equation.point
                break
        for way in (second, -second):
            if _is_true(corner := Corner(value, point, (first, way), either=True)):
                return corner
        return None


def _turned(task: Task, value: Value) -> Corner | None:
    """The angle by which a law of time has turned a body: from the horizontal or the vertical to one of its lines."""
    z = task.now.z
    for members in task.scene.bodies.values():
        for vertex, end in permutations(members[::-1], 2):
            for way in (1 + 0j, 1j, -1 + 0j, -1j):
                if z[end] != z[vertex] and _is_true(corner := Corner(value, vertex, (way, z[end] - z[vertex]), (end,))):
                    return corner
    return None


def _given(task: Task, value: Value, name: Name) -> Corner | None:
    """A given angle, as the figure of the statement marks it."""
    form, z = task.form, task.now.z
    for mark in form.figure.angles:
        if form.parameters[mark.name].symbol == name.of:
            ends = [
                complex(task.scene.frame.place(DIRECTIONS[way])) if way in DIRECTIONS else z[way] - z[mark.at]
                for way in (mark.start, mark.end)
            ]
            if 0j in ends:
                continue
            return Corner(value, mark.at, (ends[0], ends[1]), carried=tuple(_on_sides(task, mark.at, ends)))
    return None


def _on_sides(task: Task, vertex: str, sides: Sequence[complex]) -> list[str]:
    """The points on the lines of the sides of an angle, the nearest first: there it is between parallel lines."""
    z = task.now.z
    ways = {name: place - z[vertex] for name, place in z.items() if place != z[vertex]}
    found = [n for n, way in ways.items() if any(abs((way / side).imag) < _ON_LINE * abs(way / side) for side in sides)]
    return sorted(found, key=lambda name: abs(ways[name]))


def _with_line(task: Task, value: Value, start: str, end: str) -> Corner | None:
    """The acute angle at the end of a segment with a line without a second point: the one on which it is found."""
    now = task.now
    arm = now.z[start] - now.z[end]
    for way in _lines(task, end):
        if abs(way) > 0 and abs(arm) > 0:
            ahead = way if (way * arm.conjugate()).real >= 0 else -way
            corner = Corner(value, end, (arm, ahead / abs(ahead) * abs(arm)))
            if _is_true(corner):
                return corner
    return None


def _lines(task: Task, point: str) -> Iterable[complex]:
    """Directions of lines through a point: its path, those on which it slides, the axes of the paper."""
    yield task.now.v.get(point, 0j)
    for path in task.linkage.slides:
        members = task.scene.bodies[path.body]
        if path.point == point and len(members) > 1:
            yield task.now.z[members[1]] - task.now.z[members[0]]
    yield from (1 + 0j, 1j)


def _is_true(corner: Corner) -> bool:
    """Whether the sides of an angle make the angle."""
    first, second = corner.sides
    if abs(first) == 0 or abs(second) == 0:
        return False
    return abs(abs(math.degrees(cmath.phase(second / first))) - abs(corner.value.exact)) < _SAME
