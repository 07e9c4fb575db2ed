"""Work that outputs leave to whoever is there to do it: this process, or others on the same disk."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

# Applies a function of a module to things that can be sent to other processes; what it returns comes in the order of
# the things, as that of ``map`` does, which is one.
Run = Callable[[Callable[[Any], Any], Iterable[Any]], Iterable[Any]]
