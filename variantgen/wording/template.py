"""Statement templates: a small part of Jinja, so that no file can read, write, hang or eat memory.

Text, ``{{ symbol }}``, ``{% if %}``, ``{% set %}``, comparisons, ``and or not in``, the function ``zero``, items of
``choice`` and ``speeds``. No loops, macros, filters, sums or concatenation: each of them can grow without bound.
``set`` gives new names to symbols, words and conditions: a list that holds itself twice, and so on, would double with
every line, and a name that the program gives (``zero``) keeps its meaning.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import TracebackType
from typing import Any

import jinja2
import jinja2.meta
from jinja2 import nodes
from jinja2.sandbox import ImmutableSandboxedEnvironment

from variantgen.errors import InputError, Problem
from variantgen.letters import named, unseen
from variantgen.tables import read_limited

_ALLOWED = (
    nodes.Template, nodes.Output, nodes.TemplateData, nodes.Name, nodes.Const, nodes.If, nodes.CondExpr, nodes.Assign,
    nodes.Compare, nodes.Operand, nodes.And, nodes.Or, nodes.Not, nodes.Tuple, nodes.List, nodes.Getitem,
    nodes.Getattr, nodes.Neg,
)  # fmt: skip
_FUNCTIONS = ("zero",)
_WORDS = "choice"  # the one name that has attributes: the words of choices
# Names of the program that are no symbols: none of them may be given another meaning.
_KEPT = ("form", "accelerations", "relative", "shown", "choice", "speeding", "speeds", "zero")
_MAX_BYTES = 50_000
# What a faulty template can raise while it is filled.
_ERRORS = (
    jinja2.TemplateError, TypeError, ValueError, ArithmeticError, LookupError, AttributeError, RecursionError,
    MemoryError,
)  # fmt: skip


class StatementTemplate:
    """A template that has been read and found harmless.

    ``variables`` are the names it uses, ``own`` are those that it sets itself, each with the line of the first time.
    """

    def __init__(
        self, path: Path, template: jinja2.Template, variables: frozenset[str], own: Mapping[str, int]
    ) -> None:
        self.path = path
        self.variables = variables
        self.own = own
        self._template = template

    def fill(self, values: dict[str, Any]) -> str:
        """The text. Raises InputError with the line if the template fails."""
        try:
            return self._template.render(values)
        except _ERRORS as error:
            line = _line(error.__traceback__)
            raise InputError(
                Problem(
                    f"{line}the template fails: {error}",
                    file=str(self.path),
                    remedy="compare it with a template of the catalogue",
                )
            ) from None


def load_template(path: Path) -> StatementTemplate:
    """Read a template; as long as its file says the same, it is the same one.

    Raises InputError with line numbers for mistakes and for what is not allowed.
    """
    try:
        return _of_source(path, read_limited(path, _MAX_BYTES).decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise InputError(Problem("is not a text file in UTF-8", file=str(path), remedy="save it as UTF-8")) from None


@cache
def _of_source(path: Path, source: str) -> StatementTemplate:
    """The template that a text is."""
    environment = ImmutableSandboxedEnvironment(undefined=jinja2.StrictUndefined, autoescape=False, finalize=_printable)
    environment.globals.clear()
    try:
        problems = _unseen(source, path)
        tree = environment.parse(source)
        problems += [
            Problem(f"line {line}: {what} is not allowed in a statement", file=str(path), remedy=_REMEDY)
            for line, what in dict.fromkeys(_foreign(tree))
        ]
        if problems:
            raise InputError(problems)
        used = frozenset(jinja2.meta.find_undeclared_variables(tree))
        return StatementTemplate(path, environment.from_string(tree), used, _own(tree))
    except jinja2.TemplateSyntaxError as error:
        raise InputError(
            Problem(f"line {error.lineno}: {error.message}", file=str(path), remedy="correct the template")
        ) from None
    except (OSError, RecursionError, MemoryError, SyntaxError, ValueError) as error:
        raise InputError(Problem(f"cannot be read: {error}", file=str(path))) from None


def _printable(value: Any) -> str:
    """Only symbols and words can be printed, not flags, numbers, lists or functions."""
    if isinstance(value, jinja2.Undefined):
        return str(value)  # raises, naming what is unknown
    if not isinstance(value, str):
        raise TypeError("only symbols and words can be printed")
    return value


_REMEDY = "only symbols, if, set, comparisons, and the function zero"


def _unseen(source: str, path: Path) -> list[Problem]:
    """What cannot be seen in the text of a template; the program itself marks formulas with such characters."""
    found = []
    for number, line in enumerate(source.split("\n"), start=1):
        for letter, kind in unseen(line, allowed="\t\r").items():
            remedy = "remove it: type the text anew instead of pasting it"
            problem = f"line {number}: the statement holds {kind}"
            found.append(Problem(problem, file=str(path), value=named(letter), remedy=remedy))
    return found


def _foreign(tree: nodes.Template) -> list[tuple[int, str]]:
    """Line and kind of every node that is not allowed."""
    found = []
    for node in _every(tree):
        if isinstance(node, nodes.Call) and isinstance(node.node, nodes.Name) and node.node.name in _FUNCTIONS:
            continue
        if what := type(node).__name__.lower() if not isinstance(node, _ALLOWED) else _misused(node):
            found.append((int(node.lineno or 1), what))
    return found


def _misused(node: nodes.Node) -> str:
    """What is wrong with a node of a kind that is allowed; nothing if it is harmless."""
    match node:
        case nodes.Assign():
            if not isinstance(node.target, nodes.Name):
                return "set of several names"
            if node.target.name in _KEPT:
                return f"another meaning of {node.target.name}"
            if any(isinstance(part, nodes.List | nodes.Tuple) for part in _every(node.node)):
                return "set of a list"
        case nodes.Getattr() if not (isinstance(node.node, nodes.Name) and node.node.name == _WORDS):
            return f"the attribute {node.attr}"
        case nodes.Const() if isinstance(node.value, str) and (odd := unseen(node.value)):
            return f"{', '.join(map(named, odd))} in quotes"
    return ""


def _own(tree: nodes.Template) -> dict[str, int]:
    """The names that a template sets, with their lines."""
    found: dict[str, int] = {}
    for node in _every(tree):
        if isinstance(node, nodes.Assign) and isinstance(node.target, nodes.Name):
            found.setdefault(node.target.name, int(node.lineno or 1))
    return found


def _every(node: nodes.Node) -> list[nodes.Node]:
    waiting, found = [node], []
    while waiting:
        found.append(waiting.pop(0))
        waiting += list(found[-1].iter_child_nodes())
    return found


def _line(trace: TracebackType | None) -> str:
    """``line 3: `` of the template in which an error was raised, if it is known."""
    line = ""
    while trace is not None:
        if trace.tb_frame.f_code.co_filename == "<template>":
            line = f"line {trace.tb_lineno}: "
        trace = trace.tb_next
    return line
