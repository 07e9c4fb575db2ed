"""What a solution starts from: one variant with its data as values, and its solved motion in printed units."""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations

from variantgen.families.expressions import CONSTANTS
from variantgen.families.expressions import Expression as FamilyExpression
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.families.units import unit
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import Scene, fixed_points
from variantgen.methods.expression import Applied, Constant, Expression, Pi, SquareRoot, Total, Value
from variantgen.methods.instant import Instant, instant
from variantgen.methods.name import Name
from variantgen.methods.needed import Needed, needed_for
from variantgen.variants.variant import Variant

CLOSE = 1e-9  # relative difference within which two numbers are one, but for rounding


@dataclass(frozen=True)
class Task:
    """One variant to be solved for the asked quantities; ``now`` is its motion in printed units (cm, cm/s, rad/s)."""

    variant: Variant
    asked: tuple[Quantity, ...]
    now: Instant

    @property
    def form(self) -> Form:
        """The form of the variant's family."""
        return self.variant.form

    @property
    def scene(self) -> Scene:
        """The scene of the variant (numbers in SI)."""
        return self.now.scene

    @cached_property
    def order(self) -> int:
        """1 if velocities are enough, 2 if accelerations are asked."""
        return max((quantity.order for quantity in self.asked), default=1)

    @cached_property
    def at(self) -> Placement:
        """Positions in printed units, with the frame."""
        return Placement(self.now.z, self.scene.frame)

    @cached_property
    def fixed(self) -> frozenset[str]:
        """Points at rest."""
        resting = {name for joint in self.scene.joints for name in joint.resting()}
        return frozenset(fixed_points(self.form.sample) | resting)

    @cached_property
    def needed(self) -> Needed:
        """Points and bodies that lead to what is asked."""
        return needed_for(self.form, self.asked)

    @cached_property
    def accelerated(self) -> Needed:
        """Points and bodies that lead to the accelerations that are asked."""
        return needed_for(self.form, tuple(quantity for quantity in self.asked if quantity.order == 2))

    @cached_property
    def translating(self) -> frozenset[str]:
        """Bodies that do not turn: a joint keeps them from it, or they are led by two equal parallel cranks."""
        held = {
            b for j in self.scene.joints for s in j.shapes() if not s.points for b in s.bodies if len(s.bodies) == 1
        }
        return frozenset(held | {body for body in self.scene.bodies if self._is_on_parallel_cranks(body)})

    def _is_on_parallel_cranks(self, body: str) -> bool:
        """Whether two points of a body are led round fixed points by cranks that are equal as vectors."""
        z, bodies = self.now.z, self.scene.bodies
        cranks = [
            z[point] - z[pivot]
            for point in bodies[body]
            for other, members in bodies.items()
            if other != body and point in members and point not in self.fixed
            for pivot in members
            if pivot in self.fixed
        ]
        return any(abs(first - second) < CLOSE * self.size for first, second in combinations(cranks, 2))

    @cached_property
    def size(self) -> float:
        """Size of the mechanism, in the printed unit of length."""
        places = list(self.now.z.values())
        return max(abs(p - q) for p in places for q in places)

    @cached_property
    def speed(self) -> float:
        """The largest velocity of the mechanism, in printed units."""
        return max((abs(v) for v in self.now.v.values()), default=0.0)

    @cached_property
    def gain(self) -> float:
        """The largest acceleration of the mechanism, in printed units."""
        return max((abs(a) for a in self.now.a.values()), default=0.0)

    @cached_property
    def si(self) -> Mapping[str, float]:
        """Parameters and derived quantities in SI."""
        values = self.form.values({name: self.variant.si(name) for name in self.form.parameters})
        return {name: float(value) for name, value in values.items()}

    @cached_property
    def length_unit(self) -> float:
        """The printed unit of length in metres."""
        return float(unit(self.variant.family.length_unit).factor)

    @cached_property
    def given(self) -> dict[str, Value]:
        """The printed data as values: magnitudes of rates, since the figure shows their senses."""
        return {name: self._given(name) for name, p in self.form.parameters.items() if p.unit is not None}

    def _given(self, name: str) -> Value:
        parameter = self.form.parameters[name]
        assert parameter.unit is not None
        printed = float(self.variant.printed[name])
        shown = abs(printed) if parameter.is_rate else printed
        measure = parameter.unit.measures
        usual = self.unit_of(measure)
        value = Value(Name("parameter", parameter.symbol), measure, shown)
        if parameter.unit.name == usual:
            return value
        value.unit = parameter.unit.name
        converted = unit(usual).from_si(parameter.unit.to_si(self.variant.printed[name]))
        factor = unit(usual).from_si(unit(parameter.unit.name).to_si(type(self.variant.printed[name])(1)))
        shift = Pi() * value / Constant(30) if parameter.unit.name == "rpm" else value * Constant(round(factor, 12))
        return Value(value.name, measure, abs(converted) if parameter.is_rate else converted, shift)

    def unit_of(self, measure: str) -> str:
        """The name of the unit in which a measure is printed in this solution."""
        length = self.variant.family.length_unit
        units = {"length": length, "velocity": f"{length}/s", "acceleration": f"{length}/s^2", "angle": "deg"}
        units |= {"angular velocity": "rad/s", "angular acceleration": "rad/s^2", "time": "s", "number": "1"}
        return units[measure]

    def read(self, expression: FamilyExpression) -> float:
        """The value of an expression of the family in SI."""
        return float(expression.value(self.si))

    def expressed(self, expression: FamilyExpression) -> Expression | None:
        """An expression of the family as one of the solution, if every part of it can be shown; choices are signs."""
        return self._expressed(expression.tree)

    def _expressed(self, node: ast.expr) -> Expression | None:
        match node:
            case ast.Constant(value=int() | float() as number):
                return Constant(float(number))
            case ast.Name(id=name):
                return self._named(name)
            case ast.UnaryOp(op=op, operand=operand):
                inner = self._expressed(operand)
                return None if inner is None else (-inner if isinstance(op, ast.USub) else inner)
            case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int() as power)):
                base = self._expressed(left)
                return None if base is None else base**power
            case ast.BinOp(left=left, op=op, right=right):
                return self._combined(op, self._expressed(left), self._expressed(right))
            case ast.Call(func=ast.Name(id="sqrt"), args=[arg]):
                inner = self._expressed(arg)
                return None if inner is None else SquareRoot(inner)
            case ast.Call(func=ast.Name(id="cos" | "sin" | "tan" as function), args=[arg]):
                inner = self._expressed(arg)
                return None if inner is None else Applied(function, inner)
        return None

    def _named(self, name: str) -> Expression | None:
        """A parameter as its value, a choice as its number, a unit of angles as one, a derived quantity written out."""
        if name == "deg":
            return Constant(1.0)
        if name in CONSTANTS:
            value, (length, _) = CONSTANTS[name]
            return Constant(value / self.length_unit, "length") if length else Pi() if name == "pi" else None
        parameter = self.form.parameters.get(name)
        if parameter is None:
            derived = self.form.derived.get(name)
            return None if derived is None else self._expressed(derived.tree)
        return Constant(float(self.variant.printed[name])) if parameter.unit is None else self.given[name]

    @staticmethod
    def _combined(op: ast.operator, left: Expression | None, right: Expression | None) -> Expression | None:
        """An operation, with factors of plus or minus one written as signs."""
        if left is None or right is None:
            return None
        if isinstance(op, ast.Mult):
            for one, other in ((left, right), (right, left)):
                if isinstance(one, Constant) and abs(one.value) == 1:
                    return other if one.value > 0 else -other
            return left * right
        if isinstance(op, ast.Div):
            return left / right
        return Total(((1, left), (-1 if isinstance(op, ast.Sub) else 1, right)))


def task_of(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity]) -> Task:
    """The task of one variant of a solved batch."""
    raw = instant(motion, index)
    metre = float(unit(variant.family.length_unit).factor)

    def scaled(table: Mapping[str, complex]) -> dict[str, complex]:
        return {name: vector / metre for name, vector in table.items()}

    return Task(variant, tuple(asked), replace(raw, z=scaled(raw.z), v=scaled(raw.v), a=scaled(raw.a)))
