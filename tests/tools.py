"""Programs that some tests need besides Python packages: where CI runs, there have to be all of them."""

from __future__ import annotations

import os

import pytest

# The long run (see conftest.py).
NIGHTLY = os.environ.get("HYPOTHESIS_PROFILE") == "nightly"


def need(found: bool, what: str, packages: str) -> None:
    """Skip a test on a machine that lacks a program; fail where CI runs. ``packages`` are those of Debian."""
    if not found:
        assert os.environ.get("CI") != "true", f"{what} is needed here: apt-get install {packages}"
        pytest.skip(f"no {what} on this machine (apt-get install {packages})")
