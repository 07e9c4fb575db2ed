"""Whether the expressions of a form have a meaning for given values: domains of functions, signs of lengths, words.

An expression never yields NaN (dividing by zero gives zero, a root of a negative zero), so that one bad variant cannot
spoil a batch; here such variants are found.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.mechanism.arithmetic import Flags, Real
from variantgen.mechanism.component import field_specs


class Demand(Struct, frozen=True):
    """What an expression must meet: ``allowed`` values (a word's numbers), or a ``least`` value (strict or not)."""

    key: str
    expression: FamilyExpression
    allowed: tuple[float, ...] = ()
    least: str = ""

    @property
    def expects(self) -> str:
        """What is expected, in words."""
        if self.allowed:
            return "one of " + ", ".join(f"{value:g}" for value in self.allowed)
        return (
            f"a value {self.least}"
            if self.least
            else "a finite value: no division by zero, no root of a negative number"
        )

    def met(self, values: Mapping[str, Real]) -> Flags:
        """Whether it is met, per variant."""
        value = self.expression.value(values)
        good = self.expression.defined(values) & np.isfinite(value)
        if self.allowed:
            good &= np.isin(value, self.allowed)
        if self.least:
            good &= np.asarray(value > 0 if self.least == "above 0" else value >= 0)
        return good


def demands(form: Form) -> list[Demand]:
    """Everything that must hold of the expressions of a form, whatever the values."""
    found = [Demand(f"{_section(form, name)}.{name}", expression) for name, expression in form.derived.items()]
    for name, template in form.points.items():
        found += _of_template(template, f"points.{name}")
    for section, templates in (("conditions", form.conditions), ("joints", form.joints), ("drivers", form.drivers)):
        for i, template in enumerate(templates, start=1):
            found += _of_template(template, f"{section}[{i}]")
    found += [
        Demand(f"figure.discs[{i}].radius", disc.radius, (), "above 0")
        for i, disc in enumerate(form.figure.discs, start=1)
    ]
    return [demand for demand in found if demand.allowed or demand.least or demand.expression.risky]


def _section(form: Form, name: str) -> str:
    """Where a derived quantity is written: a law of time, with its derivatives, or one of the others."""
    return "laws" if name in form.laws or name.removesuffix("_dot").removesuffix("_ddot") in form.laws else "derived"


def _of_template(template: ComponentTemplate, key: str) -> Iterator[Demand]:
    for spec in field_specs(template.component):
        item: Any = template.fields.get(spec.name)
        if isinstance(item, FamilyExpression):
            yield Demand(f"{key}.{spec.name}", item, tuple(spec.words.values()), spec.least)
        elif isinstance(item, tuple) and spec.part:
            for i, part in enumerate(item, start=1):
                yield from _of_template(part, f"{key}.{spec.name}[{i}]")


def check_constants(form: Form) -> None:
    """Raise InputError for fixed numbers that cannot be right (a side that is neither left nor right)."""
    wrong = [d for d in demands(form) if not d.expression.names and not d.met({})]
    if wrong:
        raise InputError(
            [Problem(f"expected {demand.expects}", key=demand.key, value=demand.expression.text) for demand in wrong]
        )
