"""In which order the points of a scene are placed."""

from __future__ import annotations

from variantgen.errors import InputError, Problem
from variantgen.mechanism.constructions.near import Near
from variantgen.mechanism.scene import Scene, label, references

Order = tuple[str, ...]


def placing_order(scene: Scene) -> tuple[Order, Order, Order]:
    """Points placed by themselves, points placed together by the conditions, points constructed from these.

    Raises InputError for points defined in a circle and for conditions that do not fit the points they should place.
    """
    together = tuple(name for name, item in scene.points.items() if isinstance(item, Near))
    waiting = [name for name in scene.points if name not in together]
    first = _ordered(scene, waiting, ())
    rest = [name for name in waiting if name not in first]
    later = _ordered(scene, rest, (*first, *together)) if together else ()
    stuck = [name for name in rest if name not in later]
    if stuck:
        raise InputError(
            Problem(
                "points are defined through each other in a circle",
                key="points",
                value=" -> ".join(stuck),
                remedy="give one of them by coordinates or from a point outside the circle",
            )
        )
    _check_conditions(scene, together, later)
    return first, together, later


def _ordered(scene: Scene, names: list[str], known: Order) -> Order:
    """The names that can be placed from the known ones, each after those it is constructed from."""
    order: list[str] = []
    waiting = list(names)
    while True:
        done = {*known, *order}
        ready = [name for name in waiting if all(p in done for p in references(scene.points[name], "point"))]
        if not ready:
            return tuple(order)
        order += ready
        waiting = [name for name in waiting if name not in ready]


def _check_conditions(scene: Scene, together: Order, later: Order) -> None:
    wanted, found = 2 * len(together), len(scene.conditions)
    if wanted != found:
        raise InputError(
            Problem(
                f"{len(together)} points placed near somewhere need {wanted} conditions, there are {found}",
                key="conditions",
                value=", ".join(together) or "no such point",
                remedy="one condition (a distance, a line) for each of their coordinates",
            )
        )
    for condition in scene.conditions:
        for name in references(condition, "point"):
            if name in later:
                raise InputError(
                    Problem(
                        "a condition names a point that is constructed from the points it should place",
                        key=f"conditions.{label(condition)}",
                        value=name,
                        remedy='place that point with "near" too and add its conditions',
                    )
                )
