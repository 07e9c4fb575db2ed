"""The exams that are built: five problems a student, Russian, full solutions unless the command leaves them out."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

_HEAD = 'title = "T"\nlanguage = "ru"\n'
FIVE_FAMILIES = ("four_bar", "slider_crank", "sleeve_on_crank", "rolling_wheel", "spool")


def of_families(families: Sequence[str]) -> str:
    """An exam with one problem of each family, all answers asked."""
    return _HEAD + "".join(f'[[problem]]\nfamily = "{name}"\n' for name in families)


EXAMS = {
    "five four-bars, 3 answers each": _HEAD
    + '[[problem]]\nfamily = "four_bar"\nform = "crank"\nask = ["v_B", "omega_AB", "omega_BC"]\n' * 5,
    "five families, all answers": of_families(FIVE_FAMILIES),
}


def write(text: str, folder: Path) -> Path:
    """An exam file in a folder."""
    path = folder / "exam.toml"
    path.write_text(text, "utf-8")
    return path


def build_arguments(exam: Path, students: int, solutions: bool, out: Path, jobs: int = 1) -> list[str]:
    """The arguments of the program that build an exam."""
    arguments = ["build", str(exam), "--variants", str(students), "--out", str(out), "--jobs", str(jobs), "--force"]
    return arguments if solutions else [*arguments, "--no-solutions"]
