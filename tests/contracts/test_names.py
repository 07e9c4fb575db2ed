"""The words of the code: a docstring for everything public, errors and shapes in it, one meaning for each name."""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[2] / "variantgen"
MODULES = {path.relative_to(PACKAGE).as_posix(): path.read_text("utf-8") for path in sorted(PACKAGE.rglob("*.py"))}
TREES = {name: ast.parse(text) for name, text in MODULES.items()}

# Words that had several meanings, or none that a reader would guess: standard terms took their places.
RETIRED = {
    *("told", "settle", "settled", "gain", "judge", "judged", "dear", "teller", "pursuit", "likeness", "windows"),
    *("wish", "wishes", "reach", "slips", "track", "no_way", "Teller", "Carried", "Wish", "Slid", "Crossed", "Coupled"),
    *(
        "Posed",
        "Turned",
        "Spanned",
        "Rested",
        "Touch",
        "Carry",
        "Loose",
        "Margins",
        "Course",
        "Others",
        "Here",
        "Shown",
    ),
}
ARRAY = re.compile(r"NDArray|\b(?:(?:Complex)?Field|Array|Costs)\b")
SHAPE = re.compile(r"\bshapes?\b|\bbatch\b|\barrays?\b|scalars", re.IGNORECASE)


def public(tree: ast.Module) -> Iterator[tuple[str, ast.ClassDef | ast.FunctionDef]]:
    """Public classes, functions and methods of a module by name."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef) and not node.name.startswith("_"):
            yield node.name, node
            for inner in node.body if isinstance(node, ast.ClassDef) else ():
                if isinstance(inner, ast.FunctionDef) and not inner.name.startswith("_"):
                    yield f"{node.name}.{inner.name}", inner


PUBLIC = [(name, label, node) for name, tree in TREES.items() for label, node in public(tree)]
FUNCTIONS = [(name, label, node) for name, label, node in PUBLIC if isinstance(node, ast.FunctionDef)]


def own_errors() -> set[str]:
    """The classes of errors of the package, by the names of their bases."""
    classes = [node for tree in TREES.values() for node in tree.body if isinstance(node, ast.ClassDef)]
    found = {"VariantgenError"}
    while more := {c.name for c in classes if {ast.unparse(base) for base in c.bases} & found} - found:
        found |= more
    return found


def raised(function: ast.FunctionDef) -> set[str]:
    """Names of the errors that a function itself makes and raises, those of functions inside it left out."""
    found, waiting = set(), list[ast.AST](function.body)
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            found.add(ast.unparse(node.exc.func))
        if not isinstance(node, ast.FunctionDef | ast.ClassDef | ast.Lambda):
            waiting += ast.iter_child_nodes(node)
    return found


def annotations(function: ast.FunctionDef) -> list[str]:
    hints = [a.annotation for a in (*function.args.args, *function.args.kwonlyargs)] + [function.returns]
    return [ast.unparse(hint) for hint in hints if hint is not None]


def test_everything_public_has_a_docstring() -> None:
    assert len(PUBLIC) > 1000
    assert [name for name, tree in TREES.items() if not ast.get_docstring(tree)] == []
    assert [(name, label) for name, label, node in PUBLIC if not ast.get_docstring(node)] == []


def test_errors_are_named_where_they_are_raised() -> None:
    errors = own_errors()
    assert {"InputError", "ToolMissingError", "LatexError", "MissingGlyphsError"} <= errors
    silent = [
        (name, label, error)
        for name, label, node in FUNCTIONS
        for error in raised(node) & errors
        if error not in (ast.get_docstring(node) or "")
    ]
    assert silent == []


def test_functions_on_arrays_say_the_shape() -> None:
    arrays = [(name, label, node) for name, label, node in FUNCTIONS if any(map(ARRAY.search, annotations(node)))]
    assert len(arrays) > 40
    assert [(name, label) for name, label, node in arrays if not SHAPE.search(ast.get_docstring(node) or "")] == []


def test_no_class_name_has_two_meanings() -> None:
    """Modules of one folder may each have the class that their folder asks for."""
    homes = defaultdict(set)
    for name, label, node in PUBLIC:
        if isinstance(node, ast.ClassDef):
            homes[label].add(name)
    several = {label: found for label, found in homes.items() if len(found) > 1}
    assert {label: found for label, found in several.items() if label != "Derivation"} == {}
    assert {Path(name).parent.as_posix() for name in several["Derivation"]} == {"methods/geometry/placing"}


def test_rows_of_data_are_structs() -> None:
    """A dataclass compiles its methods at each start, which takes thirty times as long as a Struct."""
    imported = defaultdict(set)
    for name, tree in TREES.items():
        for node in ast.walk(tree):
            if isinstance(node, ast.Import | ast.ImportFrom):
                imported[getattr(node, "module", "") or node.names[0].name].add(name)
    assert len(imported["msgspec"]) > 200
    assert imported["dataclasses"] == set()


@pytest.mark.parametrize("name", MODULES)
def test_a_module_is_short_and_without_retired_words(name: str) -> None:
    assert MODULES[name].count("\n") <= 300
    tokens = tokenize.generate_tokens(io.StringIO(MODULES[name]).readline)
    assert {token.string for token in tokens if token.type == tokenize.NAME} & RETIRED == set()
