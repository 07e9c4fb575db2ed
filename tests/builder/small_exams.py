"""Small exams for tests of builds."""

from __future__ import annotations

from pathlib import Path

from variantgen.exam.exam import Exam
from variantgen.outputs.formats import read_exam

# Without bands of work, which take most of the time of a draw.
TEXT = """
title = "Quiz"
language = "en"
seed = "s"
fair = false
[solutions]
depth = "none"
[[problem]]
family = "four_bar"
ask = ["v_B"]
[[problem]]
families = ["spool", "rolling_wheel"]
"""


def exam_file(folder: Path, text: str = TEXT) -> Path:
    """An exam file in a folder."""
    path = folder / "exam.toml"
    path.write_text(text, "utf-8")
    return path


def exam(folder: Path, text: str = TEXT) -> Exam:
    """An exam that was read from a file in a folder."""
    return read_exam(exam_file(folder, text))


def content(folder: Path) -> dict[str, bytes]:
    """All files of a folder by their paths."""
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}
