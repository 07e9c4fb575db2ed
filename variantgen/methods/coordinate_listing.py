"""A short program of the coordinate method: constraint equations, their derivatives by numbers, what is asked.

Comments are keys of sentences, ``#{listing.data}``, which the language of the document replaces. Derivatives are exact
to rounding: the first by a step in the imaginary direction, the second by Cauchy's formula on a small circle.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator

from variantgen.methods import coordinate_outputs as outputs
from variantgen.methods.algebra import added
from variantgen.methods.coordinate_blocks import Block, given_coordinates
from variantgen.methods.coordinate_model import Coordinate, Model
from variantgen.methods.expression import Expression, Value
from variantgen.methods.program import identifier, number, written
from variantgen.methods.settle import in_order, parts
from variantgen.methods.step import Listing

_WIDTH = 100
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


def listing(model: Model, blocks: list[Block], targets: list[Value]) -> Listing:
    """The program for what is asked; it prints a line ``name = number`` per quantity, in the printed units."""
    writer = _Program(model, blocks, targets)
    return Listing("\n".join(writer.lines()) + "\n", ())


class _Program:
    """Collects the variables and lines of a program."""

    def __init__(self, model: Model, blocks: list[Block], targets: list[Value]) -> None:
        self.model = model
        self.given = given_coordinates(model, blocks, targets)
        self.free = [own for block in blocks for own in block.unknowns]
        self.coordinates = [*self.given, *self.free]
        self.equations = [e for block in blocks for e in block.equations]
        self.names = {own.place: identifier(own.place.name) for own in self.coordinates if own.place.name}

    def lines(self) -> Iterator[str]:
        """The whole program."""
        body = [self._row(added((1, e.left), (-1, e.right))) for e in self.equations]
        given = [self._given(own) for own in self.given]
        asked = outputs.lines(self.model, self.names)
        yield "import numpy as np"
        yield ""
        yield "#{listing.data}"
        yield from self._data(asked)
        yield "#{listing.start}"
        names = [self.names[own.place] for own in self.coordinates]
        yield from _wrapped(f'names = "{" ".join(names)}".split()', "        ")
        yield from _wrapped(f"q = np.array([{', '.join(map(self._start, self.coordinates))}])", "    ")
        yield ""
        yield ""
        yield "#{listing.equations}"
        yield "def f(q, t):"
        yield from _wrapped(f"    {', '.join(names)}{',' if len(names) == 1 else ''} = q", "        ")
        yield "    return np.array(["
        for row in (*given, *body):
            yield from _wrapped(f"        {row},", "            ")
        yield "    ])"
        yield ""
        yield ""
        yield from _SOLVER.splitlines()
        yield "V = dict(zip(names, v))"
        if self.model.task.order == 2:
            yield from _ACCELERATIONS.replace("SCALE", number(self._pace())).splitlines()
            yield "A = dict(zip(names, a))"
        yield "#{listing.answers}"
        yield "Q = dict(zip(names, q))"
        yield from asked

    def _row(self, expression: Expression | None) -> str:
        return "0*t" if expression is None else written(expression, self.names)

    def _given(self, own: Coordinate) -> str:
        """``phi - (phi_0 + omega t + epsilon t^2/2)``."""
        name, rates = self.names[own.place], ""
        for source, power in ((own.speed, "*t"), (own.gain, "*t**2/2")):
            assert source.expression is not None
            if source.exact:
                text = written(source.expression, self.names)
                sum_like = " " in text
                rates += f" - ({text}){power}" if sum_like or text.startswith("-") else f" - {text}{power}"
        start = own.place.exact
        return f"{name}{f' - {number(start, own.place.measure)}' if start else ''}{rates}"

    def _start(self, own: Coordinate) -> str:
        rough = float(f"{own.place.exact:.{_ROUGH}g}")
        return number(rough, own.place.measure) if rough else "0"

    def _pace(self) -> float:
        """About how fast the mechanism turns (rad/s), with one digit: the step in time is a part of a turn."""
        book = self.model.book
        now = book.task.now
        pace = max([abs(v) for v in now.v.values()]) / book.task.size
        pace = max([pace, *(abs(rate) for rate in now.omega.values()), 1e-6])
        return float(f"{pace:.0e}")

    def _data(self, asked: list[str]) -> Iterator[str]:
        """The given data and constant coordinates that the equations use, as variables."""
        sides = [side for e in self.equations for side in (e.left, e.right) if side is not None]
        sides += [s.expression for own in self.given for s in (own.speed, own.gain) if s.expression is not None]
        values = in_order(value for side in sides for value in parts(side))
        text = "\n".join(asked)
        for value in values:
            if value in self.names or value.name is None:
                continue
            name = identifier(value.name)
            if name not in self.names.values():
                self.names[value] = name
                yield f"{name} = {self._source(value)}"
        for name, value in outputs.constants(self.model):
            if name in text and name not in self.names.values():
                yield f"{name} = {number(value)}"

    def _source(self, value: Value) -> str:
        """A number, or how it follows from what is defined already."""
        if value.expression is not None and value.expression is not value:
            used = parts(value.expression)
            if used and all(part in self.names and part not in self.model.coordinates for part in used):
                return written(value.expression, self.names)
        return number(value.exact, value.measure)


def _wrapped(line: str, indent: str) -> list[str]:
    """A long line in several, at spaces."""
    return textwrap.wrap(line, _WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False,
                         drop_whitespace=True, initial_indent="") if len(line) > _WIDTH else [line]
