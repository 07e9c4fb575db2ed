"""The motion of a variant over a turn of its driver as arrays, columns and CSV (``variantgen.turn``)."""

from __future__ import annotations

from functools import cached_property
from typing import SupportsIndex

import numpy as np
from msgspec import Struct

from variantgen.arrays.columns import Columns, as_csv, motion_columns
from variantgen.arrays.whole_number import whole_number
from variantgen.errors import InputError, Problem
from variantgen.families.asking import read_ask
from variantgen.families.parameters.units import unit
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.turn.sweep import SweepEnd
from variantgen.notebook import display
from variantgen.variants.driver_sweep import driver_sweep
from variantgen.variants.variant import Variant

_WAY = "way"
_LARGEST = 1_000_000
_DECIMALS = 9  # of degrees: what is beyond is rounding


class DriverTurn(Struct, frozen=True, eq=False, dict=True):
    """The motion of a variant in positions along the way of its driver, shape (K,), the instant among them.

    ``name`` is the parameter that the way changes (an angle in degrees), or ``way``: the angle (degrees) or distance
    (the family's unit of length) since the instant. ``values`` are those of the way, ``motion`` the motion there, in
    SI, with the driver's velocity and acceleration of the instant. ``instant`` is the index of the instant, ``clear``
    tells where velocities have a meaning (not at a dead point), ``ends`` why the way ends below and above.
    """

    variant: Variant
    name: str
    unit: str
    values: Field
    motion: Motion
    instant: int
    clear: np.ndarray[tuple[int], np.dtype[np.bool_]]
    ends: tuple[SweepEnd, SweepEnd]

    @cached_property
    def units(self) -> dict[str, str]:
        """The unit of every column of :meth:`table`."""
        columns = motion_columns(self.motion, self.variant.family.length_unit)[1]
        return {self.name: self.unit} | {name: own.name for name, own in columns.items()}

    def table(self) -> Columns:
        """Columns by name, shape (K,): the way, then the motion in printed units (:mod:`variantgen.arrays.columns`).

        Velocities and accelerations are not a number (NaN) where they have no meaning.
        """
        columns, units = motion_columns(self.motion, self.variant.family.length_unit)
        for name, own in units.items():
            if own.dimension[1]:
                columns[name] = np.where(self.clear, columns[name], np.nan)
        return {self.name: self.values} | columns

    def csv(self) -> str:
        """The table as CSV with the units in its head; empty cells where a number has no meaning."""
        return as_csv(self.table(), self.units)

    def __len__(self) -> int:
        return int(self.values.size)

    def _repr_svg_(self) -> str:
        """What a notebook shows: curves of what the form asks."""
        return display("turn_svg", self)

    def __repr__(self) -> str:
        low, high = (f"{value:.4g}" for value in (self.values[0], self.values[-1]))
        return f"<Turn of {self.variant.family.name}: {len(self)} positions, {self.name} {low} to {high} {self.unit}>"


def turn(variant: Variant, samples: SupportsIndex = 361) -> DriverTurn:
    """The motion of a variant over a turn of its driver, as far as it goes, in about so many positions.

    >>> import variantgen
    >>> crank = variantgen.turn(variantgen.batch("slider_crank", 1, seed=4)[0], samples=13)
    >>> len(crank), crank.name, crank.unit
    (13, 'phi', 'deg')
    >>> crank.csv().splitlines()[0][:23]
    'phi [deg],x_O [cm],y_O '

    Raises InputError for a variant that is not solved or does not move, and for less than two positions.
    """
    if not isinstance(variant, Variant):
        remedy = "of a batch take one:  turn(found[0])"  # type: ignore[unreachable]
        raise InputError(Problem("expected a variant", key="variant", value=type(variant).__name__, remedy=remedy))
    samples = whole_number(samples, "samples", 2, _LARGEST)
    asked = read_ask(variant.form)
    found = driver_sweep(variant, asked, samples)
    length = variant.family.length_unit
    angular = found.sweep.leading_driver.angular
    values = np.round(found.values, _DECIMALS) + 0.0 if angular else unit(length).from_si(found.values)
    return DriverTurn(
        variant,
        found.given or _WAY,
        "deg" if angular else length,
        values,
        found.sweep.motion,
        found.sweep.instant,
        found.sweep.clear,
        found.sweep.ends,
    )
