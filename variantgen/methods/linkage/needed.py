"""Which points and bodies the solution for asked quantities leads through."""

from __future__ import annotations

from functools import cached_property

from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.mechanism.joint import Sliding
from variantgen.mechanism.relative import sliding_points
from variantgen.mechanism.solving.structure import (
    Closure,
    FreePoint,
    GivenPoint,
    GuidedPoint,
    RigidPoint,
    RowEquation,
    Step,
)


def needed_for(form: Form, asked: tuple[Quantity, ...]) -> Needed:
    """What the asked quantities of a form need; the same for all its variants, so the form remembers it."""
    key = ("needed", asked)
    if key not in form.remembered:
        found = Needed(form)
        for quantity in asked:
            found.ask(quantity)
        form.remembered[key] = found
    known: Needed = form.remembered[key]
    return known


class Needed:
    """Follows the equations of the solver's plan from what is asked back to the given motion."""

    def __init__(self, form: Form) -> None:
        self._form, self._plan, self._scene = form, form.plan, form.sample
        self._steps = {step.point: step for step in form.plan.steps}
        self._blocks = {u: i for i, block in enumerate(form.plan.blocks) for u in block.unknowns}
        self._unknowns: set[int] = set()
        self.points: set[str] = set()

    @cached_property
    def bodies(self) -> set[str]:
        """Bodies whose rotation is needed by all that was asked; for readers, who come when everything is."""
        return {body for body, unknown in self._plan.omega.items() if unknown in self._unknowns}

    def ask(self, quantity: Quantity) -> None:
        """Follow one asked quantity."""
        if quantity.point:
            self._point(quantity.point)
        if quantity.kind in ("v_rel", "a_rel", "a_cor"):
            self._unknown(self._plan.omega[sliding_points(self._scene)[quantity.target]])
        if quantity.target in self._form.bodies:
            self._body(quantity.target)

    def known_before(self, path: Sliding) -> bool:
        """Whether the rotation of the carrier is solved in an earlier block than the sliding of its point."""
        block = self._blocks[self._plan.omega[path.body]]
        rows = [
            i
            for i, e in enumerate(self._plan.equations)
            if isinstance(e, RowEquation)
            and (joint := self._scene.constraints[e.constraint]) in self._scene.joints
            and joint.sliding() == path
        ]
        return not any(i in self._plan.blocks[block].equations for i in rows)

    def _body(self, body: str) -> None:
        self._unknown(self._plan.omega[body])
        for point in self._form.bodies[body][:2]:
            self._point(point)

    def _point(self, name: str) -> None:
        if name in self.points:
            return
        self.points.add(name)
        if name in self._steps:
            self._step(self._steps[name])

    def _step(self, step: Step) -> None:
        match step:
            case GivenPoint(_, constraint, row, _):
                self._row(constraint, row)
            case GuidedPoint(_, _, _, unknown, _):
                self._unknown(unknown)
            case FreePoint(_, x, y, _):
                self._unknown(x)
                self._unknown(y)
            case RigidPoint(_, body, pole):
                self._point(pole)
                self._unknown(self._plan.omega[body])

    def _row(self, constraint: int, row: int) -> None:
        shape = self._scene.constraints[constraint].shapes()[row]
        for name in shape.points:
            self._point(name)
        for body in shape.bodies:
            self._unknown(self._plan.omega[body])

    def _unknown(self, unknown: int) -> None:
        if unknown in self._unknowns:
            return
        self._unknowns.add(unknown)
        block = self._plan.blocks[self._blocks[unknown]]
        for other in block.unknowns:
            self._unknown(other)
        for number in block.equations:
            equation = self._plan.equations[number]
            if isinstance(equation, Closure):
                self._point(equation.step.point)
                self._step(equation.step)
            else:
                self._row(equation.constraint, equation.row)
