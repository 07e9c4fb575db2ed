"""The solved motion of a batch of variants at the instant of the problem."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
from msgspec import Struct
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene
from variantgen.notebook import display

Field = NDArray[np.float64]
ComplexField = NDArray[np.complex128]


class Motion(Struct, frozen=True):
    """Positions, velocities and accelerations of points and bodies; every array has shape (N,).

    ``z`` (m), ``v`` (m/s), ``a`` (m/s^2) by point; ``omega`` (rad/s), ``epsilon`` (rad/s^2) by body, positive
    counter-clockwise. Orders that were not asked for are empty mappings. ``outcome`` holds an
    :class:`~variantgen.mechanism.outcome.Outcome` per variant. ``transmission`` is the smallest scaled determinant
    of the blocks (1 is best, 0 a dead point): for a dyad of two links the sine of the angle between them, for a
    slider the cosine of the angle between rod and guide.
    """

    scene: Scene
    outcome: NDArray[np.int8]
    transmission: Field
    z: Mapping[str, ComplexField]
    v: Mapping[str, ComplexField]
    a: Mapping[str, ComplexField]
    omega: Mapping[str, Field]
    epsilon: Mapping[str, Field]

    @property
    def size(self) -> int:
        """Number of variants N."""
        return int(self.outcome.size)

    @property
    def solved(self) -> NDArray[np.bool_]:
        """Whether the outcome of a variant is ``SOLVED``, shape (N,)."""
        return np.asarray(self.outcome == 0)

    @property
    def frame(self) -> Frame:
        """The frame of the scene on paper."""
        return self.scene.frame

    def __repr__(self) -> str:
        solved = int(np.count_nonzero(self.solved))
        return f"<Motion of {self.size} ({solved} solved): points {', '.join(self.z)}; bodies {', '.join(self.omega)}>"

    def _repr_html_(self) -> str:
        """What a notebook shows: positions, velocities and accelerations as tables."""
        return display("motion_html", self)

    def length_scale(self) -> Field:
        """Largest distance of a point from the centre of all points (m), shape (N,); of a single point at least 1 m,
        or its distance from the origin, whose rounding its motion shows.
        """
        places = np.array(list(self.z.values()))
        size = np.max(np.abs(places - np.mean(places, axis=0)), axis=0)
        result: Field = np.where(size > 0, size, np.maximum(1.0, np.abs(places[0])))
        return result

    def take(self, index: NDArray[Any]) -> Motion:
        """The variants chosen by indices, shape (K,), or a mask, shape (N,)."""

        def cut(table: Mapping[str, Any]) -> dict[str, Any]:
            return {name: values[index] for name, values in table.items()}

        return replace(
            self,
            scene=take_scene(self.scene, index, self.size),
            outcome=self.outcome[index],
            transmission=self.transmission[index],
            z=cut(self.z),
            v=cut(self.v),
            a=cut(self.a),
            omega=cut(self.omega),
            epsilon=cut(self.epsilon),
        )


def largest_change(
    points: Mapping[str, ComplexField],
    points_again: Mapping[str, ComplexField],
    bodies: Mapping[str, Field],
    bodies_again: Mapping[str, Field],
    length: Field,
    least: Field | float = 0.0,
) -> Field:
    """Largest difference of two tables of velocities or accelerations by the largest of the first, shape (N,).

    Rates of bodies count times the ``length`` of the mechanism. The largest is taken to be ``least`` at least: where
    all are nothing but rounding there is nothing to compare with.
    """
    if not points:
        return np.zeros_like(length)
    scale = np.max([np.abs(points[p]) for p in points] + [np.abs(bodies[b]) * length for b in bodies], axis=0)
    scale = np.maximum(scale, least)
    worst = np.max(
        [np.abs(points[p] - points_again[p]) for p in points]
        + [np.abs(bodies[b] - bodies_again[b]) * length for b in bodies],
        axis=0,
    )
    result: Field = worst / np.where(scale > 0, scale, 1.0)
    return result


def take_scene(scene: Scene, index: NDArray[Any] | int, size: int) -> Scene:
    """A scene with the chosen variants only: arrays of the batch length are indexed, scalars stay."""
    cut = partial(_cut, index=index, size=size)
    return Scene(
        {name: cut(item) for name, item in scene.points.items()},
        scene.bodies,
        tuple(map(cut, scene.joints)),
        tuple(map(cut, scene.drivers)),
        cut(scene.frame),
        tuple(map(cut, scene.conditions)),
        scene.course and scene.course.take(index, size),
    )


def _cut(item: Any, index: NDArray[Any] | int, size: int) -> Any:
    """A part of a scene with the chosen variants only."""
    changes: dict[str, Any] = {}
    for name in item.__struct_fields__:
        value = getattr(item, name)
        if isinstance(value, np.ndarray):
            if value.shape == (size,):
                changes[name] = value[index]
        elif isinstance(value, tuple) and value and isinstance(value[0], Struct):
            changes[name] = tuple(_cut(part, index, size) for part in value)
    return replace(item, **changes) if changes else item
