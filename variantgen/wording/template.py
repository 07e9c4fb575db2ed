"""Statement templates: a small part of Jinja, so that no file can read, write, hang or eat memory.

Text, ``{{ symbol }}``, ``{% if %}``, ``{% set %}``, comparisons, ``and or not in``, the function ``zero``, items of
``choice`` and ``speeds``. No loops, macros, filters, sums or concatenation: each of them can grow without bound.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from types import TracebackType
from typing import Any

import jinja2
import jinja2.meta
from jinja2 import nodes
from jinja2.sandbox import ImmutableSandboxedEnvironment

from variantgen.errors import InputError, Problem
from variantgen.tables import read_limited

_ALLOWED = (
    nodes.Template, nodes.Output, nodes.TemplateData, nodes.Name, nodes.Const, nodes.If, nodes.CondExpr, nodes.Assign,
    nodes.Compare, nodes.Operand, nodes.And, nodes.Or, nodes.Not, nodes.Tuple, nodes.List, nodes.Getitem,
    nodes.Getattr, nodes.Neg,
)  # fmt: skip
_FUNCTIONS = ("zero",)
_MAX_BYTES = 50_000
# Marks that the program itself puts around formulas.
_PRIVATE = re.compile("[\ue000-\uf8ff]")
# What a faulty template can raise while it is filled.
_ERRORS = (
    jinja2.TemplateError, TypeError, ValueError, ArithmeticError, LookupError, AttributeError, RecursionError,
    MemoryError,
)  # fmt: skip


class StatementTemplate:
    """A template that has been read and found harmless; ``variables`` are the names it uses."""

    def __init__(self, path: Path, template: jinja2.Template, variables: frozenset[str]) -> None:
        self.path = path
        self.variables = variables
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


@cache
def load_template(path: Path) -> StatementTemplate:
    """Read a template. Raises InputError with line numbers for mistakes and for what is not allowed."""
    environment = ImmutableSandboxedEnvironment(undefined=jinja2.StrictUndefined, autoescape=False, finalize=_printable)
    environment.globals.clear()
    try:
        source = _PRIVATE.sub("", read_limited(path, _MAX_BYTES).decode("utf-8-sig"))
        tree = environment.parse(source)
        problems = [
            Problem(f"line {line}: {what} is not allowed in a statement", file=str(path), remedy=_REMEDY)
            for line, what in dict.fromkeys(_foreign(tree))
        ]
        if problems:
            raise InputError(problems)
        return StatementTemplate(
            path, environment.from_string(tree), frozenset(jinja2.meta.find_undeclared_variables(tree))
        )
    except jinja2.TemplateSyntaxError as error:
        raise InputError(
            Problem(f"line {error.lineno}: {error.message}", file=str(path), remedy="correct the template")
        ) from None
    except UnicodeDecodeError:
        raise InputError(Problem("is not a text file in UTF-8", file=str(path), remedy="save it as UTF-8")) from None
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


def _foreign(tree: nodes.Template) -> list[tuple[int, str]]:
    """Line and kind of every node that is not allowed."""
    found = []
    for node in _every(tree):
        if isinstance(node, nodes.Call) and isinstance(node.node, nodes.Name) and node.node.name in _FUNCTIONS:
            continue
        if not isinstance(node, _ALLOWED):
            found.append((int(node.lineno or 1), type(node).__name__.lower()))
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
