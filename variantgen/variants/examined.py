"""On which answers a draw is examined, so that no marking and no choice of single questions changes anybody's data."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.asking import read_ask
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity


def examined(form: Form, asked: Sequence[Quantity]) -> list[Quantity]:
    """The answers that must be neither trivial nor touchy, show mistakes, and bear the rounding of a hand calculation.

    They are those that the form asks by itself: all of them where accelerations are asked, its velocities where only
    velocities are (all, if it asks for no velocity). So two exams that ask for different ones of them draw the same
    data. What only the exam asks for is examined as well: nobody has looked whether it is any good as an answer.
    """
    order = max(quantity.order for quantity in asked)
    own = read_ask(form)
    found = [quantity for quantity in own if quantity.order <= order] or own
    known = {_as_good_as(quantity) for quantity in own}
    return found + [quantity for quantity in asked if _as_good_as(quantity) not in known]


def _as_good_as(quantity: Quantity) -> str:
    """What quantities share that are equally good answers: magnitude and sense of a rotation with its signed rate."""
    return quantity.whole_name if quantity.is_rotation else quantity.name
