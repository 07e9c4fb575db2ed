"""The methods on every worked case of the catalogue: what was computed by hand comes out of their own steps."""

from __future__ import annotations

import pytest

from tests.solved_cases import every_case, task
from variantgen.families.family import Family
from variantgen.families.reading.cases import Case
from variantgen.methods.natural_answers import work_out
from variantgen.methods.solution.book import Book

CASES = every_case()


@pytest.mark.parametrize(("family", "case"), CASES, ids=[f"{family.name}-{case.id}" for family, case in CASES])
def test_steps_lead_to_the_results_known_by_hand(family: Family, case: Case) -> None:
    scale = max(abs(value) for value in case.exact.values())
    found = work_out(Book(task(family, case, tuple(case.exact))))
    for name, wanted in case.exact.items():
        value = abs(found[name].exact) if case.magnitudes else found[name].exact
        assert value == pytest.approx(wanted, abs=1e-9 * scale), name
