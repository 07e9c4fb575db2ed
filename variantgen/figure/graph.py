"""Graphs on a grid: an empty one to draw in, and the same with its curve; put below the figure of a statement.

The curve is that of a quantity over a turn of the crank, by the angle that the crank has turned from the position
shown, with the angular velocity of the instant.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from typing import TypeAlias

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity, split_name
from variantgen.families.rate_graphs import grid_of
from variantgen.figure.drawing import BOLD, LETTER, MEDIUM, THIN, Drawing, Label, Layer, Line, Path
from variantgen.figure.letters.lettering import typeset
from variantgen.figure.sketch import moved
from variantgen.mechanism.motion import Field
from variantgen.mechanism.turn.crank_turn import FULL_TURN, crank_turn
from variantgen.variants.variant import Variant, is_speeding_up, solve_variants
from variantgen.wording.formula import Formula, FormulaList, Measured, Symbol, to_plain
from variantgen.wording.language import Language

_WIDTH, _HEIGHT, _GAP = 84.0, 46.0, 4.0  # u: of the grid, and the gap to what is above it
_TURN, _LINES, _NUMBERS = 360, 30, 60  # degrees: the whole way, between lines, between numbers
_MOST = 5  # lines of the grid above zero
_SAMPLES = 181
_CLEAR = 1.2  # u between the grid and its numbers
_HAIR, _RULE = 0.25 * THIN, 0.6 * THIN  # lines of a grid, which no curve is taken for: without and with a number
_BEYOND, _HEAD = 4.0, 2.2  # u: of an axis beyond its grid, and its head


_Parts: TypeAlias = tuple[list[Line], list[Label]]


class TurnCurve(Struct, frozen=True):
    """A quantity over a turn, shape (K,) in its printed unit: what a grid is made for."""

    quantity: Quantity
    values: Field
    symbol: Formula
    unit_name: str


def turn_curve(variant: Variant, name: str, language: Language) -> TurnCurve:
    """The curve of a quantity. Raises InputError where the crank of the variant cannot make the turn."""
    quantity = split_name(name)
    turn = crank_turn(solve_variants([variant], max(1, quantity.order)), quantity.order)
    if not turn.complete[0]:
        remedy = "change the data, or sketch nothing"
        raise InputError(Problem("the crank cannot make a full turn", key="sketch", value=name, remedy=remedy))
    angles = np.linspace(0.0, FULL_TURN, _SAMPLES)
    found = quantity.value(turn.at(np.zeros(_SAMPLES, dtype=np.intp), angles))
    own = quantity.unit(variant.family.length_unit)
    symbol = language.quantity(quantity, variant.form.symbols)
    return TurnCurve(quantity, own.from_si(found), symbol, own.name)


class _Axis(Struct, frozen=True):
    """From ``low`` to ``high`` on so much paper (u), with a line each ``step``, each ``every``-th with its number."""

    low: Decimal
    high: Decimal
    step: Decimal
    every: int
    length: float

    def at(self, value: float) -> float:
        return (value - float(self.low)) / float(self.high - self.low) * self.length

    @property
    def lines(self) -> list[tuple[Decimal, bool]]:
        """The values with lines, and whether the number stands there: counted from zero."""
        first, last = int(self.low / self.step), int(self.high / self.step)
        return [(k * self.step, k % self.every == 0) for k in range(first, last + 1)]


def _grid(across: _Axis, up: _Axis, titles: tuple[Formula, Formula], degrees: bool, language: Language) -> _Parts:
    """Lines and labels of a grid; ``titles`` are those of the axes, the one upwards first."""
    lines: list[Line] = []
    labels: list[Label] = []
    top, right = complex(0, up.length), complex(across.length, 0)
    for value, numbered in across.lines:
        foot = complex(across.at(float(value)), 0)
        lines.append(_rule(foot, foot + top, numbered and across.every > 1))
        if numbered:
            plain = language.decimal(value)
            number = Measured(plain, language.unit(unit("deg"))) if degrees else plain
            labels.append(_label(number, foot - 1.5j * _CLEAR, -0.5 - 1j))
    for value, numbered in up.lines:
        foot = complex(0, up.at(float(value)))
        lines.append(_rule(foot, foot + right, numbered and up.every > 1))
        if numbered:
            labels.append(_label(language.decimal(value), foot - _CLEAR, -1 - 0.5j))
    zero = complex(0, up.at(0.0))
    lines += [*_arrow(zero, zero + right + _BEYOND), *_arrow(0j, top + 1j * _BEYOND)]
    labels.append(_label(titles[0], top + 1j * (_BEYOND + 1.5), -0.5 + 0j))
    labels.append(_label(titles[1], right + _BEYOND + 1 + 1.0j, 0j))
    return lines, labels


def _arrow(start: complex, end: complex) -> tuple[Line, Line]:
    """An axis with its head."""
    way = (end - start) / abs(end - start)
    wing = 0.31 * _HEAD * 1j * way
    foot = end - _HEAD * way
    head = Path((end, foot + wing, foot - wing), Layer.LINK, 0.0, closed=True, fill="ink")
    return _line(start, end - 0.8 * _HEAD * way, MEDIUM), head


def grid(curve: TurnCurve, language: Language, drawn: bool) -> Drawing:
    """The grid of a curve with numbers on its axes, empty or with the curve ``drawn``."""
    across = _Axis(Decimal(0), Decimal(_TURN), Decimal(_LINES), _NUMBERS // _LINES, _WIDTH)
    up = _Axis(*_range(curve.values), 1, _HEIGHT)
    lines, labels = _grid(
        across, up, (_titled(curve.symbol, curve.unit_name, language), Symbol("theta")), True, language
    )
    if drawn:
        angles = np.linspace(0.0, _TURN, len(curve.values)).tolist()
        places = zip(map(across.at, angles), map(up.at, curve.values.tolist()), strict=True)
        lines.append(Path(tuple(complex(*place) for place in places), Layer.VECTOR, BOLD))
    return _on_paper(lines, labels, language)


def _titled(symbol: Formula, unit_name: str, language: Language) -> Formula:
    return symbol if unit_name == "1" else FormulaList((symbol, language.unit(unit(unit_name))))


def rate_graph(variant: Variant, language: Language) -> Drawing:
    """The graph of a given rate over time, from which it and its acceleration are read."""
    form = variant.form
    rate, acceleration = (abs(variant.printed[name]) for name in form.figure.graph)
    found = grid_of(rate, acceleration)
    assert found is not None, "families with such data are refused"
    time, step = found
    sign = 1 if is_speeding_up(form, form.values({name: variant.si(name) for name in form.parameters}))[0] else -1
    change = sign * acceleration * time
    high = rate + abs(change)
    every = next(many for many in (1, 2, 5, 10) if high / step <= 7 * many)
    numbered = every * step
    up = _Axis(Decimal(0), math.ceil(high / numbered) * numbered, step, every, _HEIGHT)  # its top has a number
    across = _Axis(Decimal(0), 2 * time, time / 2, 1, _WIDTH)
    parameter = form.parameters[form.figure.graph[0]]
    assert parameter.unit is not None, "a rate has a unit"
    symbol = language.symbol(parameter.symbol, form.symbols)
    seconds = FormulaList((Symbol("t"), language.unit(unit("s"))))
    titles = _titled(symbol, parameter.unit.name, language), seconds
    lines, labels = _grid(across, up, titles, False, language)
    ends = [complex(across.at(0.0), up.at(float(rate - change))), complex(_WIDTH, up.at(float(rate + change)))]
    lines.append(Path(tuple(ends), Layer.VECTOR, BOLD))
    return _on_paper(lines, labels, language)


def below(figure: Drawing, grids: Sequence[Drawing], said: Sequence[str]) -> Drawing:
    """A figure with grids below it, and ``said`` behind its words."""
    for added in grids:
        width = max(figure.width, added.width)
        rise = complex((width - figure.width) / 2, added.height + _GAP)
        aside = complex((width - added.width) / 2, 0.0)
        lines = (*(moved(line, rise) for line in figure.lines), *(moved(line, aside) for line in added.lines))
        labels = [*_shifted(figure.labels, rise), *_shifted(added.labels, aside)]
        turns = tuple(turn._replace(arc=turn.arc._replace(centre=turn.arc.centre + rise)) for turn in figure.rotations)
        figure = replace(
            figure,
            width=width,
            height=figure.height + _GAP + added.height,
            graphs=figure.graphs + _GAP + added.height,
            lines=lines,
            labels=tuple(labels),
            origin=figure.origin + rise,
            rotations=turns,
        )
    tell = figure.tell
    return replace(figure, tell=lambda: " ".join([tell(), *said]))


def with_graphs(figure: Drawing, variant: Variant, language: Language, empty: bool) -> Drawing:
    """The figure of a statement with the graph that gives a rate, and with the ``empty`` grids for curves.

    Raises InputError as ``turn_curve`` does.
    """
    words, hints = language.words("sheet"), variant.form.figure
    added, said = [], []
    if hints.graph:
        added.append(rate_graph(variant, language))
        symbol = language.symbol(variant.form.parameters[hints.graph[0]].symbol, variant.form.symbols)
        said.append(words["rate_graph"].format(symbol=to_plain(symbol)))
    for name in hints.sketch if empty else ():
        curve = turn_curve(variant, name, language)
        added.append(grid(curve, language, False))
        said.append(words["grid"].format(symbol=to_plain(curve.symbol)))
    return below(figure, added, said) if added else figure


def solved_grid(variant: Variant, name: str, language: Language) -> Drawing:
    """The grid with its curve, as the solution shows it."""
    curve = turn_curve(variant, name, language)
    said = language.words("sheet")["curve"].format(symbol=to_plain(curve.symbol))
    return replace(grid(curve, language, True), tell=lambda: said, language=language.name)


def _range(values: Field) -> tuple[Decimal, Decimal, Decimal]:
    """Round limits of an axis with zero inside, and the step of its lines."""
    low, high = min(0.0, float(np.min(values))), max(0.0, float(np.max(values)))
    largest = max(high, -low)
    noise = 1e-9 * largest
    power = math.floor(math.log10(largest / _MOST)) if largest else 0
    steps = [Decimal(s).scaleb(power + k) for k in (0, 1) for s in (1, 2, 5)]
    step = next(s for s in steps if largest <= float(s) * _MOST)
    below_zero, above = math.ceil((-low - noise) / float(step)), math.ceil((high - noise) / float(step))
    return -below_zero * step, max(above, 1 - below_zero) * step, step


def _line(start: complex, end: complex, weight: float) -> Path:
    return Path((start, end), Layer.LINK, weight)


def _rule(start: complex, end: complex, stronger: bool) -> Path:
    """A line of a grid, ``stronger`` where it has a number that others have not."""
    return Path((start, end), Layer.GROUND, _RULE if stronger else _HAIR)


def _label(formula: Formula, at: complex, corner: complex) -> Label:
    """A label whose lower left corner lies by so many of its sizes from a place."""
    size = _size(formula)
    half = complex(*size) / 2
    return Label(formula, at + complex(corner.real * size[0], corner.imag * size[1]) + half, size)


def _size(formula: Formula) -> tuple[float, float]:
    lettering = typeset(formula)
    return lettering.width * LETTER, (lettering.top - lettering.bottom) * LETTER


def _on_paper(lines: Sequence[Line], labels: Sequence[Label], language: Language) -> Drawing:
    """A drawing cut to size."""
    corners = [point for line in lines if isinstance(line, Path) for point in line.points]
    for label in labels:
        half = complex(*label.size) / 2
        corners += [label.at - half, label.at + half]
    low = complex(min(c.real for c in corners) - 1, min(c.imag for c in corners) - 1)
    high = complex(max(c.real for c in corners) + 1, max(c.imag for c in corners) + 1)
    ordered = sorted(lines, key=lambda line: line.layer)
    return Drawing(
        high.real - low.real,
        high.imag - low.imag,
        tuple(moved(line, -low) for line in ordered),
        tuple(_shifted(labels, -low)),
        language=language.name,
    )


def _shifted(labels: Sequence[Label], by: complex) -> list[Label]:
    arrows = [None if x.arrow is None else (x.arrow[0] + by, x.arrow[1] + by) for x in labels]
    return [x._replace(at=x.at + by, arrow=arrow) for x, arrow in zip(labels, arrows, strict=True)]
