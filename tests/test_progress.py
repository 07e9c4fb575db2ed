"""How the progress of a build reads."""

from __future__ import annotations

import pytest

from variantgen.cli import progress
from variantgen.cli.progress import Progress, pace


@pytest.mark.parametrize(
    ("rate", "done", "total", "text"),
    [
        (None, 0, 100, ""),
        (0.0, 0, 100, ""),
        (12.0, 40, 100, ", 12.0 students/s, 00:05 left"),
        (1.0, 0, 100, ", 1.0 students/s, 01:40 left"),
        (1 / 3.36, 10, 20, ", 3.4 s per student, 00:34 left"),
        (0.25, 0, 1000, ", 4.0 s per student, 1:06:40 left"),
    ],
)
def test_pace(rate: float | None, done: int, total: int, text: str) -> None:
    assert pace(rate, done, total) == text


def test_lines_of_a_build(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """The library's own words would be ``3.36s/ students`` and, at the beginning, ``? students/s``."""
    monkeypatch.setattr(progress, "_SHORT", 0.0)
    with Progress() as shown:
        shown.show("drawing", 0, 20)
        shown.show("drawing", 10, 20)
    lines = capsys.readouterr().err.splitlines()
    assert lines[0] == "drawing: 0 of 20"
    assert all("?" not in line and "/ " not in line for line in lines)
