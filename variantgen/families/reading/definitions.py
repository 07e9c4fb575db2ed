"""The names that expressions of a form may use: its parameters, and what is derived from them."""

from __future__ import annotations

from collections.abc import Mapping
from heapq import heappop, heappush
from typing import Any

from variantgen.errors import InputError, Problem
from variantgen.families.parameters.dimensions import Dimension, dimension_name
from variantgen.families.parameters.expressions import FamilyExpression, parse
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.plain_angles import Kind, check_angle, kind_of, kind_of_parameter
from variantgen.families.parameters.reading import check_name, unknown_name
from variantgen.mechanism.component import DIMENSIONS
from variantgen.tables import Table


class Definitions:
    """What is known of a form while it is read: derived quantities, dimensions of names, and which are angles."""

    def __init__(self) -> None:
        self.derived: dict[str, FamilyExpression] = {}
        self.dimensions: dict[str, Dimension] = {}
        self._kinds: dict[str, Kind] = {}

    def add(self, parameters: Mapping[str, Parameter]) -> None:
        """Make parameters known."""
        self.dimensions |= {name: own.unit.dimension if own.unit else (0, 0) for name, own in parameters.items()}
        self._kinds |= {name: kind_of_parameter(parameter) for name, parameter in parameters.items()}

    def read(self, table: Table) -> None:
        """Derived quantities, each after those it uses; of several that could be next, the first in the file."""
        parsed = {name: self.parsed(table, name, value) for name, value in table.data.items()}
        waiting = {name: expression for name, expression in parsed.items() if expression is not None}
        order = {name: place for place, name in enumerate(waiting)}
        lacking = {name: len(expression.names & waiting.keys()) for name, expression in waiting.items()}
        users: dict[str, list[str]] = {name: [] for name in waiting}
        for name, expression in waiting.items():
            for used in expression.names & waiting.keys():
                users[used].append(name)
        ready = [(order[name], name) for name in waiting if not lacking[name]]
        while ready:
            _, name = heappop(ready)
            with table.collecting(name):
                self.define(name, waiting.pop(name))
            for user in users[name]:
                lacking[user] -= 1
                if not lacking[user]:
                    heappush(ready, (order[user], user))
        if waiting:
            table.problem("derived quantities use each other in a circle", "", ", ".join(waiting))

    def parsed(self, table: Table, name: str, value: Any) -> FamilyExpression | None:
        """The expression of a key; None for a wrong one, which is noted."""
        if not isinstance(value, str):
            table.problem("expected an expression in quotes", name, value)
            return None
        found: list[FamilyExpression] = []
        with table.collecting(name):
            found.append(parse(value))
        return found[0] if found else None

    def define(self, name: str, expression: FamilyExpression, dimension: Dimension | None = None) -> Dimension:
        """Make a name known; its dimension is that of the expression unless it is stated. Raises InputError."""
        if name in self.dimensions:
            raise InputError(Problem("the name is taken", value=name, remedy="choose another name"))
        check_name(name)
        self.known_names(expression)
        found = dimension or expression.dimension(self.dimensions) or (0, 0)
        self.dimensions[name] = found
        self._kinds[name] = kind_of(expression, self._kinds)
        self.derived[name] = expression
        return found

    def known_names(self, expression: FamilyExpression) -> None:
        """Raise InputError for an expression with an unknown name."""
        for used in sorted(expression.names):
            if used not in self.dimensions:
                raise InputError(unknown_name(used, list(self.dimensions), expression.text))

    def expression(self, text: str, dimension: str = "") -> FamilyExpression:
        """An expression over the known names, of the given dimension if one is due. Raises InputError."""
        expression = parse(text)
        self.known_names(expression)
        found = expression.dimension(self.dimensions)
        if dimension and found is not None and found != DIMENSIONS[dimension]:
            raise InputError(
                Problem(f"is {dimension_name(found)}, expected {dimension_name(DIMENSIONS[dimension])}", value=text)
            )
        (check_angle if dimension == "angle" else kind_of)(expression, self._kinds)
        return expression
