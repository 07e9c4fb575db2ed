"""A variant: a family with its parameters drawn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Any

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.families.family import Family, Form
from variantgen.families.form_motion import motion_of
from variantgen.families.parameters.draw_rules import frame
from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.motion import Motion
from variantgen.notebook import display


class Variant(Struct, frozen=True):
    """One drawn variant: printed values of its parameters, and how the scene lies on paper.

    ``printed`` holds the value of each parameter as it is printed (for a choice the number behind the word).
    ``sense`` -1 is a reflection, ``turns`` counts quarter turns, ``attempt`` how many draws it took.
    """

    family: Family
    form: Form
    printed: dict[str, Decimal]
    sense: int = 1
    turns: int = 0
    attempt: int = 1

    @property
    def identity(self) -> tuple[str, str, tuple[tuple[str, str], ...]]:
        """The key of a problem: family, form, printed parameters (no pose on paper, nothing silent)."""
        parameters = self.form.parameters
        printed = ((k, str(v)) for k, v in self.printed.items() if not parameters[k].silent)
        return self.family.name, self.form.name, tuple(sorted(printed))

    def word(self, parameter: str) -> str:
        """The word of a choice parameter."""
        found = self.form.parameters[parameter]
        return found.words[found.printed.index(self.printed[parameter])]

    def si(self, parameter: str) -> float:
        """The value of a parameter in SI."""
        measured = self.form.parameters[parameter].unit
        value = self.printed[parameter]
        return measured.to_si(value) if measured else float(value)

    def motion(self, order: int = 2) -> Motion:
        """Its motion at the instant of the problem, in SI; ``order`` 0 ends with positions, 1 with velocities.

        Arrays have the shape (1,). ``outcome`` says whether it is solved.
        """
        return solve_variants([self], order)

    def __repr__(self) -> str:
        form = f" {self.form.name}" if self.form.name else ""
        data = ", ".join(map(self._told, self.printed))
        return f"<Variant of {self.family.name}{form}{': ' if data else ''}{data}>"

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        """What Hypothesis says of an example, and a console of IPython."""
        printer.text(repr(self))

    def _repr_html_(self) -> str:
        """What a notebook shows: the problem with its figure."""
        return display("variant_html", self)

    def _told(self, name: str) -> str:
        """A parameter with its printed value: ``OA = 26 cm``."""
        unit = self.form.parameters[name].unit
        return f"{name} = {self.word(name)}" if unit is None else f"{name} = {self.printed[name]} {unit.name}"


def parameter_arrays(variants: Sequence[Variant]) -> dict[str, NDArray[np.float64]]:
    """SI values of the parameters of variants of one form, shape (N,) each."""
    parameters = variants[0].form.parameters
    return {name: p.in_si(v.printed[name] for v in variants) for name, p in parameters.items()}


def is_speeding_up(form: Form, values: Mapping[str, Real]) -> list[Any]:
    """By driver whether the motion that it gives gets faster: its velocity and acceleration have the same sense.

    ``values`` are those of a variant or, as arrays of the shape (N,), of several.
    """
    rates = [(driver.rates(1)[0], driver.rates(2)[0]) for driver in (t.build(values) for t in form.drivers)]
    return [np.real(velocity) * np.real(acceleration) > 0 for velocity, acceleration in rates]


def solve_variants(variants: Sequence[Variant], order: int) -> Motion:
    """The motion of variants that share one form, as one batch in their order."""
    form = variants[0].form
    on_paper = frame([v.sense for v in variants], [v.turns for v in variants])
    return motion_of(form, parameter_arrays(variants), on_paper, order)
