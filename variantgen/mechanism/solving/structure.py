"""The structure of a scene: in which order points are placed, and which equations determine which unknowns.

Hinge velocities are eliminated first. Starting from pivots, driven points and contacts, the velocity of each point
is written through the angular velocities on the way to it (its pole, the pole of the pole, ...). What remains are
the closing equations in the angular velocities of the bodies (and in the slides of points that no body reaches).
Their block-triangular form (maximum matching, then strongly connected components) is the order of the textbook
solution: each block is a group of links that must be treated together, mostly of size 1 or 2.

Everything here depends on names only, so one :class:`Plan` serves every batch of a family.
"""

from __future__ import annotations

from msgspec import Struct

from variantgen.errors import InputError
from variantgen.mechanism.rows import Shape
from variantgen.mechanism.scene import Scene, label
from variantgen.mechanism.scene_errors import check_scene
from variantgen.mechanism.solving.blocks import indeterminate, triangular_blocks
from variantgen.mechanism.solving.placing_order import placing_order


class GivenPoint(Struct, frozen=True):
    """The velocity of ``point`` is given by a vector row: constraint and row numbers, and the pole if there is one."""

    point: str
    constraint: int
    row: int
    pole: str | None = None


class GuidedPoint(Struct, frozen=True):
    """``point`` moves along the line that a scalar row leaves to it; ``unknown`` is its speed there."""

    point: str
    constraint: int
    row: int
    unknown: int
    pole: None = None


class FreePoint(Struct, frozen=True):
    """``point`` is reached by nothing; both components of its velocity are unknowns."""

    point: str
    x: int
    y: int
    pole: None = None


class RigidPoint(Struct, frozen=True):
    """``point`` is a point of ``body``, with ``pole`` as the pole: ``v = v_pole + i omega (z - z_pole)``."""

    point: str
    body: str
    pole: str


Step = GivenPoint | GuidedPoint | FreePoint | RigidPoint


class RowEquation(Struct, frozen=True):
    """A scalar row of a constraint."""

    constraint: int
    row: int


class Closure(Struct, frozen=True):
    """A second expression (``step``) for a point that is already reached; ``part`` 0 is its x, 1 its y component."""

    step: GivenPoint | RigidPoint
    part: int


Equation = RowEquation | Closure


def _equation_name(scene: Scene, equation: Equation) -> str:
    """How messages call an equation."""
    if isinstance(equation, RowEquation):
        return label(scene.constraints[equation.constraint])
    step = equation.step
    if isinstance(step, GivenPoint):
        return label(scene.constraints[step.constraint])
    return f"hinge {step.point} of {step.body}"


def _remedy(scene: Scene, equation: Equation) -> str:
    """What the joint of an equation proposes to write in its place where there are too many of them."""
    known = equation if isinstance(equation, RowEquation) else equation.step
    if isinstance(known, RigidPoint):  # of a point that a joint leads already
        leading = (j for j in scene.joints if any(shape.given_point == known.point for shape in j.shapes()))
        return next((text for joint in leading if (text := joint.when_surplus())), "")
    return scene.joints[known.constraint].when_surplus() if known.constraint < len(scene.joints) else ""


class EquationBlock(Struct, frozen=True):
    """Equations and unknowns (numbers) that are solved together."""

    equations: tuple[int, ...]
    unknowns: tuple[int, ...]


class Plan(Struct, frozen=True):
    """Order of placing, of reaching and of solving; ``omega`` gives the unknown of each body.

    ``placing`` are the points placed by themselves, then ``together`` those that the conditions of the scene place,
    then ``later`` those that are constructed from these.
    """

    placing: tuple[str, ...]
    together: tuple[str, ...]
    later: tuple[str, ...]
    steps: tuple[Step, ...]
    unknowns: tuple[str, ...]
    omega: dict[str, int]
    equations: tuple[Equation, ...]
    blocks: tuple[EquationBlock, ...]


def analyse(scene: Scene) -> Plan:
    """The plan of a scene.

    Raises InputError for wrong names, when points are defined in a circle, and when the scene is under- or
    over-determined; then the message names what is free and which joints contradict or repeat each other.
    """
    check_scene(scene)
    placing, together, later = placing_order(scene)
    search = _PoleSearch(scene)
    search.run()
    depends = _dependencies(scene, search)
    blocks, free, surplus = triangular_blocks(depends, len(search.unknowns))
    if free or surplus:
        raise InputError(
            indeterminate(
                [search.unknowns[i] for i in sorted(free)],
                [_equation_name(scene, search.equations[i]) for i in sorted(surplus)],
                [text for i in sorted(surplus) if (text := _remedy(scene, search.equations[i]))],
            )
        )
    return Plan(
        placing,
        together,
        later,
        tuple(search.steps),
        tuple(search.unknowns),
        search.omega,
        tuple(search.equations),
        tuple(EquationBlock(*block) for block in blocks),
    )


class _PoleSearch:
    """Works out through which poles each material point is reached; collects steps, unknowns and equations."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.shapes: list[tuple[int, int, Shape]] = [
            (c, r, shape)
            for c, constraint in enumerate(scene.constraints)
            for r, shape in enumerate(constraint.shapes())
        ]
        self.steps: list[Step] = []
        self.equations: list[Equation] = []
        self.unknowns: list[str] = [f"omega of {body}" for body in scene.bodies]
        self.omega = {body: i for i, body in enumerate(scene.bodies)}
        self.reached: dict[str, None] = {}
        self._open_bodies = list(scene.bodies)
        self._open_vector_rows = [(c, r, s) for c, r, s in self.shapes if s.given_point is not None]
        self._consumed: set[tuple[int, int]] = set()

    def run(self) -> None:
        """Reach every material point, nearest to the drivers first."""
        self._add_given_points(fixed=True)
        for point in self._driven_points():
            self._add_guided_point(point)
        while (
            self._add_rigid_points(known=True)
            or self._add_given_points(fixed=False)
            or self._add_rigid_points(known=False)
            or self._add_free_point()
        ):
            pass
        self.equations += [
            RowEquation(c, r) for c, r, s in self.shapes if s.given_point is None and (c, r) not in self._consumed
        ]

    def _single_point_rows(self, point: str) -> list[tuple[int, int]]:
        """Scalar rows on this point alone."""
        return [
            (c, r)
            for c, r, s in self.shapes
            if s.given_point is None and s.points == (point,) and not s.bodies and (c, r) not in self._consumed
        ]

    def _driven_points(self) -> list[str]:
        first_driver = len(self.scene.joints)
        return [
            s.points[0]
            for c, _, s in self.shapes
            if c >= first_driver and len(s.points) == 1 and not s.bodies and s.points[0] not in self.reached
        ]

    def _add_guided_point(self, point: str) -> bool:
        """Let a point slide along its guide (not along a driver's row, which gives a magnitude)."""
        guides = [(c, r) for c, r in self._single_point_rows(point) if c < len(self.scene.joints)]
        if point in self.reached or not guides:
            return False
        self._consumed.add(guides[0])
        self.unknowns.append(f"slide of {point}")
        self._add_step(GuidedPoint(point, *guides[0], len(self.unknowns) - 1))
        return True

    def _add_step(self, step: Step) -> None:
        if step.point not in self.reached:
            self.reached[step.point] = None
            self.steps.append(step)
        elif isinstance(step, GivenPoint | RigidPoint):
            self.equations += [Closure(step, 0), Closure(step, 1)]

    def _add_given_points(self, fixed: bool) -> bool:
        for item in self._open_vector_rows:
            c, r, shape = item
            ready = all(p in self.reached for p in shape.points if p != shape.given_point)
            if ready and (not fixed or not shape.bodies) and shape.given_point is not None:
                self._open_vector_rows.remove(item)
                self._add_step(GivenPoint(shape.given_point, c, r, shape.pole))
                return self._add_given_points(fixed) or True
        return False

    def _add_rigid_points(self, known: bool) -> bool:
        for body in self._open_bodies:
            members = self.scene.bodies[body]
            pole = next((p for p in self.reached if p in members), None)
            if pole is None or (known and not self._rotation_known(body)):
                continue
            self._open_bodies.remove(body)
            for point in members:
                if point != pole:
                    self._add_step(RigidPoint(point, body, pole))
            return True
        return False

    def _rotation_known(self, body: str) -> bool:
        return any(s.given_point is None and not s.points and s.bodies == (body,) for _, _, s in self.shapes)

    def _add_free_point(self) -> bool:
        """Nothing can be reached any more: start from another point, one with a guide if there is one."""
        waiting = [p for body in self._open_bodies for p in self.scene.bodies[body]]
        waiting += [p for _, _, s in self.shapes for p in s.points]
        waiting = [p for p in dict.fromkeys(waiting) if p not in self.reached]
        if not waiting:
            return False
        if not any(self._add_guided_point(point) for point in waiting):
            point = waiting[0]
            self.unknowns += [f"velocity of {point} along x", f"velocity of {point} along y"]
            self._add_step(FreePoint(point, len(self.unknowns) - 2, len(self.unknowns) - 1))
        return True


def _dependencies(scene: Scene, search: _PoleSearch) -> list[set[int]]:
    """Unknowns in each equation."""
    forms: dict[str, set[int]] = {}

    def through(step: Step) -> set[int]:
        """Unknowns in the velocity of the point that a step reaches."""
        match step:
            case GivenPoint(_, c, r, _):
                shape = scene.constraints[c].shapes()[r]
                own = {search.omega[b] for b in shape.bodies}
                return own.union(*(forms[p] for p in shape.points if p != shape.given_point))
            case GuidedPoint(_, _, _, unknown, _):
                return {unknown}
            case FreePoint(_, x, y, _):
                return {x, y}
            case RigidPoint(_, body, pole):
                return forms[pole] | {search.omega[body]}

    for step in search.steps:
        forms[step.point] = through(step)
    found = []
    for equation in search.equations:
        if isinstance(equation, Closure):
            found.append(forms[equation.step.point] | through(equation.step))
        else:
            shape = scene.constraints[equation.constraint].shapes()[equation.row]
            found.append({search.omega[b] for b in shape.bodies}.union(*(forms[p] for p in shape.points)))
    return found
