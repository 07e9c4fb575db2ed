"""How the program is installed: what README, guides and messages tell to type agrees with the extras that there are."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from variantgen.errors import missing_package

# Only a checkout has the files of the project.
ROOT = Path(__file__).parents[1]
TOLD = "\n".join(path.read_text("utf-8") for path in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))))
EXTRAS = set(tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["optional-dependencies"])
SOURCES = sorted((ROOT / "variantgen").rglob("*.py"))


def test_extras_that_are_told_are_those_of_the_package() -> None:
    """From the folder: the package is on no index."""
    output = [name for names in re.findall(r"\.\[([a-z,]+)\]", TOLD) for name in names.split(",")]
    assert set(output) <= EXTRAS
    assert {"xlsx", "latex", "plots", "dask", "accuracy"} <= set(output)
    assert "pip install variantgen" not in TOLD
    assert "variantgen[" not in TOLD


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("system", [". .venv/bin/activate", r".venv\Scripts\activate", "py -m venv .venv"])
def test_activation_is_told(system: str, language: str) -> None:
    assert f"`{system}`" in (ROOT / "docs" / f"guide.{language}.md").read_text("utf-8")


def test_messages_name_extras_that_there_are() -> None:
    call = re.compile(r"missing_package\(\s*\"[^\"]*\", \"[^\"]*\", \"(\w+)\"")
    named = [name for path in SOURCES for name in call.findall(path.read_text("utf-8"))]
    assert len(named) == 8
    assert set(named) <= EXTRAS


def test_no_message_names_a_package_of_an_index() -> None:
    assert not [path for path in SOURCES if "pip install 'variantgen" in path.read_text("utf-8")]


def test_the_message_for_a_missing_package() -> None:
    error = missing_package("xlsx output needs", "XlsxWriter", "xlsx")
    assert error.exit_code == 3
    assert str(error) == (
        "xlsx output needs the package XlsxWriter; install it in the folder of variantgen, with its environment active:"
        '  pip install ".[xlsx]"'
    )
