"""Everything that can be known of a solved variant, as tables: ``solve --all``.

Points have their places, velocities and accelerations with components on paper and directions, and the curvature of
their paths; bodies the length and the direction of the line of their first two points, their rates and both centres;
sliding points their relative motion.
Whatever else can be asked stands in a list.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import isfinite
from typing import Any

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.families.parameters.units import Unit, unit
from variantgen.families.quantities import Quantity, interval_names, motion_order, split_name
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.relative import relative_motion
from variantgen.mechanism.scene import fixed_points
from variantgen.variants.variant import Variant, solve_variants

_NOTHING = 1e-11  # of the largest number of a column: what is smaller is rounding
_OPPOSITE = -180 + 1e-9  # degrees: below it an angle is that of the other side but for rounding
_SIGNIFICANT = 10  # digits, more than anyone measures
_IN_TABLES = ("v", "a", "omega", "epsilon", "v_rel", "a_rel", "a_cor", "P", "Q", "mu")

Number = float | None  # None: there is none, as of the direction of nothing or of a centre at infinity


class ResultTable(Struct, frozen=True):
    """Numbers of several things in printed units: ``columns`` are names with units, ``rows`` are by a thing's name."""

    title: str
    columns: tuple[tuple[str, str], ...]
    rows: Mapping[str, tuple[Number, ...]]

    @property
    def data(self) -> dict[str, Any]:
        """The table as plain data."""
        columns = [{"name": name, "unit": own} for name, own in self.columns]
        return {"title": self.title, "columns": columns, "rows": {name: list(row) for name, row in self.rows.items()}}


def all_values(variant: Variant) -> list[dict[str, Any]]:
    """Every quantity that can be asked, with its value in its printed unit (None: infinite), as plain data."""
    asked, motion = _asked(variant), _motion(variant)
    asked += [split_name(name) for name in interval_names(motion.scene)]
    return [_value(quantity, motion, variant.family.length_unit) for quantity in asked]


def everything(variant: Variant) -> list[ResultTable]:
    """The tables of a variant that can be solved."""
    motion, length = _motion(variant), variant.family.length_unit
    others = [_value(q, motion, length) for q in _asked(variant) if q.kind not in _IN_TABLES]
    others += [_value(split_name(name), motion, length) for name in interval_names(motion.scene)]
    found = [_points(motion, length), _paths(motion, length), _bodies(motion, length), _relative(motion, length)]
    found += [
        ResultTable(
            "others",
            (("value", name),),
            {item["quantity"]: (item["value"],) for item in others if item["unit"] == name},
        )
        for name in dict.fromkeys(item["unit"] for item in others)
    ]
    return [_without_rounding(table) for table in found if table.rows]


def _asked(variant: Variant) -> list[Quantity]:
    return [split_name(name) for name in variant.form.askable]


def _motion(variant: Variant) -> Motion:
    """The motion up to what can be asked."""
    return solve_variants([variant], motion_order(_asked(variant)))


def _value(quantity: Quantity, motion: Motion, length: str) -> dict[str, Any]:
    own = quantity.unit(length)
    value = own.from_si(float(quantity.value(motion)[0]))
    shown = float(f"{value:.{_SIGNIFICANT}g}") if isfinite(value) else None
    return {"quantity": quantity.name, "value": shown, "unit": own.name}


def _points(motion: Motion, length: str) -> ResultTable:
    """Places and vectors of all points."""
    columns, rows = [("x", length), ("y", length)], {}
    tables = {"v": motion.v, "a": motion.a} if motion.a else {"v": motion.v}
    for order, kind in enumerate(tables, start=1):
        own = _unit(order, length)
        columns += [(kind, own.name), (f"{kind}.x", own.name), (f"{kind}.y", own.name), (f"{kind}.angle", "deg")]
    for point, places in motion.z.items():
        row: list[Number] = [unit(length).from_si(part) for part in _parts(places)]
        for order, table in enumerate(tables.values(), start=1):
            if point not in table:  # an aid to construct others
                row += [None] * 4
                continue
            x, y = (_unit(order, length).from_si(part) for part in _parts(table[point]))
            row += [abs(complex(x, y)), x, y, _direction(complex(x, y))]
        rows[point] = tuple(row)
    return ResultTable("points", tuple(columns), rows)


def _paths(motion: Motion, length: str) -> ResultTable:
    """The parts of accelerations along and across the paths of points, and the radii of curvature of these."""
    own = _unit(2, length).name
    columns = (("a.t", own), ("a.n", own), ("rho", length))
    fixed = fixed_points(motion.scene)
    names = [point for point in motion.a if point not in fixed] if motion.a else []
    kinds = [Quantity("a", "", "t"), Quantity("a", "", "n"), Quantity("rho", "")]
    rows = {
        point: tuple(_value(replace(kind, target=point), motion, length)["value"] for kind in kinds) for point in names
    }
    moving = {point: row for point, row in rows.items() if any(number is not None for number in row)}
    return ResultTable("paths", columns, moving)


def _bodies(motion: Motion, length: str) -> ResultTable:
    """The line of the first two points, rates, centres."""
    columns = [("length", length), ("angle", "deg"), ("omega", "rad/s")]
    columns += [("epsilon", "rad/s^2")] if motion.epsilon else []
    columns += [("P.x", length), ("P.y", length)]
    columns += [("Q.x", length), ("Q.y", length), ("mu", "deg")] if motion.epsilon else []
    rows: dict[str, tuple[Number, ...]] = {}
    for body, members in motion.scene.bodies.items():
        line = [complex(motion.z[point][0]) for point in members[:2]]
        row: list[Number] = [None, None]
        if len(line) > 1:
            row = [unit(length).from_si(abs(line[1] - line[0])), _direction(line[1] - line[0])]
        row.append(float(motion.omega[body][0]))
        if motion.epsilon:
            row.append(float(motion.epsilon[body][0]))
        centres = [Quantity("P", body, "x"), Quantity("P", body, "y")]
        if motion.epsilon:
            centres += [Quantity("Q", body, "x"), Quantity("Q", body, "y"), Quantity("mu", body)]
        row += [_value(quantity, motion, length)["value"] for quantity in centres]
        if motion.epsilon and row[-2] is None:
            row[-1] = None  # without the centre its angle says nothing
        name = body if body == "".join(members[:2]) else f"{body} ({' to '.join(members[:2])})"
        rows[name] = tuple(row)
    return ResultTable("bodies", tuple(columns), rows)


def _relative(motion: Motion, length: str) -> ResultTable:
    """Motion of points along the bodies on which they slide."""
    columns = [("v_rel", _unit(1, length).name), ("v_rel.angle", "deg")]
    if motion.a:
        columns += [
            (k + part, u) for k in ("a_rel", "a_cor") for part, u in (("", _unit(2, length).name), (".angle", "deg"))
        ]
    rows: dict[str, tuple[Number, ...]] = {}
    for path in Linkage(motion.scene).slides:
        parts = relative_motion(motion, path.point, path.body)
        row: list[Number] = []
        for order, vector in ((1, parts.velocity), (2, parts.acceleration), (2, parts.coriolis)):
            if vector is not None:
                row += [_unit(order, length).from_si(abs(complex(vector[0]))), _direction(complex(vector[0]))]
        rows[f"{path.point} on {path.body}"] = tuple(row)
    return ResultTable("relative motion", tuple(columns), rows)


def _unit(order: int, length: str) -> Unit:
    return unit(length + ("/s" if order == 1 else "/s^2"))


def _parts(values: Any) -> tuple[float, float]:
    z = complex(values[0])
    return z.real, z.imag


def _direction(vector: complex) -> Number:
    """The angle from the x axis in degrees, above -180."""
    angle = float(np.degrees(np.angle(vector)))
    return None if not vector else angle + 360.0 if angle < _OPPOSITE else angle


def _without_rounding(table: ResultTable) -> ResultTable:
    """The table with zeros in the place of what is nothing beside the other numbers of its unit."""
    largest: dict[str, float] = {}
    for (_, own), column in zip(table.columns, zip(*table.rows.values(), strict=True), strict=True):
        largest[own] = max([largest.get(own, 0.0), *(abs(number) for number in column if number is not None)])

    def cleaned(row: tuple[Number, ...]) -> Iterator[Number]:
        nothing: set[str] = set()
        for (name, own), number in zip(table.columns, row, strict=True):
            if number is not None and abs(number) <= _NOTHING * largest[own]:
                nothing.add(name)
            whole, _, part = name.rpartition(".")
            if number is None or (part == "angle" and whole in nothing):
                yield None
            else:
                yield 0.0 if name in nothing else float(f"{number:.{_SIGNIFICANT}g}")

    return ResultTable(table.title, table.columns, {name: tuple(cleaned(row)) for name, row in table.rows.items()})
