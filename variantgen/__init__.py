"""Individual problem sheets in planar kinematics.

The public names are listed in ``__all__``; they are loaded on first use, so that importing the package is cheap.

>>> import variantgen
>>> variant = variantgen.draw(variantgen.load_family("four_bar"), ["v_B"], [("my seed", "student 1")])[0]
>>> [answer.quantity.name for answer in variantgen.answers(variant, ["v_B"])]
['v_B']
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from variantgen.arrays.batch import batch
    from variantgen.arrays.turn import turn
    from variantgen.builder import build
    from variantgen.errors import InputError, VariantgenError
    from variantgen.exam.roster import Student, read_roster
    from variantgen.families.reading.folders import family_names
    from variantgen.families.reading.load import load_family
    from variantgen.mechanism.scene import Scene
    from variantgen.mechanism.solving.solve import solve
    from variantgen.outputs.single.explanation import explain
    from variantgen.outputs.single.picture import picture
    from variantgen.single import answers, solution_document
    from variantgen.variants.draw import draw
    from variantgen.version import VERSION as __version__  # noqa: N811  (the name that tools look for)

_HOMES = {
    "InputError": "errors",
    "Scene": "mechanism.scene",
    "Student": "exam.roster",
    "VariantgenError": "errors",
    "answers": "single",
    "batch": "arrays.batch",
    "build": "builder",
    "draw": "variants.draw",
    "explain": "outputs.single.explanation",
    "family_names": "families.reading.folders",
    "load_family": "families.reading.load",
    "picture": "outputs.single.picture",
    "read_roster": "exam.roster",
    "solution_document": "single",
    "solve": "mechanism.solving.solve",
    "turn": "arrays.turn",
}

__all__ = [
    "InputError",
    "Scene",
    "Student",
    "VariantgenError",
    "__version__",
    "answers",
    "batch",
    "build",
    "draw",
    "explain",
    "family_names",
    "load_family",
    "picture",
    "read_roster",
    "solution_document",
    "solve",
    "turn",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return importlib.import_module("variantgen.version").VERSION
    if name not in _HOMES:
        raise AttributeError(f"module 'variantgen' has no attribute {name!r}")
    return getattr(importlib.import_module(f"variantgen.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return __all__
