"""The self-check fails when it must."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import variantgen.check
from variantgen.check import check_family
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.verify import Recomputed, recompute


@pytest.mark.parametrize("error", [1e-3, float("nan"), float("inf")])
def test_a_deviation_is_a_failure_also_when_it_is_no_number(error: float, monkeypatch: pytest.MonkeyPatch) -> None:
    def spoiled(motion: Motion) -> Recomputed:
        again = recompute(motion)
        errors = again.velocity_error.copy()
        errors[3] = error
        return replace(again, velocity_error=errors)

    monkeypatch.setattr(variantgen.check, "recompute", spoiled)
    report = check_family("rolling_wheel", seeds=10)
    assert any("independent computation differ" in failure for failure in report.failures)


def test_a_wrong_worked_case_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    cases = variantgen.check.load_cases(variantgen.load_family("spool"))
    wrong = [replace(case, exact={**case.exact, "v_O": 51.0}) for case in cases]
    monkeypatch.setattr(variantgen.check, "load_cases", lambda family: wrong)
    report = check_family("spool", seeds=5)
    assert any("M34" in failure and "v_O" in failure for failure in report.failures)
    assert np.isfinite(report.worst_deviation)
