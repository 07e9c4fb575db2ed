"""What joints, drivers and rigid bodies say of the coordinates of a mechanism.

A joint or driver has a module of the same stem here (they are discovered) with one or both of two functions:
``prepare(model, constraint, template)`` says what is known or constant at once, ``state(model, constraint, template)``
adds equations. ``template`` is the entry of the family for a driver, None for a joint.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from variantgen.methods.equations.body import state_body

if TYPE_CHECKING:
    from variantgen.families.family import Template
    from variantgen.mechanism.rows import Constraint
    from variantgen.methods.coordinate_model import Model

PREPARE, STATE = "prepare", "state"

__all__ = ["PREPARE", "STATE", "contribute", "state_body"]


def contribute(stage: str, model: Model, constraint: Constraint, template: Template | None) -> None:
    """Let a joint or driver say what it has to say at a stage. ImportError if it has no module."""
    stem = type(constraint).__module__.rpartition(".")[2]
    module: Any = importlib.import_module(f"{__name__}.{stem}")
    if hasattr(module, stage):
        getattr(module, stage)(model, constraint, template)
