"""Methods that are loaded when they are called: every name in the tables is that of a function."""

from __future__ import annotations

import ast
from importlib import import_module
from pathlib import Path

import variantgen.methods

FOLDER = Path(variantgen.methods.__file__).parent


def named() -> list[tuple[str, str]]:
    """Modules and functions that the tables name, read from their source."""
    found = []
    for table in ("by_groups/group_methods.py", "by_groups/solve_groups.py"):
        for node in ast.walk(ast.parse((FOLDER / table).read_text("utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "on_demand":
                found.append(tuple(ast.literal_eval(argument) for argument in node.args))
    return found


def test_every_name_is_that_of_a_function() -> None:
    names = named()
    assert len(names) > 20
    for module, function in names:
        assert callable(getattr(import_module(f"variantgen.methods.{module}"), function)), (module, function)
