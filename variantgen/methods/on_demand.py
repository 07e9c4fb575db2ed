"""Functions of methods that are loaded when they are first called: a problem needs few of all methods."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any


def on_demand(module: str, function: str) -> Callable[..., Any]:
    """The named function of a module below ``variantgen.methods``, as a function that loads it when called."""

    def call(*arguments: Any) -> Any:
        return getattr(import_module(f"variantgen.methods.{module}"), function)(*arguments)

    return call
