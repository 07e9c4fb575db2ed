"""What a notebook shows of an object, without any dependency: methods like ``_repr_html_`` ask here.

How things look is known to the outputs, above all that can be shown; they are loaded by name when a notebook asks.
"""

from __future__ import annotations

import importlib
from typing import Any

_DISPLAYS = "variantgen.outputs.single.displays"


def display(kind: str, item: Any) -> str:
    """The markup of an object, by the function of this name among the displays of the outputs."""
    found: str = getattr(importlib.import_module(_DISPLAYS), kind)(item)
    return found
