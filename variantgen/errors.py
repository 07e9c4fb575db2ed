"""The errors a user can meet, as one tree; each class carries its exit code.

An :class:`InputError` holds one or more :class:`Problem` records. A problem names the file, the key, the
value, what was expected and what to do, because the reader is an instructor and not a programmer.
"""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct


class Problem(Struct, frozen=True):
    """One mistake in the input: where it is, what it says, what was expected, what to do."""

    message: str
    file: str = ""
    key: str = ""
    value: str = ""
    remedy: str = ""

    def __str__(self) -> str:
        where = ": ".join(part for part in (self.file, self.key) if part)
        head = f"{where}: {self.message}" if where else self.message
        if self.value:
            head += f" (got {self.value})"
        return head + (f"\n    {self.remedy}" if self.remedy else "")

    def located(self, file: str) -> Problem:
        """The same problem with the file named, if none was."""
        return self if self.file else Problem(self.message, file, self.key, self.value, self.remedy)


class VariantgenError(Exception):
    """Base of every error this package raises on purpose.

    ``may_pass``: whether the cause lies outside, so that the same work may succeed another time.
    """

    exit_code = 1
    may_pass = False


class InputError(VariantgenError):
    """The input is wrong (exit code 2); holds every problem found, not just the first."""

    exit_code = 2

    def __init__(self, problems: Problem | Iterable[Problem]) -> None:
        self.problems = (problems,) if isinstance(problems, Problem) else tuple(problems)
        super().__init__(self.problems)  # what it is made of again when it comes from another process

    def __str__(self) -> str:
        return "\n".join(str(problem) for problem in self.problems)

    def located(self, file: str) -> InputError:
        """The same error with the file named in every problem that named none."""
        return InputError(problem.located(file) for problem in self.problems)


class ToolMissingError(VariantgenError):
    """An optional tool or package is needed and not installed (exit code 3)."""

    exit_code = 3


def missing_package(what: str, package: str, extra: str, otherwise: str = "") -> ToolMissingError:
    """The error for a package that is not installed, with the command that installs it; ``otherwise`` is a way out.

    The package is not on an index: its extras are those of the folder with its sources. Quotation marks like these are
    known to the shells of all systems.
    """
    how = f'in the folder of variantgen, with its environment active:  pip install ".[{extra}]"'
    return ToolMissingError(f"{what} the package {package}; install it {how}{otherwise}")


def nearest(word: str, known: Iterable[str]) -> str:
    """A remedy that names the known words closest to a mistyped one."""
    import difflib

    names = sorted(known)
    close = difflib.get_close_matches(word, names, n=3, cutoff=0.5 if len(word) <= 2 else 0.6)
    if close:
        return "did you mean " + " or ".join(close) + "?"
    return "known: " + ", ".join(names) if names else "nothing is known here"
