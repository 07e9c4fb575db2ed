"""The kinds of figures of a variant, one module per kind; found by their file names.

Each module says ``ORDER``, the order of the motion it needs (0 positions, 1 velocities, 2 accelerations), and has a
function ``draw``, which raises InputError where there is nothing of the kind to draw. A figure of the whole mechanism
is drawn by ``draw(variant, motion, index, asked, language)``, one of motion also with the vectors of the solution
beside which it stands: it returns a :class:`~variantgen.figure.drawing.Drawing`. A figure of a part of a solution is
begun by ``draw(subject, vectors, which)`` with a :class:`~variantgen.figure.equations.body_board.FigureSubject`, which
says what is marked there: it returns a figure in the making (:mod:`variantgen.figure.making`), so that the labels of
all figures of a solution are placed together.
"""

from __future__ import annotations

import importlib
from functools import cache
from inspect import signature
from types import ModuleType

from variantgen.errors import InputError, Problem, nearest
from variantgen.resources import module_names


def view_names() -> list[str]:
    """Names of the kinds of figures: ``statement``, ``velocity_plan``, ..."""
    return module_names(__path__)


def is_of_parts(name: str) -> bool:
    """Whether a kind shows one equation, body or chain of a solution, so that a solution may have several."""
    return "which" in signature(view(name).draw).parameters


@cache
def view(name: str) -> ModuleType:
    """The module of one kind. Raises InputError for an unknown name."""
    if name not in view_names():
        raise InputError(Problem("unknown kind of figure", key="view", value=name, remedy=nearest(name, view_names())))
    return importlib.import_module(f"{__name__}.{name}")
