"""Vectors at one angle with an axis: the cosine that stands with all of them is cancelled."""

from __future__ import annotations

import pytest

from tests.methods.given_data import worked_book
from variantgen.algebra.expression import Applied, Ratio
from variantgen.algebra.name import Name
from variantgen.algebra.values import walk
from variantgen.methods.steps.step import Derived


def test_a_cosine_that_stands_with_every_vector_is_cancelled() -> None:
    """A crank OA = 40 at 45 degrees, square to a rod AB = 60; omega = 2 and epsilon = -2."""
    data = {"OA": 40, "AB": 60, "phi": 45, "omega_OA": 2, "epsilon_OA": -2, "sense": 1}
    book = worked_book("slider_crank_with_graph", "read", "a_B epsilon_AB", **data)
    derived = (item.value for step in book.steps for item in step.items if isinstance(item, Derived))
    found = next(value for value in derived if value.name == Name("a", "B", "A", "tau"))
    assert found.expression is not None
    assert not [part for part in walk(found.expression) if isinstance(part, (Ratio, Applied))]
    # v_A = 80 along the rod, AP = 60 tan 45 = 60, omega_AB = 80 / 60, so a^n_BA = 80^2 / 60; a^n_A = 160, a^tau_A = 80.
    # Across the guide: a^tau_BA = 160 + 80 - 80^2 / 60.
    assert found.exact == pytest.approx(240 - 80**2 / 60)
