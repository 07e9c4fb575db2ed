"""Laws of time: an angle or a way that the statement gives as a function of time, at the instant of the problem.

``x`` is a derived quantity of the family with the derivatives ``x_dot`` and ``x_ddot``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.expression import Expression, Total, Value, Variable
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import simplified
from variantgen.families.family import Form
from variantgen.families.parameters.expressions import FamilyExpression

if TYPE_CHECKING:
    from variantgen.methods.linkage.problem import Task

_TIME = (0, 1)


def laws(form: Form) -> list[str]:
    """Names of the derived quantities that are laws of time."""
    return [name for name in form.derived if f"{name}_dot" in form.derived]


def places(form: Form) -> list[str]:
    """Names of the parameters that are places whose velocity is given."""
    return [name for name, law in form.laws.items() if law.rate is not None and law.rate.is_by_place]


def law_behind(task: Task, source: FamilyExpression) -> Expression | None:
    """The law whose first or second derivative an expression of the family is; of a place itself."""
    name = law_of(task.form, source)
    found = task.expressed(FamilyExpression(name, Variable(name))) if name else None
    return None if found is None else simplified(found)


def is_uniformly_accelerated(form: Form, source: FamilyExpression) -> bool:
    """Whether the second derivative of the law behind an expression holds no time."""
    name = law_of(form, source)
    if name and form.derived[f"{name}_ddot"].names & form.derived.keys():
        return False  # it depends on the place or the velocity
    used = form.derived[f"{name}_ddot"].names & set(form.parameters) if name else set()
    units = [form.parameters[own].unit for own in used]
    return bool(name) and not any(unit is not None and unit.dimension == _TIME for unit in units)


def rate_of_law(task: Task, source: FamilyExpression) -> tuple[Value, Expression] | None:
    """The derivative of a law of time in an expression of the family, with its sign; the expression by that letter.

    None where the expression holds no such derivative, several of them, or what cannot be written out, and where the
    sheet speaks of the law without its letter.
    """
    if not task.writes_laws:
        return None
    suffixes = {"_dot": 1, "_ddot": 2}
    moving = [*laws(task.form), *places(task.form)]
    names = {law + suffix: (law, dots) for law in moving for suffix, dots in suffixes.items()}
    found = sorted(source.names & names.keys())
    rate = task.expressed(task.form.derived[found[0]]) if len(found) == 1 else None
    if rate is None:
        return None
    (law, dots), rate = names[found[0]], simplified(rate)
    measure, scale = (("velocity", task.largest_speed), ("acceleration", task.largest_acceleration))[dots - 1]
    if not task.form.laws[law].is_length:
        measure, scale = f"angular {measure}", scale / task.size
    value = Value(Name("parameter", law, dots=dots), measure, rate.number(True), rate, scale)
    by_letter = task.expressed(source, known={found[0]: value})
    return None if by_letter is None else (value, simplified(by_letter))


def law_of(form: Form, source: FamilyExpression) -> str:
    """The name of the law, or the place, whose derivative an expression is; empty without one."""
    return next((name for name in [*laws(form), *places(form)] if source.names & {f"{name}_dot", f"{name}_ddot"}), "")


def angle_law(task: Task, name: str) -> tuple[int, Expression] | None:
    """The angle (degrees) that a law of time gives: its sign, and its magnitude as an expression.

    None for a derived quantity that is no law, or one that cannot be written out.
    """
    if name not in laws(task.form):
        return None
    law = task.expressed(task.form.derived[name], degrees=True)
    if law is None:
        return None
    sign, law = 1, simplified(law)
    while isinstance(law, Total) and len(law.terms) == 1:
        sign, law = sign * law.terms[0][0], law.terms[0][1]
    return sign, law
