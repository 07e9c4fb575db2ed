"""The step of a solution that integrates a law given by its velocity or acceleration."""

from __future__ import annotations

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import simplified
from variantgen.algebra.values import parts
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.laws import Law
from variantgen.families.parameters.rate_law import RateLaw
from variantgen.families.parameters.units import unit
from variantgen.methods.by_groups.turn_positions import rounded
from variantgen.methods.linkage.problem import Task
from variantgen.methods.steps.step import EquationLine, Fact, Item, NumberOf, Sentence, Step

_CONSTANTS = ("C", "C_1", "C_2")
_DIGITS = 6  # of a constant
_NUMERICAL = "numerical"
_STEADY = "direct"  # a velocity that is given by the place needs no integration


def integration_steps(task: Task) -> tuple[Step, ...]:
    """A step for each law that is given by a rate, none where the velocity itself is a number or given by the place.

    Where the sheet tells a law in words, only what no formula gives has a step, with the numbers.
    """
    return tuple(
        Step(Sentence("integration.heading", _facts(law.rate), False), _items(task, law, law.rate))
        for law in task.form.laws.values()
        if law.rate is not None and law.integrated is not None and law.integrated.way != _STEADY
        if law.integrated.way == _NUMERICAL or task.writes_laws
    )


def _facts(rate: RateLaw) -> dict[str, Fact]:
    of = rate.name
    return {
        "law": Name("parameter", of),
        "variable": Name("parameter", rate.variable),
        "velocity": Name("parameter", of, dots=1),
        "rate": Name("parameter", of, dots=rate.order),
    }


def _items(task: Task, law: Law, rate: RateLaw) -> list[Item]:
    assert law.integrated is not None, "it has been read"
    way, lines = law.integrated.way, list(law.integrated.lines) if task.writes_laws else []
    found: list[Item] = [*_lines(task, rate, lines[:1]), Sentence(f"integration.{way}", _facts(rate), False)]
    if way != _NUMERICAL:
        return found + _lines(task, rate, lines[1:])
    for order in range(1 if rate.is_by_place else 0, rate.order):
        value = _value(task, law, rate, order)
        number = NumberOf(rounded(value.exact, value.measure))
        found.append(Sentence("integration.value", {"value": value, "number": number}, False))
    return found


def _value(task: Task, law: Law, rate: RateLaw, order: int) -> Value:
    """The place or the velocity at the instant."""
    measure = law.rate_measure(order)
    si = task.si[rate.name + ("", "_dot")[order]]
    return Value(Name("parameter", rate.name, dots=order), measure, float(unit(task.unit_of(measure)).from_si(si)))


def _lines(task: Task, rate: RateLaw, lines: list[tuple[Expression, Expression]]) -> list[Item]:
    """Equations in symbols; those that cannot be shown are left out."""
    known = {name: Value(Name("parameter", name), "number", 0.0) for name in (rate.name, rate.variable, *_CONSTANTS)}
    known |= {
        f"{rate.name}_{'d' * dots}ot": Value(Name("parameter", rate.name, dots=dots), "number", 0.0) for dots in (1, 2)
    }

    def shown(item: Expression) -> Expression | None:
        found = task.expressed(FamilyExpression("", item), known=known)
        if found is None or isinstance(found, Value):
            return found
        # A constant of integration is a number; what it is made of is seen in the file.
        return simplified(found) if parts(found) else Constant(float(f"{found.number(True):.{_DIGITS}g}"))

    sides = [(shown(left), shown(right)) for left, right in lines]
    return [EquationLine(left, right) for left, right in sides if left is not None and right is not None]
