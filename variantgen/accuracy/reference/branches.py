"""On which branch a set of places lies: the side of every construction that has two solutions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from variantgen.accuracy.reference.exact_scene import kind
from variantgen.accuracy.reference.positions import line_ray
from variantgen.mechanism.scene import Scene

# Of the size: a point placed by conditions that is farther off is on another branch.
_FAR = 0.05


def on_branch(scene: Scene, places: Mapping[str, Any], exact: Mapping[str, Any], size: Any) -> bool:
    """Whether places (in the scene's frame, m) lie on the branch that the exact scene asks for.

    A point is compared with the points it is constructed from, as they were found. ``exact`` are the right places.
    """
    for name, item in scene.points.items():
        if name not in places:
            continue
        side = globals().get(f"_of_{kind(item)}")
        if side is not None and not side(item, places[name], places):
            return False
        if side is None and abs(places[name] - exact[name]) > 4 * _FAR * size:
            return False
    return True


def _of_circle_circle(item: Any, z: Any, at: Mapping[str, Any]) -> bool:
    """Left (+1) or right (-1) of the way from the first centre to the second; on it counts as either."""
    if item.first not in at or item.second not in at:
        return True
    return bool(((at[item.second] - at[item.first]).conjugate() * (z - at[item.first])).imag * item.side.value >= 0)


def _of_line_circle(item: Any, z: Any, at: Mapping[str, Any]) -> bool:
    """Ahead (+1) or behind (-1) of the foot of the perpendicular from the centre."""
    if any(name is not None and name not in at for name in (item.centre, item.through, item.towards)):
        return True
    return bool((line_ray(item, at).conjugate() * (z - at[item.centre])).real * item.branch.value >= 0)
