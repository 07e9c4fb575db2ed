"""Data changed in a way of which it is known what becomes of the motion."""

from __future__ import annotations

from typing import Any

import numpy as np
from msgspec.structs import replace

from variantgen.mechanism.component import DIMENSIONS, FieldSpec
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene, with_numbers
from variantgen.variants.variant import Variant


def rescaled(scene: Scene, length: float = 1.0, time: float = 1.0) -> Scene:
    """The scene with every length times ``length`` and every time times ``time``; -1 as ``time`` turns the motion back.

    A velocity changes by ``length / time``, an angular acceleration by ``1 / time^2``, an angle not at all. What
    becomes of the motion is told by :func:`variantgen.testing.scaling`.
    """

    def change(_: int, value: Any, field: FieldSpec) -> Any:
        return value * _factor(DIMENSIONS[field.dimension], length, time)

    return with_numbers(scene, change)


def parameters(variant: Variant, length: float = 1.0, time: float = 1.0) -> dict[str, float]:
    """The parameters of a variant and what follows from them, in SI, for a solver of your own; rescaled if wanted.

    Choices are numbers (of a side, left 1 and right -1).
    """
    given = {
        name: variant.si(name) * (_factor(p.unit.dimension, length, time) if p.unit else 1.0)
        for name, p in variant.form.parameters.items()
    }
    return {name: float(np.real(value)) for name, value in variant.form.values(given).items()}


def mirrored(scene: Scene) -> Scene:
    """The scene as a mirror along the x axis of the paper shows it: what was above is below."""
    turn = -np.conj(scene.frame.turn)
    return replace(scene, frame=Frame(turn, -np.asarray(scene.frame.sense, dtype=float)))


def _factor(dimension: tuple[int, int], length: float, time: float) -> float:
    return float(length ** dimension[0] * time ** dimension[1])
