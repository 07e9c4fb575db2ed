"""The contacts and threads of a scene, by the modules of :mod:`variantgen.methods.groups.contact_laws`."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Callable
from functools import cache

from variantgen.methods.groups.contact import NoSlipContact
from variantgen.methods.linkage.problem import Task

_HOME = "variantgen.methods.groups.contact_laws"


@cache
def _law(stem: str) -> Callable[[Task, int], NoSlipContact | None] | None:
    """The function ``touch(task, number)`` of a kind of joint."""
    if importlib.util.find_spec(f"{_HOME}.{stem}") is None:
        return None
    found: Callable[[Task, int], NoSlipContact | None] = importlib.import_module(f"{_HOME}.{stem}").contact
    return found


def _law_of(task: Task, number: int) -> Callable[[Task, int], NoSlipContact | None] | None:
    """The function of the kind of a joint of the scene."""
    return _law(type(task.scene.joints[number]).__module__.rpartition(".")[2])


def _touching(task: Task) -> list[int]:
    """The joints of whose kinds there are contacts or threads; the form remembers them."""
    known = task.form.remembered
    if "touching" not in known:
        known["touching"] = [number for number in range(len(task.scene.joints)) if _law_of(task, number) is not None]
    found: list[int] = known["touching"]
    return found


def contact_of(task: Task, number: int) -> NoSlipContact | None:
    """The contact or thread of a joint of the scene (its number), if the joint is one that its law can treat."""
    key = ("contact", number)
    if key not in task.remembered:
        law = _law_of(task, number)
        task.remembered[key] = None if law is None else law(task, number)
    found: NoSlipContact | None = task.remembered[key]
    return found


def contacts_of_scene(task: Task) -> dict[int, NoSlipContact]:
    """All contacts and threads of a scene, by the number of the joint."""
    if "contacts" not in task.remembered:
        every = {number: contact_of(task, number) for number in _touching(task)}
        task.remembered["contacts"] = {number: contact for number, contact in every.items() if contact is not None}
    found: dict[int, NoSlipContact] = task.remembered["contacts"]
    return found
