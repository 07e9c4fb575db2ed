"""The figure of a chain of links between fixed pivots: the links as vectors on axes, and below them their graph.

The graph is that of the guide: ``O -1-> A -2-> B -3-> C``, the numbers of the links above the arrows.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from variantgen.errors import InputError, Problem
from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.equations.body_board import HIGH, WIDE, BodyBoard, FigureSubject
from variantgen.figure.making import Making
from variantgen.figure.motion.motion_board import MotionBoard
from variantgen.figure.placement.label_requests import LabelRequest, along_line, around, label_size
from variantgen.methods.steps.step_geometry import ChainGraph
from variantgen.wording.formula import Formula, Number, Symbol

_AXIS = 15.0  # length of an axis, u
_PART = 0.58  # of a link where its arrow head is
_HEAD = 2.6
_BELOW = 9.0  # from the mechanism to its graph, u
_LEG, _GAP = 20.0, 3.6  # from point to point of the graph; from a letter to an arrow, u
_GRAPH = 18.0  # height of the graph, u
_OFF = 1.6  # between an arrow of the graph and the number above it, u


def draw_chain(subject: FigureSubject) -> Making:
    """The figure of the chain of which the step speaks. Raises InputError where it speaks of none."""
    chain = subject.geometry.chain
    if chain is None:
        raise InputError(Problem("the solution has no chain of links", key="view", value="rate_chain"))
    points = [chain.start, *chain.ends]
    bodies = subject.form.bodies
    links = [next(name for name, members in bodies.items() if set(pair) <= set(members)) for pair in pairwise(points)]
    board = BodyBoard(subject, links, points, room=complex(WIDE, HIGH - _GRAPH))
    scale, _ = board.fitted(lambda longest: [(0j, _AXIS), (0j, _AXIS * 1j)], 0.0)
    drawn = board.drawn(scale)
    sketch = drawn.sketch
    for number, (start, end) in enumerate(pairwise(points), 1):
        at, way = sketch.at[start], sketch.at[end] - sketch.at[start]
        tip = at + _PART * way
        sketch.arrow(tip - 2 * _HEAD * way / abs(way), tip, Layer.SLIDER, MEDIUM, _HEAD)
        sketch.label(along_line(Number(str(number)), at, sketch.at[end]))
    for axis, letter in ((1 + 0j, "x"), (1j, "y")):
        sketch.arrow(0j, _AXIS * axis, Layer.MARK, MEDIUM, 2.0)
        sketch.label(around(Symbol(letter), _AXIS * axis, 0.3))
    _draw_graph(drawn, chain)
    return (yield drawn.draft()).drawing


def _draw_graph(board: MotionBoard, chain: ChainGraph) -> None:
    """The graph below what is drawn, in its middle."""
    sketch = board.sketch
    low, high = sketch.corners()
    place = complex(0.5 * (low.real + high.real - _LEG * len(chain.ends)), low.imag - _BELOW)
    _write(board, Symbol(chain.start), place)
    for number, end in enumerate(chain.ends, 1):
        sketch.arrow(place + _GAP, place + _LEG - _GAP, Layer.VECTOR, MEDIUM, 2.0)
        formula = Number(str(number))
        _write(board, formula, place + 0.5 * _LEG + 1j * (_OFF + 0.5 * label_size(formula)[1]))
        place += _LEG
        _write(board, Symbol(end), place)


def _write(board: MotionBoard, formula: Formula, place: complex) -> None:
    """A label at its only place: it names what is below it."""
    below = place - 1j * label_size(formula)[1]
    board.sketch.label(LabelRequest(formula, below, np.array([place]), np.array([0.0])))
