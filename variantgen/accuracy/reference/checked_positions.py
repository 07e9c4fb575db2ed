"""Positions of one variant to many digits, from its points' definitions alone, checked by substitution."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from variantgen.accuracy.precise import mpmath
from variantgen.accuracy.reference.definitions import definition
from variantgen.accuracy.reference.exact_scene import kind
from variantgen.accuracy.reference.positions import NoSuchPointError, construction
from variantgen.accuracy.reference.simultaneous_positions import place_together
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.placing_order import placing_order

# Of the size of the mechanism: what a definition may leave open. A needle triangle costs half of the digits carried.
_LEFT = 1e-60


def positions(scene: Scene, guess: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Places of all points in the frame of an exact scene (m).

    ``guess``: places nearly right, for the points that conditions place together. Raises NoSuchPointError where the
    variant does not assemble.
    """
    first, together, later = placing_order(scene)
    at: dict[str, Any] = {}
    for name in (*first, *together):
        at[name] = _placed(scene.points[name], at)
    if together:
        at.update(place_together(scene, together, at, guess))
    for name in later:
        at[name] = _placed(scene.points[name], at)
    return at


def on_paper(scene: Scene, at: Mapping[str, Any]) -> dict[str, Any]:
    """Places on paper: mirrored where the frame's sense is -1, then turned."""
    turn, sense = scene.frame.turn.value, scene.frame.sense.value
    return {name: turn * (sense * z.real + 1j * z.imag) for name, z in at.items()}


def check_substituted(scene: Scene, at: Mapping[str, Any]) -> None:
    """Put the places into the definitions. Raises ArithmeticError where one is not met to 60 digits of the size."""
    middle = sum(at.values()) / len(at)
    size = max(abs(z - middle) for z in at.values()) or mpmath().mpf(1)
    left: list[Any] = []
    for name, item in scene.points.items():
        equations = definition(kind(item))
        assert equations is not None, "a test sees to it that every kind has one"
        left += equations(item, at[name], at)
    for condition in scene.conditions:
        equations = definition(kind(condition))
        assert equations is not None, "a test sees to it that every kind has one"
        left += equations(condition, at)
    worst = max((abs(x) for x in left), default=0)
    if worst > _LEFT * size:
        raise ArithmeticError(f"the reference misses its own definitions by {mpmath().nstr(worst / size, 3)}")


def _placed(item: Any, at: Mapping[str, Any]) -> Any:
    place = construction(kind(item))
    assert place is not None, "a test sees to it that every kind has one"
    return place(item, at)


__all__ = ["NoSuchPointError", "check_substituted", "on_paper", "positions"]
