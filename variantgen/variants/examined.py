"""On which answers a draw is examined, so that no marking and no choice of single questions changes anybody's data."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from variantgen.families.asking import read_ask
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity, motion_order
from variantgen.mechanism.solving.solve import solve

_NOTHING = 1e-9  # SI: what is smaller is zero but for rounding


def examined(form: Form, asked: Sequence[Quantity]) -> list[Quantity]:
    """The answers that are screened: not trivial, well conditioned, showing mistakes, fit for a hand calculation.

    They are those that the form asks by itself: all of them where accelerations are asked, its velocities where only
    velocities are (all, if it asks for no velocity). So two exams that ask for different ones of them draw the same
    data. What is zero in the ranges at hand, as the angular acceleration of a wheel whose centre keeps its velocity,
    is examined only where it is asked. What only the exam asks for is examined as well: nobody has looked whether it
    is any good as an answer.
    """
    order = motion_order(asked)
    own = read_ask(form)
    found = [quantity for quantity in own if quantity.order <= order] or own
    found = _without_zeros(form, found, {quantity.name for quantity in asked}) or found
    known = {_as_good_as(quantity) for quantity in own}
    return found + [quantity for quantity in asked if _as_good_as(quantity) not in known]


def _without_zeros(form: Form, answers: Sequence[Quantity], asked: Collection[str]) -> list[Quantity]:
    """Answers that are not zero in the middle of all ranges, and those that are asked. The form remembers the zeros."""
    key = ("zeros", tuple(answers))
    if key not in form.remembered:
        motion = solve(form.sample, motion_order(answers), form.plan)
        form.remembered[key] = {q.name for q in answers if np.all(np.abs(q.whole.value(motion)) <= _NOTHING)}
    zeros: set[str] = form.remembered[key]
    return [quantity for quantity in answers if quantity.name in asked or quantity.name not in zeros]


def _as_good_as(quantity: Quantity) -> str:
    """What quantities share that are equally good answers: magnitude and sense of a rotation with its signed rate."""
    return quantity.whole_name if quantity.is_rotation else quantity.name
