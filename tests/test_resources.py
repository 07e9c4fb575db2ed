"""What stands in a package, found without importing it."""

from __future__ import annotations

import importlib
import pkgutil
from pathlib import Path

import variantgen
from variantgen.resources import module_names


def test_modules_are_those_that_python_finds() -> None:
    packages = [info.name for info in pkgutil.walk_packages(variantgen.__path__, "variantgen.") if info.ispkg]
    assert len(packages) > 50
    for package in packages:
        path = importlib.import_module(package).__path__
        assert module_names(path) == sorted(info.name for info in pkgutil.iter_modules(path)), package


def test_files_that_are_no_modules_are_left_out(tmp_path: Path) -> None:
    for name in ("b.py", "a.py", "__init__.py", "notes.txt", "samples.json", "room/__init__.py", "cache/b.pyc"):
        file = tmp_path / name
        file.parent.mkdir(exist_ok=True)
        file.touch()
    assert module_names([str(tmp_path)]) == ["a", "b", "room"]
