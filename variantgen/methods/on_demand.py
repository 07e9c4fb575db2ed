"""Functions of methods that are loaded when they are first called: a problem needs few of all methods."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any


def on_demand(module: str, function: str) -> Callable[..., Any]:
    """The named function of a module below ``variantgen.methods``, as a function that loads it when called."""

    @cache
    def loaded() -> Callable[..., Any]:
        found: Callable[..., Any] = getattr(import_module(f"variantgen.methods.{module}"), function)
        return found

    def call(*arguments: Any) -> Any:
        return loaded()(*arguments)

    return call
