"""What answers are worth: data of its own, with which no sheet changes.

A file like this one, or the table ``[marking]`` of an exam file, with what differs from the usual::

    tolerance = 1.5                              # times the tolerances of the key
    points = { 1 = 5, 2 = 3 }                    # of problems, in place of those of the exam
    shares = { sign = 0.5, power_of_ten = 0.5 }  # of the points of an answer, by the cause of a wrong one
    follow_through = 0.8                         # of the points, where an answer is right given earlier wrong ones
    struck = ["3", "2.a_B"]                      # problems or answers that do not count
    bonus = ["4"]                                # problems whose points add to the sum, and not to the most
    rounding = { problem = 0.25, total = 0.5 }   # steps that points are rounded to, halves up
    grades = { "5" = 85, "4" = 70, "3" = 50 }    # from so many per cent on
"""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from math import floor
from pathlib import Path
from typing import Any

from msgspec import Struct, field

from variantgen.errors import InputError, Problem, nearest
from variantgen.tables import Table, read_toml

# Why an answer that is not right may be wrong, in the order of the documentation; ``other``: nothing is recognised.
CAUSES = (
    "sign", "power_of_ten", "unit", "dimension", "rounding", "component", "other_answer", "neighbour", "mistake",
    "other",
)  # fmt: skip
_MOST_POINTS = 1000


class MarkingPolicy(Struct, frozen=True):
    """See the module; ``shares`` are fractions of an answer's points by cause, none where nothing is said.

    An answer that follows from wrong ones has all its points if nothing is said: a slip is paid for once.
    """

    tolerance: Decimal = Decimal(1)
    points: Mapping[int, Decimal] = field(default_factory=dict)
    shares: Mapping[str, Decimal] = field(default_factory=dict)
    follow_through: Decimal = Decimal(1)
    struck: frozenset[str] = frozenset()
    bonus: frozenset[str] = frozenset()
    problem_step: Decimal = Decimal(0)
    total_step: Decimal = Decimal(0)
    grades: tuple[tuple[str, Decimal], ...] = ()

    def is_struck(self, problem: int, quantity: str) -> bool:
        """Whether an answer does not count."""
        return str(problem) in self.struck or f"{problem}.{quantity}" in self.struck

    def entries(self) -> list[tuple[str, Decimal | str]]:
        """What the policy says, by the names of its file: ``shares.sign``."""
        found: list[tuple[str, Decimal | str]] = [("tolerance", self.tolerance)]
        found += [(f"points.{number}", points) for number, points in sorted(self.points.items())]
        found += [(f"shares.{cause}", self.shares[cause]) for cause in CAUSES if cause in self.shares]
        found.append(("follow_through", self.follow_through))
        found += [
            (name, ", ".join(sorted(own))) for name, own in (("struck", self.struck), ("bonus", self.bonus)) if own
        ]
        found += [("rounding.problem", self.problem_step), ("rounding.total", self.total_step)]
        return [*found, *((f"grades.{name}", least) for name, least in self.grades)]

    def grade(self, points: Fraction, most: Fraction) -> str:
        """The grade of a sum of points; '' where there is no scale or nothing to reach."""
        if not most:
            return ""
        return next((name for name, least in self.grades if 100 * points >= Fraction(least) * most), "")


def rounded(points: Fraction, step: Decimal) -> Fraction:
    """Points to the nearest multiple of a step, halves up; as they are where the step is zero."""
    size = Fraction(step)
    return floor(points / size + Fraction(1, 2)) * size if size else points


def read_policy_file(path: Path, asked: Mapping[int, frozenset[str] | None]) -> MarkingPolicy:
    """The policy of a file of its own; ``asked`` are the names of what each problem asks. Raises InputError."""
    problems: list[Problem] = []
    policy = read_policy(Table(read_toml(path), "", problems), asked)
    if problems:
        raise InputError(problem.located(str(path)) for problem in problems)
    return policy


def read_policy(table: Table, asked: Mapping[int, frozenset[str] | None]) -> MarkingPolicy:
    """The policy that a table says; mistakes are noted in it. ``asked``: None where it is not known yet."""
    shares = table.table("shares")
    for name in shares.data:
        if name not in CAUSES:
            shares.problem("unknown cause", name, shares.data[name], nearest(name, CAUSES))
    steps = table.table("rounding")
    points = dict(_points(table.table("points"), asked))
    grades = table.table("grades")
    scale = sorted(((name, _within(grades, name, 100)) for name in grades.data), key=lambda item: -item[1])
    policy = MarkingPolicy(
        _within(table, "tolerance", 10, Decimal(1), zero=False),
        points,
        {name: _within(shares, name, 1) for name in shares.data if name in CAUSES},
        _within(table, "follow_through", 1, Decimal(1)),
        _named(table, "struck", asked),
        _named(table, "bonus", asked, whole=True),
        _within(steps, "problem", _MOST_POINTS, Decimal(0)),
        _within(steps, "total", _MOST_POINTS, Decimal(0)),
        tuple(scale),
    )
    for inner in (steps, table):
        inner.finish()
    return policy


def _within(table: Table, name: str, most: int, usual: Decimal = Decimal(0), zero: bool = True) -> Decimal:
    """A number from 0 to ``most``; 0 itself only if ``zero`` is among them."""
    found = table.number(name, usual)
    if not found.is_finite() or not 0 <= found <= most or not (found or zero):
        expected = f"expected a number from 0 to {most}" if zero else f"expected a number above 0, at most {most}"
        table.problem(expected, name, found)
        return usual
    return found


def _points(table: Table, asked: Mapping[int, frozenset[str] | None]) -> list[tuple[int, Decimal]]:
    found = []
    for name in table.data:
        if not name.isdecimal() or int(name) not in asked:
            table.problem("the exam has no such problem", name, table.data[name], _numbers(asked))
            continue
        found.append((int(name), _within(table, name, _MOST_POINTS)))
    return found


def _named(table: Table, name: str, asked: Mapping[int, frozenset[str] | None], whole: bool = False) -> frozenset[str]:
    """Problems by their numbers, and answers as ``2.a_B`` unless only whole problems are meant."""
    found: Any = table.strings(name) if name in table.data else ()
    table.expect(name)
    for text in found:
        number, _, quantity = text.partition(".")
        if not number.isdecimal() or int(number) not in asked:
            table.problem("the exam has no such problem", name, text, _numbers(asked))
        elif text.endswith("."):
            table.problem("expected a problem or an answer", name, text, f'write "{number}" or "{number}.v_B"')
        elif quantity and whole:
            table.problem("expected the number of a problem", name, text, f'write "{number}"')
        elif quantity and (known := asked[int(number)]) is not None and quantity not in known:
            table.problem("the problem asks for no such quantity", name, text, nearest(quantity, known))
    return frozenset(f"{int(n)}{dot}{q}" for n, dot, q in (text.partition(".") for text in found) if n.isdecimal())


def _numbers(asked: Mapping[int, frozenset[str] | None]) -> str:
    return "the problems are " + ", ".join(map(str, sorted(asked)))
