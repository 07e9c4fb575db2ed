"""Points that conditions place together, to many digits: Newton's method, from the picture on.

What the picture leaves of the conditions is taken back to nothing along a straight way, in short steps; only the branch
depends on that, so the way is gone with few digits. The last steps carry all digits. Derivatives are differences.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from variantgen.accuracy.precise import DIGITS, many_digits
from variantgen.accuracy.reference.definitions import definition
from variantgen.accuracy.reference.exact_scene import kind
from variantgen.accuracy.reference.linear import Factors
from variantgen.accuracy.reference.positions import NoSuchPointError
from variantgen.mechanism.scene import Scene

_STEPS = 40
_WAY_DIGITS = 25
_POLISH = 10


def place_together(
    scene: Scene, names: tuple[str, ...], at: Mapping[str, Any], guess: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """Places of the named points, where all conditions hold. ``at`` holds the other points and the picture.

    A ``guess`` that is nearly right spares the way from the picture. Raises NoSuchPointError where the way ends.
    """
    search = _Search(scene, names, at)
    if guess is not None:
        return search.polished({name: guess[name] for name in names})
    with many_digits(_WAY_DIGITS):
        z = search.way({name: at[name] for name in names})
    return search.polished(z)


class _Search:
    """Newton's method on the conditions of a scene."""

    def __init__(self, scene: Scene, names: tuple[str, ...], at: Mapping[str, Any]) -> None:
        self.scene, self.names, self.at = scene, names, dict(at)

    def left(self, z: Mapping[str, Any]) -> list[Any]:
        """What is left of the conditions (m)."""
        places = {**self.at, **z}
        found: list[Any] = []
        for condition in self.scene.conditions:
            equations = definition(kind(condition))
            assert equations is not None, "a test sees to it that every kind has one"
            found += equations(condition, places)
        return found

    def step(self, z: Mapping[str, Any], wanted: list[Any], step: Any) -> tuple[dict[str, Any], Any]:
        """One step of Newton's method towards ``left(z) = wanted``, and its length."""
        now = self.left(z)
        columns = []
        for name in self.names:
            for way in (step, 1j * step):
                beside = self.left({**z, name: z[name] + way})
                columns.append([(after - before) / step for after, before in zip(beside, now, strict=True)])
        change = Factors([list(row) for row in zip(*columns, strict=True)]).solve(
            [w - x for w, x in zip(wanted, now, strict=True)]
        )
        moved = {name: z[name] + change[2 * k] + 1j * change[2 * k + 1] for k, name in enumerate(self.names)}
        return moved, max(abs(x) for x in change)

    def way(self, z: dict[str, Any]) -> dict[str, Any]:
        """From the picture to nearly where the conditions hold."""
        start = self.left(z)
        size = self.size(z)
        if max(abs(x) for x in start) < 1e-3 * size:
            return z
        for k in range(1, _STEPS + 1):
            wanted = [x * (_STEPS - k) / _STEPS for x in start]
            for _ in range(2):
                z, length = self.step(z, wanted, size * 1e-12)
                if length > size:
                    raise NoSuchPointError("the way from the picture ends")
        return z

    def size(self, z: Mapping[str, Any]) -> Any:
        """Largest distance of a point from the first."""
        first = z[self.names[0]]
        return max(abs(x - first) for x in {**self.at, **z}.values())

    def polished(self, z: Mapping[str, Any]) -> dict[str, Any]:
        """With all digits."""
        with many_digits(DIGITS) as mp:
            size = self.size(z)
            found = dict(z)
            for _ in range(_POLISH):
                found, length = self.step(found, [mp.mpf(0)] * len(self.scene.conditions), size * mp.mpf(10) ** -35)
                if length < size * mp.mpf(10) ** (10 - DIGITS):
                    return found
        raise NoSuchPointError("the conditions cannot be met near the picture")
