"""Columns: tables as mappings of names to arrays, in printed units, and the same as CSV."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from variantgen.families.parameters.units import Unit, unit
from variantgen.mechanism.motion import Motion

Columns: TypeAlias = dict[str, NDArray[Any]]


def motion_columns(motion: Motion, length: str) -> tuple[Columns, dict[str, Unit]]:
    """Columns of a motion with their units; ``length`` is the unit of length, angles are in radians.

    ``x_B``, ``y_B``; ``v_B.x``, ``v_B.y``; ``a_B.x``, ``a_B.y`` of every point that moves, ``omega_AB`` and
    ``epsilon_AB`` of every body, shape (N,) each.
    """
    columns: Columns = {}
    units: dict[str, Unit] = {}

    def add(name: str, values: Any, measure: str) -> None:
        units[name] = unit(measure)
        columns[name] = units[name].from_si(np.asarray(values)) + 0.0  # no -0.0

    for tables, pattern, measure in (
        (motion.z, "{part}_{name}", length),
        (motion.v, "v_{name}.{part}", f"{length}/s"),
        (motion.a, "a_{name}.{part}", f"{length}/s^2"),
    ):
        for name, vector in tables.items():
            add(pattern.format(name=name, part="x"), np.real(vector), measure)
            add(pattern.format(name=name, part="y"), np.imag(vector), measure)
    for body, rate in motion.omega.items():
        add(f"omega_{body}", rate, "rad/s")
    for body, rate in motion.epsilon.items():
        add(f"epsilon_{body}", rate, "rad/s^2")
    return columns, units


def as_csv(columns: Mapping[str, NDArray[Any]], units: Mapping[str, str]) -> str:
    """Columns of the shape (N,) as CSV, numbers with all digits.

    The head names the unit of a column where it has one: ``v_B.x [cm/s]``. What is not a number is empty.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([f"{name} [{units[name]}]" if units.get(name, "1") != "1" else name for name in columns])
    writer.writerows(zip(*([_cell(value) for value in column.tolist()] for column in columns.values()), strict=True))
    return text.getvalue()


def _cell(value: Any) -> str:
    if isinstance(value, float):
        return "" if value != value else repr(value)  # noqa: PLR0124  (only what is not a number differs from itself)
    return str(value)
