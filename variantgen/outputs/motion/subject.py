"""What is plotted: a variant over a sweep of its driver, in a language."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from msgspec import Struct

from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity
from variantgen.figure.moving import Moving
from variantgen.mechanism.turn.sweep import SweepEnd
from variantgen.outputs.motion.plotted_curves import Panel
from variantgen.outputs.motion.ranges import visible_range
from variantgen.variants.driver_sweep import DriverSweep
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Formula, Index, Symbol
from variantgen.wording.language import Language
from variantgen.wording.mathtext import to_mathtext


class Subject(Struct, frozen=True):
    """What is plotted: the variant over a sweep of its driver, in a language."""

    variant: Variant
    driver_sweep: DriverSweep
    asked: Sequence[Quantity]
    language: Language

    @property
    def shown(self) -> list[str]:
        """Points that the figure shows."""
        return shown_points(self.variant, self.asked)

    @property
    def moving(self) -> Moving:
        """The figures of all positions."""
        return Moving(self.variant, self.driver_sweep.sweep.motion, self.asked, self.language)

    def range_of(self, panel: Panel) -> tuple[float, float, bool]:
        """Limits of the ordinate of a panel, and whether very large values are cut off."""
        sweep = self.driver_sweep.sweep
        bounded = sweep.ends[0] is not SweepEnd.TURN, sweep.ends[1] is not SweepEnd.TURN
        return visible_range([curve.values for curve in panel.curves], sweep.instant, bounded)

    @property
    def abscissa(self) -> Formula:
        """The symbol of the way: a printed angle, an angle turned or a displacement since the instant."""
        if self.driver_sweep.given:
            return self.language.symbol(self.driver_sweep.given, self.variant.form.symbols)
        words = [self.variant.form.symbols.get(name, name) for name in self.driver_sweep.target]
        index = (Index("".join(words)),) if any(words) else ()
        return Symbol("phi" if self.driver_sweep.sweep.leading_driver.angular else "s", index)

    @property
    def abscissa_symbol(self) -> str:
        """The same in mathtext, as a change where an angle is counted from the instant."""
        change = "" if self.driver_sweep.given or not self.driver_sweep.sweep.leading_driver.angular else r"$\Delta$"
        return change + to_mathtext(self.abscissa)

    @property
    def abscissa_text(self) -> str:
        """The label of the abscissa with its unit, in mathtext."""
        measured = unit("deg" if self.driver_sweep.sweep.leading_driver.angular else self.variant.family.length_unit)
        return f"{self.abscissa_symbol}, {to_mathtext(self.language.unit(measured))}"

    @property
    def ways(self) -> Any:
        """The abscissa of all positions in its printed unit, shape (K,)."""
        if self.driver_sweep.sweep.leading_driver.angular:
            return self.driver_sweep.values
        measured = unit(self.variant.family.length_unit)
        return np.array([measured.from_si(float(value)) for value in self.driver_sweep.values])
