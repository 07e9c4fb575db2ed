"""Hand-friendly variants: what the table ``[nice]`` of a family says, and the form that draws them.

Without a table, given angles are multiples of 30 or 45 degrees and the answers short decimals or simple roots. The
table names other grids (sides of right triangles, say) and comparisons, so that a good share of what is drawn is such.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Any

from msgspec.structs import replace

from variantgen.errors import Problem, nearest
from variantgen.families.family import Family, Form
from variantgen.families.hints import ExpressionReader, read_require
from variantgen.families.parameters.draw_rules import HandFriendly, TiedValues
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.reading import choose_words, read_parameter
from variantgen.tables import Table

_USUAL_ANGLES = (30, 45)  # degrees: multiples of these have the sines that everybody knows


def read_nice(table: Table, parameters: Mapping[str, Parameter], expression: ExpressionReader) -> HandFriendly:
    """The table ``[nice]``; an empty one leaves everything to the answers."""
    before = len(table.problems)
    grids = table.table("parameters")
    found = grids.each(lambda name, value: _read_grid(grids, name, value, parameters))
    columns, rows = table.strings("columns"), table.take("rows", list, [], "a list of lists of values")
    ties = _read_ties(table, columns, rows, parameters, found) if columns or rows else None
    require = read_require(table, expression)
    possible, answers = table.take("possible", bool, True), table.take("answers", bool, True)
    table.finish()
    return HandFriendly(found, ties, require, possible, answers) if len(table.problems) == before else HandFriendly()


def _read_grid(table: Table, name: str, value: Any, parameters: Mapping[str, Parameter]) -> Parameter | None:
    """The parameter with another grid: a list of values (words of a choice), or a table with unit and range."""
    known = parameters.get(name)
    if known is None:
        table.problem("unknown parameter", name, name, nearest(name, parameters))
        return None
    if known.unit is None:
        return _read_words(table, name, value, known)
    content = {"values": value} if isinstance(value, list) else value
    if isinstance(content, dict):
        content = {"unit": known.unit.name, **content}
    grid = read_parameter(table, name, content)
    if grid is None or grid.unit is None:
        return None
    if grid.unit.dimension != known.unit.dimension:
        table.problem(f"expected a unit of {known.unit.measures}", f"{name}.unit", grid.unit.name)
        return None
    return replace(known, unit=grid.unit, printed=grid.printed)


def _read_words(table: Table, name: str, value: Any, known: Parameter) -> Parameter | None:
    """The choice parameter with some of its words only."""
    found: list[Parameter] = []
    with table.collecting(name):
        found.append(choose_words(known, value if isinstance(value, list) else [value], ""))
    return found[0] if found else None


def _read_ties(
    table: Table,
    columns: Sequence[str],
    rows: Sequence[Any],
    parameters: Mapping[str, Parameter],
    grids: dict[str, Parameter],
) -> TiedValues | None:
    """Values that go together; the grid of a parameter becomes its column, unless ``parameters`` gives it one."""
    for name in columns:
        if name not in parameters or parameters[name].silent:
            table.problem("expected a printed parameter", "columns", name, nearest(name, parameters))
            return None
    if len(set(columns)) < max(2, len(columns)):
        table.problem("expected two or more parameters, each once", "columns", ", ".join(columns))
        return None
    if not rows or not all(_is_row(row, len(columns)) for row in rows):
        table.problem(f"expected lists of {len(columns)} values", "rows", rows)
        return None
    read: list[list[Decimal]] = []
    for k, name in enumerate(columns):
        values = [row[k] for row in rows]
        grid = grids.get(name) or _read_grid(table, name, list(dict.fromkeys(values)), parameters)
        if grid is None:
            return None
        numbers = dict(zip(grid.words or grid.printed, grid.printed, strict=True))
        foreign = [value for value in values if value not in numbers]
        if foreign:
            table.problem(f"is not on the grid of {name}", "rows", foreign[0])
            return None
        grids[name] = grid
        read.append([numbers[value] for value in values])
    return TiedValues(tuple(columns), tuple(zip(*read, strict=True)))


def _is_row(row: Any, size: int) -> bool:
    return isinstance(row, list) and len(row) == size and all(isinstance(v, int | Decimal | str) for v in row)


def no_nice_forms(family: Family) -> Problem:
    """The problem of a family, or of the chosen forms of one, without hand-friendly variants."""
    names = "/".join(name for name in family.forms if name)
    return Problem(
        "has no hand-friendly variants",
        key="nice",
        value=f"{family.name} ({names})" if names else family.name,
        remedy="leave nice out, or take another form or family",
    )


def hand_friendly(form: Form) -> Form:
    """The form that draws hand-friendly variants only (:attr:`HandFriendly.possible` says whether it has any)."""
    nice = form.nice
    parameters = {name: nice.parameters.get(name) or _usual_angles(known) for name, known in form.parameters.items()}
    screens = replace(form.screens, require=form.screens.require + nice.require)
    return replace(form, parameters=parameters, screens=screens, ties=nice.ties, friendly=nice.answers)


def _usual_angles(parameter: Parameter) -> Parameter:
    """A given angle on the multiples of 30 and 45 degrees of its grid, if it has any; others as they are."""
    if parameter.silent or parameter.unit is None or parameter.unit.name != "deg":
        return parameter
    kept = tuple(value for value in parameter.printed if any(value % angle == 0 for angle in _USUAL_ANGLES))
    return replace(parameter, printed=kept) if kept else parameter
