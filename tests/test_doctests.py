"""The examples in docstrings and in docs/python.md give what they say."""

from __future__ import annotations

import doctest
import importlib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
MODULES = ["variantgen", "variantgen.arrays.batch", "variantgen.arrays.turn", "variantgen.testing"]


@pytest.mark.parametrize("name", MODULES)
def test_docstrings(name: str) -> None:
    failed, tried = doctest.testmod(importlib.import_module(name))
    assert tried
    assert not failed


def test_docs() -> None:
    failed, tried = doctest.testfile(str(ROOT / "docs" / "python.md"), module_relative=False, encoding="utf-8")
    assert tried > 15
    assert not failed


def test_every_module_with_an_example_is_tested() -> None:
    package = ROOT / "variantgen"
    found = [
        path for path in package.rglob("*.py") if "\n>>> " in (text := path.read_text("utf-8")) or "    >>> " in text
    ]
    names = {".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__") for path in found}
    assert names == set(MODULES)
