"""Laws of time: an angle or a way that the statement gives as a function of time, at the instant of the problem.

``x`` is a derived quantity of the family with the derivatives ``x_dot`` and ``x_ddot``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.expression import Expression, Total
from variantgen.algebra.normal_form import simplified
from variantgen.families.expressions import FamilyExpression
from variantgen.families.family import Form

if TYPE_CHECKING:
    from variantgen.methods.linkage.problem import Task

_TIME = (0, 1)


def laws(form: Form) -> list[str]:
    """Names of the derived quantities that are laws of time."""
    return [name for name in form.derived if f"{name}_dot" in form.derived]


def law_behind(task: Task, source: FamilyExpression) -> Expression | None:
    """The law whose first or second derivative an expression of the family is."""
    name = _law_of(task.form, source)
    found = task.expressed(task.form.derived[name]) if name else None
    return None if found is None else simplified(found)


def is_uniformly_accelerated(form: Form, source: FamilyExpression) -> bool:
    """Whether the second derivative of the law behind an expression holds no time."""
    name = _law_of(form, source)
    used = form.derived[f"{name}_ddot"].names & set(form.parameters) if name else set()
    units = [form.parameters[own].unit for own in used]
    return bool(name) and not any(unit is not None and unit.dimension == _TIME for unit in units)


def _law_of(form: Form, source: FamilyExpression) -> str:
    """The name of the law whose derivative an expression is; empty without one."""
    return next((name for name in laws(form) if source.names & {f"{name}_dot", f"{name}_ddot"}), "")


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
