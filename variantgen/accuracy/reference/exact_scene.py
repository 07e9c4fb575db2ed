"""One variant as a scene of exact numbers: every double is taken for the number that it is."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.accuracy.reference.series import Series, series
from variantgen.mechanism.component import FieldSpec, field_specs
from variantgen.mechanism.motion import take_scene
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene, with_numbers


class SceneNumber(Struct, frozen=True):
    """A number that a scene is given by: which of its components (in the order of :func:`data`) and which field."""

    number: int
    field: str
    value: Any


def exact_scene(scene: Scene, index: int, size: int) -> Scene:
    """The variant at an index of a batch, all numbers as constant series."""
    one = take_scene(scene, index, size)
    frame = Frame(series(one.frame.turn), series(one.frame.sense))
    return replace(with_numbers(one, lambda _, value, __: series(value)), frame=frame)


def double_scene(scene: Scene, index: int, size: int) -> Scene:
    """The same with doubles as the only terms: for the definitions of points in double precision."""
    one = take_scene(scene, index, size)
    frame = Frame(Series((complex(one.frame.turn),)), Series((float(one.frame.sense),)))
    return replace(with_numbers(one, lambda _, value, __: Series((float(value),))), frame=frame)


def wide_scene(scene: Scene) -> Scene:
    """A batch with all numbers in extended double precision (80 bits where the machine has them)."""
    frame = Frame(np.asarray(scene.frame.turn, np.clongdouble), np.asarray(scene.frame.sense, np.longdouble))
    return replace(with_numbers(scene, lambda _, value, __: np.asarray(value, np.longdouble)), frame=frame)


def data(scene: Scene) -> Iterator[SceneNumber]:
    """The numbers of an exact scene that may be perturbed: lengths, angles, ratios, rates; not sides and senses."""
    for number, component in enumerate(_components(scene)):
        for spec in _fields(component):
            if spec.dimension and not spec.words:
                found = getattr(component, spec.name)
                if found is None:
                    continue
                value = found.value
                if value != 0:
                    yield SceneNumber(number, spec.name, value)


def perturbed(scene: Scene, datum: SceneNumber, factor: Any) -> Scene:
    """An exact scene with one of its numbers multiplied by a factor."""

    def change(number: int, value: Series, spec: FieldSpec) -> Series:
        return value * factor if (number, spec.name) == (datum.number, datum.field) else value

    return with_numbers(scene, change)


def kind(component: Any) -> str:
    """The kind of a construction, condition, joint or driver: the name of its module."""
    return type(component).__module__.rsplit(".", 1)[-1]


def _fields(component: Any) -> tuple[FieldSpec, ...]:
    kind_of: type = type(component)
    return field_specs(kind_of)


def _components(scene: Scene) -> Iterator[Any]:
    """All components, the parts of each after it."""
    for component in (*scene.points.values(), *scene.joints, *scene.drivers, *scene.conditions):
        yield component
        for spec in _fields(component):
            if spec.part:
                yield from getattr(component, spec.name)
