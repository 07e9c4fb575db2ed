"""Clocks around functions that are named in a table, so that a whole run is divided into stages.

A function is replaced wherever a loaded module holds it by name; modules that are loaded later take the replacement
from its own. What a stage costs is its own time, without that of the stages inside it, so the stages add up to the
whole.
"""

from __future__ import annotations

import functools
import importlib
import importlib._bootstrap
import inspect
import sys
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

IMPORTS = "importing"


class MissingHookError(Exception):
    """A name of the table does not exist."""


@dataclass(frozen=True)
class Hook:
    """A function (``module:name`` or ``module:Class.name``) and the stage that its calls belong to.

    A stage with ``{}`` is completed by the first argument (after ``self``). With ``whole``, all that is called inside
    belongs to the stage, whatever stage it would be by itself; only what is ``apart`` is counted for itself even there.
    """

    stage: str
    place: str
    whole: bool = False
    apart: bool = False


class StageClock:
    """CPU seconds by stage from ``start`` (CPU time of the process) on; ``rest`` is the stage outside all others."""

    def __init__(self, rest: str, start: float) -> None:
        self.spent: Counter[str] = Counter()
        self._running, self._since, self._closed = rest, start, False

    def enter(self, stage: str, hook: Hook) -> tuple[str, bool]:
        """Begin a stage; the answer is what :meth:`leave` wants. Inside a whole stage nothing changes."""
        before = self._running, self._closed
        if hook.apart or not self._closed:
            self._switch(stage)
            self._closed = hook.whole
        return before

    def leave(self, before: tuple[str, bool]) -> None:
        """End a stage."""
        stage, self._closed = before
        if stage != self._running:
            self._switch(stage)

    def finish(self) -> dict[str, float]:
        """Seconds by stage up to now."""
        self._switch(self._running)
        return dict(self.spent)

    def _switch(self, stage: str) -> None:
        now = time.process_time()
        self.spent[self._running] += now - self._since  # type: ignore[assignment]
        self._running, self._since = stage, now


def around_imports(clock: StageClock) -> None:
    """Count the loading of modules, which belongs to no other stage."""
    loader: Any = importlib._bootstrap
    hook = Hook(IMPORTS, "importlib._bootstrap:_find_and_load", whole=True, apart=True)
    loader._find_and_load = _clocked(loader._find_and_load, hook, clock)


def around(hooks: Sequence[Hook], clock: StageClock) -> None:
    """Put clocks around functions. Raises MissingHookError with all names that do not exist."""
    found, missing = [], []
    for hook in hooks:
        try:
            found.append((*_found(hook.place), hook))
        except (ImportError, AttributeError, KeyError):
            missing.append(hook.place)
    if missing:
        raise MissingHookError(f"no longer there: {', '.join(missing)}; correct the table of hooks")
    for owner, name, hook in found:
        function = vars(owner)[name]
        assert not inspect.isgeneratorfunction(function), f"{hook.place} is a generator: its work is done elsewhere"
        clocked = _clocked(function, hook, clock)
        setattr(owner, name, clocked)
        for module in [m for n, m in sys.modules.items() if n.split(".")[0] == "variantgen"]:
            for other in [key for key, value in vars(module).items() if value is function]:
                setattr(module, other, clocked)


def _found(place: str) -> tuple[Any, str]:
    """The module or class that holds a function, and its name there."""
    module, path = place.split(":")
    owner: Any = importlib.import_module(module)
    *classes, name = path.split(".")
    for step in classes:
        owner = getattr(owner, step)
    if not callable(vars(owner)[name]):
        raise AttributeError(place)
    return owner, name


def _clocked(function: Callable[..., Any], hook: Hook, clock: StageClock) -> Callable[..., Any]:
    position = 1 if "." in hook.place.split(":")[1] else 0
    named = "{}" in hook.stage

    @functools.wraps(function, updated=())
    def clocked(*values: Any, **given: Any) -> Any:
        stage = hook.stage.format(values[position]) if named else hook.stage
        before = clock.enter(stage, hook)
        try:
            return function(*values, **given)
        finally:
            clock.leave(before)

    return clocked
