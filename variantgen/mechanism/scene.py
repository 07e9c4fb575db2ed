"""A scene: the mechanism of a problem as points, bodies, joints and drivers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import count
from typing import Any, Protocol

import numpy as np
from msgspec import Struct
from msgspec.structs import astuple, replace
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import Complex, Flags, Real
from variantgen.mechanism.component import FieldSpec, field_specs, parts
from variantgen.mechanism.condition import Condition
from variantgen.mechanism.joint import Pair
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.rows import Constraint, Frame


class Construction(Protocol):
    """A way to place a point (see :mod:`variantgen.mechanism.constructions`)."""

    @property
    def failure(self) -> Outcome:
        """The outcome of a variant for which the point does not exist."""
        ...

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether it exists."""
        ...


class SceneInTime(Protocol):
    """The motion of N scenes by laws, in an interval of time: the scene at any of its instants."""

    @property
    def start(self) -> Real:
        """The beginning of the interval (s), of all or of each."""
        ...

    @property
    def end(self) -> Real:
        """The end of the interval (s)."""
        ...

    @property
    def is_by_place(self) -> bool:
        """Whether the interval is stated by its places, so that its length is not told."""
        ...

    @property
    def found(self) -> str:
        """The name of the instant of the problem, if it is found and not given."""
        ...

    @property
    def parameters(self) -> Mapping[str, Real]:
        """What the scenes are made of (SI), the instant by its name among it."""
        ...

    def at(self, variants: NDArray[np.intp], times: NDArray[np.float64]) -> Scene:
        """The scenes of variants at instants (s), shape (M,) each, as one batch."""
        ...

    def take(self, index: NDArray[Any] | int, size: int) -> SceneInTime:
        """The variants chosen by indices, shape (K,), a mask, shape (N,), or a single number."""
        ...


class Scene(Struct, frozen=True):
    """Points by construction, rigid bodies as tuples of their points, joints, drivers, and the frame on paper.

    Numbers inside may be scalars or arrays over the batch (one entry per variant). A point that belongs to several
    bodies is a hinge of them. ``conditions`` place the points that are only said to be ``near`` somewhere.
    ``course`` tells how it moves where laws of time say it for a whole interval.
    Names are checked when the scene is analysed (once for all batches), not when it is made.
    """

    points: Mapping[str, Construction]
    bodies: Mapping[str, tuple[str, ...]]
    joints: tuple[Pair, ...] = ()
    drivers: tuple[Constraint, ...] = ()
    frame: Frame = Frame()
    conditions: tuple[Condition, ...] = ()
    course: SceneInTime | None = None

    @property
    def constraints(self) -> tuple[Constraint, ...]:
        """Joints, then drivers."""
        return (*self.joints, *self.drivers)


def with_numbers(scene: Scene, change: Callable[[int, Any, FieldSpec], Any]) -> Scene:
    """The scene with every number replaced by what ``change(number of its component, value, its field)`` gives.

    Components count in the order of points, joints, drivers, conditions, each before its parts.
    """
    numbers = count()

    def anew(component: Any) -> Any:
        number = next(numbers)
        found: dict[str, Any] = {}
        component_type: type = type(component)
        for spec in field_specs(component_type):
            value = getattr(component, spec.name)
            if spec.dimension and value is not None:
                found[spec.name] = change(number, value, spec)
            elif spec.part:
                found[spec.name] = tuple(anew(part) for part in value)
        return replace(component, **found)

    return Scene(
        {name: anew(item) for name, item in scene.points.items()},
        scene.bodies,
        tuple(anew(item) for item in scene.joints),
        tuple(anew(item) for item in scene.drivers),
        scene.frame,
        tuple(anew(item) for item in scene.conditions),
    )


def references(component: Any, kind: str) -> tuple[str, ...]:
    """Names of the given kind (``point`` or ``body``) that a component refers to, those of its parts included."""
    names: list[str] = []
    for part in parts(component):
        part_type: type = type(part)
        for spec in field_specs(part_type):
            value = getattr(part, spec.name)
            if spec.ref == kind and value is not None:
                names.extend(value if spec.many else (value,))
    return tuple(names)


def fixed_points(scene: Scene) -> set[str]:
    """Points that a joint holds in place by itself."""
    shapes = [shape for joint in scene.joints for shape in joint.shapes()]
    return {shape.given_point for shape in shapes if shape.given_point and not shape.bodies and len(shape.points) == 1}


def label(component: Any) -> str:
    """The name of a joint or driver in messages: its kind and what it acts on, ``guide of B``."""
    named = [item for part in parts(component) for item in astuple(part)]
    named = [item[0] if isinstance(item, tuple) and item else item for item in named]
    first = next((name for name in named if isinstance(name, str)), "nothing")
    kind = type(component).__name__
    words = "".join(" " + letter.lower() if letter.isupper() else letter for letter in kind).strip()
    return f"{words} of {first}"
