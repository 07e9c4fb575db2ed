"""A short program of the coordinate method: constraint equations, their derivatives by numbers, what is asked.

Comments are keys of sentences, ``#{listing.data}``, which the language of the document replaces. Derivatives are exact
to rounding: the first by a step in the imaginary direction, the second by Cauchy's formula on a small circle.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.normal_form import added, signed
from variantgen.algebra.python_source import enclosed, identifier, number, written, written_angle
from variantgen.algebra.values import in_order, parts
from variantgen.methods.coordinates import listing_results
from variantgen.methods.coordinates.blocks import CoordinateBlock, given_coordinates
from variantgen.methods.coordinates.coordinate import Coordinate
from variantgen.methods.coordinates.model import Model
from variantgen.methods.steps.step import ProgramListing

_WIDTH = 100
_PAIR = 80  # columns of two equations in a line
_ABREAST = 4  # numbers in a line of data
_ROUGH = 4  # digits of the coordinates from which the program starts

_SOLVER = """\

#{listing.derivative}
def rate(g):
    return g(1e-20j).imag / 1e-20
def jacobian(q):
    return np.array([rate(lambda s: f(q + s*e, 0)) for e in np.eye(len(q))]).T

#{listing.positions}
for _ in range(20):
    q = q - np.linalg.solve(jacobian(q), f(q, 0))
#{listing.velocities}
v = np.linalg.solve(jacobian(q), -rate(lambda t: f(q, t)))
"""

_ACCELERATIONS = """\
#{listing.accelerations}
circle = 0.1/SCALE*np.exp(2j*np.pi*np.arange(12)/12)
bend = 2*np.mean([f(q + v*t, t)/t**2 for t in circle], axis=0).real
a = np.linalg.solve(jacobian(q), -bend)
"""


def listing(model: Model, blocks: list[CoordinateBlock], targets: list[Value]) -> ProgramListing:
    """The program for what is asked; it prints a line ``name = number`` per quantity, in the printed units."""
    writer = _Program(model, blocks, targets)
    return ProgramListing("\n".join(writer.lines()) + "\n", ())


class _Program:
    """Collects the variables and lines of a program."""

    def __init__(self, model: Model, blocks: list[CoordinateBlock], targets: list[Value]) -> None:
        self.model = model
        self.given = given_coordinates(model, blocks, targets)
        self.free = [own for block in blocks for own in block.unknowns]
        self.coordinates = [*self.given, *self.free]
        self.equations = [e for block in blocks for e in block.equations]
        self.names = {own.place: identifier(own.place.name) for own in self.coordinates if own.place.name}

    def lines(self) -> Iterator[str]:
        """The whole program."""
        data = list(self._data())
        asked = listing_results.lines(self.model, self.names)
        yield from ("import numpy as np", "", "#{listing.data}", *data, *self._extra(asked))
        yield from self._start()
        yield from self._function()
        yield from _SOLVER.splitlines()
        if self.model.task.order == 2:
            yield from _ACCELERATIONS.replace("SCALE", number(self._pace())).splitlines()
        yield "#{listing.answers}"
        tables = [f"{table} = dict(zip(names, {table.lower()}))" for table in "QVA" if f'{table}["' in "".join(asked)]
        if tables:
            yield "; ".join(tables)
        for line in asked:
            yield from _wrapped(line, "    ")

    def _start(self) -> Iterator[str]:
        """The unknowns and rough values of them."""
        names = " ".join(self.names[own.place] for own in self.coordinates)
        yield "#{listing.start}"
        yield from _wrapped(f'names = "{names}".split()', "    ")
        yield from _wrapped(f"q = np.array([{', '.join(map(_rough, self.coordinates))}])", "    ")

    def _function(self) -> Iterator[str]:
        """The constraint equations."""
        names = [self.names[own.place] for own in self.coordinates]
        rows = [self._given(own) for own in self.given]
        rows += [self._row(added((1, e.left), (-1, e.right))) for e in self.equations]
        yield from ("", "#{listing.equations}", "def f(q, t):")
        yield from _wrapped(f"    {', '.join(names)}{',' if len(names) == 1 else ''} = q", "        ")
        yield "    return np.array(["
        for row in _paired(rows):
            yield from _wrapped(f"        {row},", "            ")
        yield "    ])"

    def _row(self, expression: Expression | None) -> str:
        return "0*t" if expression is None else written(expression, self.names)

    def _given(self, own: Coordinate) -> str:
        """``phi - (phi_0 + omega t + epsilon t^2/2)``."""
        function = [(1, number(own.place.exact, own.place.measure))] if own.place.exact else []
        for rate, power in ((own.speed, "t"), (own.acceleration, "t**2/2")):
            assert rate.expression is not None
            if rate.exact:
                sign, size = signed(rate.expression)
                function.append((sign, f"{enclosed(size, self.names)}*{power}"))
        if not function:  # at rest, where it counts from
            return self.names[own.place]
        text = "".join((" + " if sign > 0 else " - ") + part for sign, part in function)
        return f"{self.names[own.place]} - ({text.removeprefix(' + ').replace(' - ', '-', text.startswith(' - '))})"

    def _pace(self) -> float:
        """About how fast the mechanism turns (rad/s), with one digit: the step in time is a part of a turn."""
        book = self.model.book
        now = book.task.now
        pace = max([abs(v) for v in now.v.values()]) / book.task.size
        pace = max([pace, *(abs(rate) for rate in now.omega.values()), 1e-6])
        return float(f"{pace:.0e}")

    def _data(self) -> Iterator[str]:
        """The given data and constant coordinates that the equations use, as variables; numbers several in a line."""
        sides = [side for e in self.equations for side in (e.left, e.right) if side is not None]
        sides += [s.expression for own in self.given for s in (own.speed, own.acceleration) if s.expression is not None]
        plain: dict[str, str] = {}
        derived: list[str] = []
        for value in self._constants(value for side in sides for value in parts(side)):
            assert value.name is not None
            name, source = identifier(value.name), self._source(value)
            taken = name in self.names.values()
            self.names[value] = name
            if taken:
                continue
            if self._is_number(value):
                plain[name] = source
            else:
                derived.append(f"{name} = {source}")
        yield from _assigned(plain)
        yield from derived

    def _constants(self, values: Iterable[Value]) -> Iterator[Value]:
        """Named constants, each after those that it follows from."""
        for value in dict.fromkeys(values):
            if value.name is None or value in self.model.coordinates or value in self.names:
                continue
            if not self._is_number(value) and value.expression is not None:
                yield from self._constants(parts(value.expression))
            yield value

    def _is_number(self, value: Value) -> bool:
        """Whether a constant is written as a number: given (in any unit), or not following from given data."""
        if value.expression is None:
            return True
        used = in_order(parts(value.expression))
        names = [part.name for part in used]
        return not used or value.name in names or any(name is None or name.kind != "parameter" for name in names)

    def _extra(self, asked: list[str]) -> Iterator[str]:
        """Constants that only the answers use."""
        for name, value in listing_results.constants(self.model):
            if name in "".join(asked) and name not in self.names.values():
                yield f"{name} = {number(value)}"

    def _source(self, value: Value) -> str:
        """A number, or how it follows from what is defined already."""
        if value.expression is None or self._is_number(value):
            return number(value.exact, value.measure)
        return (written_angle if value.measure == "angle" else written)(value.expression, self.names)


def _paired(rows: list[str]) -> Iterator[str]:
    """Two short equations in a line, as those for x and y of a point."""
    waiting = ""
    for row in rows:
        if waiting.startswith("x_") and row.startswith("y_") and len(waiting) + len(row) < _PAIR:
            yield f"{waiting}, {row}"
            waiting = ""
            continue
        if waiting:
            yield waiting
        waiting = row
    if waiting:
        yield waiting


def _rough(own: Coordinate) -> str:
    """A coordinate with a few digits."""
    rough = float(f"{own.place.exact:.{_ROUGH}g}")
    return number(rough, own.place.measure) if rough else "0"


def _assigned(values: dict[str, str]) -> Iterator[str]:
    """``OA, AB = 40, 111``: several in a line."""
    names = list(values)
    for start in range(0, len(names), _ABREAST):
        part = names[start : start + _ABREAST]
        yield f"{', '.join(part)} = {', '.join(values[name] for name in part)}"


def _wrapped(line: str, indent: str) -> list[str]:
    """A long line in several, at spaces."""
    return (
        textwrap.wrap(
            line,
            _WIDTH,
            subsequent_indent=indent,
            break_long_words=False,
            break_on_hyphens=False,
            drop_whitespace=True,
            initial_indent="",
        )
        if len(line) > _WIDTH
        else [line]
    )
