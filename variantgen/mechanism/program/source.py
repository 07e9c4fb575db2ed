"""The text of a Python function that makes a motion, and what it calls by name.

Nothing of a family file stands in the text but names, as quoted strings; numbers are variables of the function.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from variantgen.mechanism.motion import Motion
from variantgen.mechanism.program.recording import ArrayOperation, Operand, Recorded

_TABLES = ("z", "v", "a", "omega", "epsilon")  # of a motion; before them come its outcome and its transmission


class Source:
    """Lines of a function, with the names of its constants and of the functions that it calls."""

    def __init__(self, head: str, **known: Any) -> None:
        self._lines, self._known = [f"def motion({head}):"], {"Motion": Motion, **known}
        self._constants: dict[str, str] = {}

    def add(self, line: str) -> None:
        """One more line."""
        self._lines.append(f"    {line}")

    def call(self, function: Callable[..., Any]) -> str:
        """The name of a function."""
        self._known[function.__name__] = function
        return function.__name__

    def constant(self, value: Any) -> str:
        """The name of a constant."""
        key = f"{type(value).__name__} {value!r}"
        if key not in self._constants:
            self._constants[key] = f"k{len(self._constants)}"
            self._known[self._constants[key]] = value
        return self._constants[key]

    def function(self) -> Callable[..., Motion]:
        """The function whose text is complete."""
        exec(compile("\n".join(self._lines), "<program of a form>", "exec"), self._known)  # noqa: S102  # see above
        made: Callable[..., Motion] = self._known["motion"]
        return made


def results(motion: Motion) -> list[ArrayOperation]:
    """The operations whose results a recorded motion has, each once."""
    tables = [getattr(motion, name) for name in _TABLES]
    numbers: list[Any] = [motion.outcome, motion.transmission, *(x for table in tables for x in table.values())]
    return list(dict.fromkeys(x.operation for x in numbers if isinstance(x, Recorded)))


def motion_text(motion: Motion, written: Callable[[Operand], str]) -> str:
    """The motion of a ``scene`` with each of its numbers ``written``: an operation, or an array of one number where
    that is the same for all variants.
    """

    def number(x: Any) -> str:
        return written(x.operation if isinstance(x, Recorded) else x)

    def table(numbers: Mapping[str, Any]) -> str:
        return "{" + ", ".join(f"{name!r}: {number(x)}" for name, x in numbers.items()) + "}"

    tables = ", ".join(table(getattr(motion, name)) for name in _TABLES)
    return f"Motion(scene, {number(motion.outcome)}, {number(motion.transmission)}, {tables})"
