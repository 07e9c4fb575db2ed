"""Which figures the steps of a solution have, and which angles and segments each of them marks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec.structs import replace

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import made_of
from variantgen.methods.linkage.problem import Task
from variantgen.methods.step_angles import StepAngles
from variantgen.methods.step_feet import feet
from variantgen.methods.steps.point_vectors import PointEquation, PointVectors
from variantgen.methods.steps.printed_digits import items_values
from variantgen.methods.steps.step import Body, Derived, Point, Step
from variantgen.methods.steps.step_geometry import NOTHING_MARKED, ChainGraph, MarkedFoot, StepGeometry

_OF_EQUATIONS = {
    1: ("velocities", "body_velocities", "contact_velocities"),
    2: ("accelerations", "body_accelerations"),
}
_EQUATION = {1: "velocity_equation", 2: "acceleration_equation"}
_OF_BODIES = ("velocity_centre", "velocity_projections", "acceleration_centre")
_SPEEDS = ("velocity", "angular velocity")
_NOTHING = 1e-9  # of the largest rate: a body in translation has no velocity centre


def step_figures(
    task: Task, steps: Sequence[Step], vectors: Sequence[PointVectors]
) -> tuple[list[Step], dict[str, StepGeometry]]:
    """The steps with the names of their figures (``velocity_centre:AB``), and what each figure marks, by that name.

    What is named in steps without a figure is marked in the next one that has its points.
    """
    shown = {
        (view, fact.name)
        for step in steps
        for view in step.views
        for fact in step.heading.facts.values()
        if view in _OF_BODIES and isinstance(fact, Body)
    }
    names = [list(dict.fromkeys(_names(task, step, number, vectors, shown))) for number, step in enumerate(steps)]
    angles = StepAngles(task, steps, vectors)
    marked: dict[str, StepGeometry] = {}
    views: list[tuple[str, ...]] = []
    for number, step in enumerate(steps):
        here, own = _geometry(task, step, number, angles), names[number]
        goal = own or _seen_in(task, here, [later for later in names[number:] if later], vectors)
        if here.feet and not any(_shows(task, name, foot) for name in goal for foot in here.feet):
            # The perpendicular is dropped in another part of the mechanism.
            own = goal = [f"position:{number}", *own]
        # What is worked out without a figure is seen in the next one, velocities not in one of accelerations.
        is_seen = here.is_found and goal and ":" in goal[0] and not (_finds_speeds(step) and _is_of(2, goal[0]))
        views.append(tuple(own or (goal[:1] if is_seen else ())))
        for name in goal:
            marked[name] = marked.get(name, NOTHING_MARKED) + here
    return [replace(step, views=own) for step, own in zip(steps, views, strict=True)], marked


def _finds_speeds(step: Step) -> bool:
    """Whether a velocity or an angular velocity is worked out in a step."""
    return any(isinstance(item, Derived) and item.value.measure in _SPEEDS for item in step.items)


def _is_of(order: int, view: str) -> bool:
    """Whether the figure of this name shows velocities (1) or accelerations (2)."""
    kind = view.partition(":")[0]
    return kind in (*_OF_EQUATIONS[order], _EQUATION[order])


def _shows(task: Task, view: str, foot: MarkedFoot) -> bool:
    """Whether the figure of a velocity centre, which has the cranks of its body, has the points of a perpendicular."""
    kind, _, body = view.partition(":")
    if kind == "coordinate_axes":
        return True
    return kind == "velocity_centre" and {foot.apex, *foot.line} <= _points_with_cranks(task, body)


def _points_with_cranks(task: Task, body: str) -> set[str]:
    """The points of a body and of the links by which it hangs on pivots."""
    bodies = task.scene.bodies
    cranks = [m for m in bodies.values() if set(m) & set(bodies[body]) - task.fixed and task.fixed & set(m)]
    return {*bodies[body], *(point for members in cranks for point in members)}


def _seen_in(task: Task, here: StepGeometry, later: Sequence[list[str]], vectors: Sequence[PointVectors]) -> list[str]:
    """The figures of the first later step of which one has what a step finds, else those of the first."""
    found = [corner for corner in here.corners if corner.value.name is None or corner.value.name.kind != "parameter"]
    ends = {end for segment in here.segments for end in segment} | {corner.vertex for corner in found}
    for names in later:
        for name in names:
            points = _points_of(task, name, vectors)
            sides = all(not corner.ends or points & set(corner.ends) for corner in found)
            if sides and ends & set(task.now.z) <= points:
                return [name, *(other for other in names if other != name)]
    return later[0] if later else []


def _points_of(task: Task, view: str, vectors: Sequence[PointVectors]) -> set[str]:
    """The points that a figure may show: of its body, or of those of the vectors of its equation; else all."""
    kind, _, which = view.partition(":")
    bodies = task.scene.bodies
    if which in bodies:
        return _points_with_cranks(task, which)
    order = next((order for order, equation in _EQUATION.items() if kind == equation), 0)
    if not order:
        return set(task.now.z)
    ends = {
        end for term in vectors[order - 1].equations[int(which) - 1].terms for end in (term.name.of, term.name.about)
    }
    return {point for members in bodies.values() if ends & set(members) for point in members}


def _names(
    task: Task, step: Step, number: int, vectors: Sequence[PointVectors], shown: set[tuple[str, str]]
) -> Iterator[str]:
    """The figures of a step: one of each vector equation; of its body, or of the mechanism, where it has none."""
    for view in step.views:
        order = next((order for order, views in _OF_EQUATIONS.items() if view in views), 0)
        equations = vectors[order - 1].equations if 0 < order <= len(vectors) else ()
        own = dict.fromkeys(_first(equations, equation) for equation in equations if equation.step == number)
        bodies = _bodies(task, step)
        if view == "coordinate_axes":
            yield f"{view}:xy"
        elif view == "rate_chain":
            start, end = step.heading.facts["start"], step.heading.facts["end"]
            assert isinstance(start, Point)
            assert isinstance(end, Point)
            yield f"{view}:{start.name}-{end.name}"
        elif own:
            yield from (f"{_EQUATION[order]}:{i}" for i in own)
        elif view in _OF_BODIES:
            still = view == "velocity_centre" and abs(task.now.omega[bodies[0]]) < _NOTHING * _fastest(task)
            yield f"{'body_velocities' if still else view}:{bodies[0]}"
        elif not view.startswith(("body_", "contact_")):
            yield view
        elif drawn := next((name for body in bodies if (name := _of_body(body, order, shown))), ""):
            yield drawn
        elif bodies and not (bodies[0] in task.translating and any(e.step >= 0 for e in equations)):
            # Equal vectors of a body in translation need no figure where the equations have theirs.
            yield f"{view}:{bodies[0]}"


def _fastest(task: Task) -> float:
    """The largest angular velocity."""
    return max(abs(rate) for rate in task.now.omega.values())


def _bodies(task: Task, step: Step) -> list[str]:
    """The body that the heading of a step names, or those of its point."""
    facts = step.heading.facts
    body, point = facts.get("body"), facts.get("point")
    if isinstance(body, Body):
        return [body.name]
    return task.linkage.owners(point.name) if isinstance(point, Point) else []


def _of_body(body: str, order: int, shown: set[tuple[str, str]]) -> str:
    """The figure of a body that another step has, for velocities or accelerations."""
    kinds = _OF_BODIES[:2] if order == 1 else _OF_BODIES[2:]
    return next((f"{kind}:{body}" for kind in kinds if (kind, body) in shown), "")


def _first(equations: Sequence[PointEquation], equation: PointEquation) -> int:
    """The number, from 1 on, of the first equation in a step about the same point with the same vectors."""
    seen = [
        other.step >= 0
        and other.point == equation.point
        and {arrow.name for arrow in other.terms} == {arrow.name for arrow in equation.terms}
        for other in equations
    ]
    return seen.index(True) + 1


def _geometry(task: Task, step: Step, number: int, angles: StepAngles) -> StepGeometry:
    """The angles and segments that the lines of a step name."""
    values = list(_named(step))
    shown = _shown_names(step)
    found = [(value.name, angles.corner(value, number)) for value in values]
    corners = [replace(corner, is_part=name not in shown) for name, corner in found if corner is not None]
    names = [value.name for value in values if value.name is not None and value.name.kind == "length"]
    segments = [(name.of, name.about) for name in names if not name.part]
    chain = next((item for item in step.items if isinstance(item, ChainGraph)), None)
    return StepGeometry(tuple(corners), tuple(dict.fromkeys(segments)), chain, tuple(feet(task, step)))


def _named(step: Step) -> Iterator[Value]:
    """The values with names in the lines of a step and those of which they are made, each once."""
    seen: set[Name] = set()
    for value in (*items_values(step.items), *_derived(step)):
        for each in (value, *made_of(value)):
            if each.name is not None and each.name not in seen:
                seen.add(each.name)
                yield each


def _shown_names(step: Step) -> set[Name | None]:
    """The names that the lines of a step are about; of what a value is made where it has no name or is no angle.

    The parts of an angle are where it is worked out, not at its vectors.
    """
    values, derived = items_values(step.items), _derived(step)
    whole = [value for value in derived if value.measure != "angle"]
    parts = [part for value in (*values, *derived) if value.name is None or value in whole for part in made_of(value)]
    return {value.name for value in (*values, *derived, *parts)}


def _derived(step: Step) -> list[Value]:
    """The values that a step derives, each from others in its line."""
    return [item.value for item in step.items if isinstance(item, Derived)]
