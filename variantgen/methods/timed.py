"""Laws of time: an angle or a way that the statement gives as a function of time, at the instant of the problem.

``x`` is a derived quantity of the family with the derivatives ``x_dot`` and ``x_ddot``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.families.expressions import Expression as FamilyExpression
from variantgen.families.family import Form
from variantgen.mechanism.constructions.polar import Polar
from variantgen.methods.expression import Constant, Expression, Pi, Ratio, Total, Value
from variantgen.methods.monomial import simplified
from variantgen.methods.name import Name
from variantgen.methods.step import Derived

if TYPE_CHECKING:
    from variantgen.methods.geometry import Geometry
    from variantgen.methods.task import Task

_NEAR = 1e-6  # degrees


def laws(form: Form) -> list[str]:
    """Names of the derived quantities that are laws of time."""
    return [name for name in form.derived if f"{name}_dot" in form.derived]


def law_behind(task: Task, source: FamilyExpression) -> Expression | None:
    """The law whose first or second derivative an expression of the family is."""
    for name in laws(task.form):
        if source.names & {f"{name}_dot", f"{name}_ddot"}:
            found = task.expressed(task.form.derived[name])
            return None if found is None else simplified(found)
    return None


def timed_direction(geometry: Geometry, start: str, end: str, exact: float) -> Value | None:
    """A direction (``exact``, degrees) that a law of time gives: the angle turned through and a multiple of 90 degrees.

    The law is in radians; the lines that derive the angle in degrees are added to the items of the geometry.
    """
    form = geometry.task.form
    template = form.points.get(end)
    if template is None or template.component is not Polar or template.fields["origin"] != start:
        return None
    angle = template.fields.get("angle")
    names = [name for name in laws(form) if isinstance(angle, FamilyExpression) and name in angle.names]
    if len(names) != 1 or template.fields.get("towards"):
        return None
    turned = _turned(geometry, names[0])
    return None if turned is None else _from_axis(turned, Name("direction", start, end), exact)


def _turned(geometry: Geometry, name: str) -> Value | None:
    """The angle turned through (degrees), with its line; the same value each time."""
    for item in geometry.items:
        if isinstance(item, Derived) and item.value.name == Name("parameter", name):
            return item.value
    law = geometry.task.expressed(geometry.task.form.derived[name])
    if law is None:
        return None
    whole = Ratio(_unsigned(simplified(Constant(180.0) * law)), Pi())
    value = Value(Name("parameter", name), "angle", whole.number(True), whole)
    geometry.items.append(Derived(value))
    return value


def _unsigned(law: Expression) -> Expression:
    """A law without a leading sign: the figure shows the sense."""
    while isinstance(law, Total) and len(law.terms) == 1:
        law = law.terms[0][1]
    return law


def _from_axis(turned: Value, name: Name, exact: float) -> Value | None:
    """The direction as a multiple of a right angle and the angle turned through."""
    for sign in (1, -1):
        offset = exact - sign * turned.exact
        whole = round(offset / 90.0) * 90.0
        if abs(offset - whole) < _NEAR:
            start = [(1 if whole > 0 else -1, Constant(abs(whole), "angle"))] if whole else []
            return Value(name, "angle", exact, Total((*start, (sign, turned))))
    return None
