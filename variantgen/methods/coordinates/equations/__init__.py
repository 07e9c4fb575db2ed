"""What joints, drivers and rigid bodies say of the coordinates of a mechanism.

A joint or driver has a module of the same stem here (they are discovered) with one or both of two functions:
``prepare(model, constraint, template)`` says what is known or constant at once, ``state(model, constraint, template)``
adds equations. ``template`` is the entry of the family for a driver, None for a joint.
"""

from __future__ import annotations

import importlib
from typing import Any

from variantgen.families.family import ComponentTemplate
from variantgen.mechanism.rows import Constraint
from variantgen.methods.coordinates.equations.body import state_body
from variantgen.methods.coordinates.model import Model
from variantgen.methods.solution.book import Book

PREPARE, STATE = "prepare", "state"


def model_of(book: Book, whole: bool = False) -> Model:
    """The part of the mechanism of a book that leads to what is asked in coordinates, or the ``whole`` mechanism.

    Drivers and joints that make coordinates known come first, then what others say, then rigid bodies. Raises
    LookupError where the geometry of a joint cannot be worked out.
    """
    model, task = Model(book, whole), book.task
    drivers = list(zip(task.scene.drivers, task.form.drivers, strict=True))
    said = [*drivers, *((joint, None) for joint in task.scene.joints)]
    speaking = [(constraint, template) for constraint, template in said if model.is_relevant(constraint)]
    for constraint, template in speaking:
        _contribute(PREPARE, model, constraint, template)
    model.hold_translating()
    for constraint, template in speaking:
        _contribute(STATE, model, constraint, template)
    for body in task.scene.bodies:
        state_body(model, body)
    return model


def _contribute(stage: str, model: Model, constraint: Constraint, template: ComponentTemplate | None) -> None:
    """Let a joint or driver say what it has to say at a stage. ImportError if it has no module."""
    stem = type(constraint).__module__.rpartition(".")[2]
    module: Any = importlib.import_module(f"{__name__}.{stem}")
    if hasattr(module, stage):
        getattr(module, stage)(model, constraint, template)
