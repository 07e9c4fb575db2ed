"""Reading of the tables ``[screens]``, ``[pose]`` and ``[figure]`` of a family."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection
from decimal import Decimal
from typing import Any

from msgspec.structs import replace

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.figure_hints import AngleMark, DiscMark, FigureHints, LengthMark, RightAngle
from variantgen.families.parameters.draw_rules import Comparison, Pose, Screens
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.limits import MARKS, PARTS
from variantgen.tables import Table

ExpressionReader = Callable[..., FamilyExpression]
QuantityReader = Callable[[str, int | Decimal | str], FamilyExpression]
_COMPARISON = re.compile(r"([^<>=]+)(<=|>=|<|>)([^<>=]+)")
DIRECTIONS = {"+x": 1 + 0j, "-x": -1 + 0j, "+y": 1j, "-y": -1j}

_MARKED = (
    'there are no parameters: declare the given number as one, such as  phi = { unit = "deg", values = [30] }'
    "  in [parameters], and name it here; without a name the figure shows no letter"
)


def read_screens(table: Table, expression: ExpressionReader, points: Collection[str]) -> Screens:
    """The screens; numbers that are not given keep their defaults."""
    screens = Screens()
    numbers: dict[str, float] = {}
    table.expect("transmission", "spacing", "aspect", "slant", "trivial", "sensitivity", "ceiling", "mistakes")
    for key in ("transmission", "spacing", "aspect", "slant", "trivial", "sensitivity"):
        if key in table.data:
            value = float(table.number(key, 0))
            if not 0 < value < 1000:
                table.problem("expected a number above 0", key, value)
                continue
            numbers[key] = math.radians(value) if key in ("transmission", "slant") else value
    # Both can only be made tighter: no family may let through what the program would not.
    for key, low, high in (("ceiling", 0.001, screens.ceiling), ("mistakes", screens.mistakes, 0.2)):
        if key in table.data:
            numbers[key] = float(table.number(key, 0))
            if not low <= numbers[key] <= high:
                table.problem(f"expected a number from {low:g} to {high:g}", key, numbers[key])
    inside = []
    table.bounded("inside", PARTS)
    for i, item in enumerate(table.take("inside", list, [], "a list of [point, end, end]")):
        if not isinstance(item, list) or len(item) != 3 or any(not isinstance(n, str) for n in item):
            table.problem("expected three names of points: [point, end, end]", f"inside[{i + 1}]", item)
        else:
            first, second, third = (_known(table, f"inside[{i + 1}]", name, points) for name in item)
            inside.append((first, second, third))
    require = read_require(table, expression)
    table.finish()
    return replace(screens, inside=tuple(inside), require=require, **numbers)


def read_require(table: Table, expression: ExpressionReader) -> tuple[Comparison, ...]:
    """The comparisons of the list ``require``."""
    table.bounded("require", PARTS)
    found = []
    for i, text in enumerate(table.strings("require")):
        with table.collecting(f"require[{i + 1}]"):
            found.append(_comparison(text, expression))
    return tuple(found)


def _comparison(text: str, expression: ExpressionReader) -> Comparison:
    match = _COMPARISON.fullmatch(text)
    if match is None:
        raise InputError(Problem("expected a comparison", value=text, remedy='write it like "OA < AB"'))
    left, right = expression(match[1]), expression(match[3])
    # A difference has a dimension only if both sides have the same.
    expression(f"({match[1]}) - ({match[3]})")
    if match[2].startswith(">"):
        left, right = right, left
    return Comparison(text, left, right, "=" not in match[2])


def read_pose(table: Table) -> Pose:
    """How the scene may be laid on paper."""
    mirror = table.take("mirror", bool, True)
    turns: Any = table.take("quarter_turns", list, [0], "a list of whole numbers 0 to 3")
    if not turns or any(isinstance(t, bool) or not isinstance(t, int) or not 0 <= t <= 3 for t in turns):
        table.problem("expected a list of whole numbers 0 to 3", "quarter_turns", turns)
        turns = [0]
    table.finish()
    return Pose(mirror, tuple(dict.fromkeys(turns)))


def read_figure(
    table: Table, points: set[str], bodies: dict[str, tuple[str, ...]], quantity: QuantityReader
) -> FigureHints:
    """The marks that the drawing needs."""
    for key in table.data:
        table.bounded(key, MARKS)
    angles = [_angle(item, points) for item in table.tables("angles")]
    lengths = [_length(item, points) for item in table.tables("lengths")]
    right_angles = [_right_angle(item, points) for item in table.tables("right_angles")]
    discs = [disc for item in table.tables("discs") if (disc := _disc(item, points, bodies, quantity))]
    hidden, bare, stems = (_names(table, key, points) for key in ("hidden", "bare", "stems"))
    plates, plain, slotted = (_names(table, key, set(bodies), "body") for key in ("plates", "plain", "slotted"))
    lines, thin, axial, grooves, walls, found = (
        _paths(table, key, points) for key in ("lines", "thin", "axial", "grooves", "walls", "found")
    )
    sketch, graph = table.strings("sketch"), table.strings("graph")
    for i, names in enumerate(found, start=1):
        if len(names) != 3 or len(set(names)) != 3:
            table.problem("expected three points, the corner in the middle", f"found[{i}]", ", ".join(names))
    table.finish()
    return FigureHints(
        tuple(angles),
        tuple(lengths),
        tuple(discs),
        hidden,
        plates,
        plain,
        slotted,
        lines,
        thin,
        grooves,
        walls,
        bare,
        stems,
        tuple(right_angles),
        found,
        sketch,
        graph,
        axial=axial,
    )


def check_marks(top: Table, figure: FigureHints, parameters: Collection[str]) -> None:
    """Note in the table of the form the marks that carry no name of a parameter."""
    names = {
        "angles": [mark.name for mark in figure.angles],
        "lengths": [mark.name for mark in figure.lengths],
        "discs": [mark.name for mark in figure.discs],
    }
    for kind, found in names.items():
        for i, name in enumerate(found, start=1):
            if name and name not in parameters:
                remedy = nearest(name, parameters) if parameters else _MARKED
                top.problem("a mark carries the name of a parameter", f"figure.{kind}[{i}].name", name, remedy)


def _names(table: Table, key: str, known: set[str], kind: str = "point") -> tuple[str, ...]:
    """A list of names of points or bodies."""
    names = table.strings(key)
    for name in names:
        _known(table, key, name, known, kind)
    return names


def _paths(table: Table, key: str, points: set[str]) -> tuple[tuple[str, ...], ...]:
    """A list of lists of points."""
    found = []
    for i, item in enumerate(table.take(key, list, [], "a list of lists of points")):
        if not isinstance(item, list) or len(item) < 2 or any(not isinstance(name, str) for name in item):
            table.problem("expected a list of at least two points", f"{key}[{i + 1}]", item)
            continue
        found.append(tuple(_known(table, f"{key}[{i + 1}]", name, points) for name in item))
    return tuple(found)


def _known(table: Table, key: str, name: str, known: Collection[str], kind: str = "point") -> str:
    if name not in known:
        table.problem(f"unknown {kind}", key, name, nearest(name, known))
    return name


def _angle(table: Table, points: set[str]) -> AngleMark:
    rays = points | set(DIRECTIONS)
    mark = AngleMark(
        table.need("name", str, ""),
        _known(table, "at", table.need("at", str, ""), points),
        _known(table, "from", table.need("from", str, ""), rays),
        _known(table, "to", table.need("to", str, ""), rays),
    )
    table.finish()
    return mark


def _right_angle(table: Table, points: set[str]) -> RightAngle:
    rays = points | set(DIRECTIONS)
    mark = RightAngle(
        _known(table, "at", table.need("at", str, ""), points),
        _known(table, "from", table.need("from", str, ""), rays),
        _known(table, "to", table.need("to", str, ""), rays),
    )
    table.finish()
    return mark


def _length(table: Table, points: set[str]) -> LengthMark:
    mark = LengthMark(
        table.need("name", str, ""),
        _known(table, "from", table.need("from", str, ""), points),
        _known(table, "to", table.need("to", str, ""), points),
    )
    table.finish()
    return mark


def _disc(
    table: Table, points: set[str], bodies: dict[str, tuple[str, ...]], quantity: QuantityReader
) -> DiscMark | None:
    centre = _known(table, "centre", table.need("centre", str, ""), points)
    name = table.take("name", str, "")
    body = table.take("body", str, "")
    if body and body not in bodies:
        table.problem("unknown body", "body", body, nearest(body, bodies))
    found = None
    with table.collecting("radius"):
        radius: Any = table.need("radius", (str, int, Decimal), 0, "a length")
        label, arc = table.take("label", str, ""), table.take("arc", bool, False)
        found = DiscMark(centre, quantity("length", radius), name, body, label, arc)
    table.finish()
    return found
