"""A program: the way from the inputs of a scene to its motion, recorded once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property

import numpy as np

from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.program.many_variants import for_many_variants
from variantgen.mechanism.program.one_variant import for_one_variant
from variantgen.mechanism.program.recording import SHAPE, Recorded, Recording
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.memory import LARGE, keep_freed_memory


class MotionProgram:
    """The motion of scenes that differ in their inputs alone: the same numbers to the bit, without the way through
    plan, constructions and joints.

    ``solved`` takes recorded inputs, of the given types, and has their motion. Raises TypeError where it asks for the
    value of one of them.
    """

    def __init__(self, types: Sequence[type], solved: Callable[[Sequence[Recorded]], Motion]) -> None:
        self._types, self._recording = [np.dtype(kind) for kind in types], Recording()
        self._motion = solved([self._recording.input(place, kind) for place, kind in enumerate(types)])

    @cached_property
    def _one(self) -> Callable[..., Motion]:
        return for_one_variant(self._recording, self._motion)

    @cached_property
    def _many(self) -> Callable[..., Motion]:
        return for_many_variants(self._recording, self._motion)

    def motion(self, scene: Scene, inputs: Sequence[Real]) -> Motion | None:
        """The motion of the scene of the inputs, arrays of shape (N,).

        None for other inputs, and for a variant whose numbers numpy alone goes on with: infinite ones, and none.
        """
        shape = np.shape(inputs[0]) if inputs else ()
        if len(shape) != 1 or shape == (0,):
            return None
        for x, dtype in zip(inputs, self._types, strict=True):
            if type(x) is not np.ndarray or x.shape != shape or x.dtype != dtype:
                return None
        if shape != SHAPE:
            if shape[0] >= LARGE:
                keep_freed_memory()
            with np.errstate(all="ignore"):
                return self._many(scene, inputs, *shape)
        try:
            return self._one(scene, inputs)
        except (ArithmeticError, ValueError):
            return None
