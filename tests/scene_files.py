"""Scenes of tests as files of their own, and what the command ``solve`` says of them."""

from __future__ import annotations

import json
from os import PathLike
from pathlib import Path

import pytest

from variantgen.cli import main


def scene_file(folder: Path, text: str) -> Path:
    """A file with the text of a scene."""
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path


def solved_items(path: str | PathLike[str], capsys: pytest.CaptureFixture[str], *asked: str) -> dict[str, dict]:
    """The answers of ``solve --json`` by their quantities, as the document has them: value, unit, tolerance."""
    code = main(["solve", str(path), "--json", *(word for name in asked for word in ("--ask", name))])
    shown = capsys.readouterr()
    assert code == 0, shown.err
    return {item["quantity"]: item for item in json.loads(shown.out)["answers"]}


def solved_values(path: str | PathLike[str], capsys: pytest.CaptureFixture[str], *asked: str) -> dict[str, float]:
    """The values of the answers, in the units of the sheet."""
    return {name: item["value"] for name, item in solved_items(path, capsys, *asked).items()}
