"""The public API is complete, sorted, documented; imports stay lean."""

from __future__ import annotations

import copy
import json
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

import variantgen
from variantgen.cli import main
from variantgen.resources import catalog_dir, templates_dir


def test_exports_are_complete_and_sorted() -> None:
    assert variantgen.__all__ == sorted(variantgen.__all__, key=lambda name: (not name[0].isupper(), name))
    assert len(variantgen.__all__) <= 17
    for name in variantgen.__all__:
        assert getattr(variantgen, name) is not None
        if name != "__version__":
            assert getattr(variantgen, name).__doc__, name
    assert dir(variantgen) == variantgen.__all__


def test_unknown_names_are_attribute_errors() -> None:
    with pytest.raises(AttributeError):
        _ = variantgen.nonsense


def test_objects_are_values() -> None:
    """As dataclasses they were, and Python programs rely on it."""
    one, same = variantgen.Student("id 1", "Ann", "M-1"), variantgen.Student("id 1", group="M-1", name="Ann")
    assert one == same
    assert len({one, same, variantgen.Student("id 2", "Ann", "M-1")}) == 2
    assert repr(one).startswith("Student(id='id 1', name='Ann'")
    assert pickle.loads(pickle.dumps(one)) == copy.deepcopy(one) == one
    match one:
        case variantgen.Student("id 1", name=name):
            assert name == "Ann"
        case _:
            pytest.fail("no match")
    with pytest.raises(AttributeError):
        one.name = "Bob"  # type: ignore[misc]
    with pytest.raises(TypeError):
        variantgen.Student("id 1", "Ann", "M-1", nonsense=1)  # type: ignore[call-arg]


def modules_after(code: str) -> set[str]:
    script = f"import sys\n{code}\nimport json; print(json.dumps([m for m in sys.modules]))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    return {name.split(".")[0] for name in json.loads(done.stdout.splitlines()[-1])}


def test_types_are_told_to_those_who_import_it() -> None:
    assert (Path(variantgen.__file__).parent / "py.typed").is_file()


def test_help_needs_nothing() -> None:
    loaded = modules_after(
        "from variantgen.cli import main\nimport contextlib, io\n"
        "with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(SystemExit): main(['--help'])"
    )
    assert not loaded & {"numpy", "scipy", "jinja2", "typst", "pikepdf", "matplotlib"}


def test_solve_imports_neither_typst_nor_matplotlib() -> None:
    loaded = modules_after(
        "from variantgen.cli import main\nimport contextlib, io\n"
        "with contextlib.redirect_stdout(io.StringIO()): main(['solve', 'four_bar', '--json'])"
    )
    assert "numpy" in loaded
    assert not loaded & {"typst", "matplotlib", "pikepdf", "jinja2", "openpyxl", "hypothesis", "mpmath"}


def test_catalogue_and_templates_are_found() -> None:
    assert (catalog_dir() / "four_bar" / "family.toml").is_file()
    assert (templates_dir() / "words" / "ru.toml").is_file()


@pytest.mark.parametrize("command", [[], ["list"], ["show"], ["solve"], ["check"], ["build"]])
def test_help_is_worth_reading(command: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main([*command, "--help"])
    assert stopped.value.code == 0
    assert len(capsys.readouterr().out) > 200


def test_list_names_every_family(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "--lang", "ru"]) == 0
    out = capsys.readouterr().out
    assert "four_bar" in out
    assert "Катушка" in out
    assert main(["list", "--json"]) == 0
    assert {row["family"] for row in json.loads(capsys.readouterr().out)} == set(variantgen.family_names())
