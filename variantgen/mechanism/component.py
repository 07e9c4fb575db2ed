"""What constructions, joints and drivers have in common: typed fields that a family file can fill.

A component is a frozen Struct in a module of its own; the module's name is its kind. The annotations of its
fields say what a family file may write there, so that reading, checking and documenting need no second table.
"""

from __future__ import annotations

import importlib
from functools import cache
from types import ModuleType
from typing import Annotated, Any, TypeAlias, get_args, get_origin, get_type_hints

from msgspec import Struct

from variantgen.mechanism.arithmetic import Real
from variantgen.resources import module_names


class Ref(str):
    """Annotation of a field that names a ``point`` or a ``body``."""


class Dim(str):
    """Annotation of a numeric field: its dimension, a key of :data:`DIMENSIONS`."""


class NamedValues(tuple[tuple[str, float], ...]):
    """Annotation of a numeric field that may also be written as one of a few words."""


class WordMeaning(str):
    """Annotation of a field whose words need an explanation."""


class LowerBound(str):
    """Annotation of a numeric field that must be ``above 0`` or ``not negative``."""


# Exponents of length and time. A plane angle counts as a number, as in the SI.
DIMENSIONS: dict[str, tuple[int, int]] = {
    "length": (1, 0),
    "angle": (0, 0),
    "number": (0, 0),
    "angular velocity": (0, -1),
    "angular acceleration": (0, -2),
    "velocity": (1, -1),
    "acceleration": (1, -2),
    "time": (0, 1),
}

PointName: TypeAlias = Annotated[str, Ref("point")]
BodyName: TypeAlias = Annotated[str, Ref("body")]
Length: TypeAlias = Annotated[Real, Dim("length")]
Size: TypeAlias = Annotated[Real, Dim("length"), LowerBound("above 0")]
Radius: TypeAlias = Annotated[Real, Dim("length"), LowerBound("not negative")]
Angle: TypeAlias = Annotated[Real, Dim("angle")]
Ratio: TypeAlias = Annotated[Real, Dim("number")]
AngularVelocity: TypeAlias = Annotated[Real, Dim("angular velocity")]
AngularAcceleration: TypeAlias = Annotated[Real, Dim("angular acceleration")]
Velocity: TypeAlias = Annotated[Real, Dim("velocity")]
Acceleration: TypeAlias = Annotated[Real, Dim("acceleration")]
Side: TypeAlias = Annotated[Real, Dim("number"), NamedValues((("left", 1.0), ("right", -1.0)))]
Sense: TypeAlias = Annotated[Real, Dim("number"), NamedValues((("ahead", 1.0), ("behind", -1.0)))]


class FieldSpec:
    """One field of a component: name, what it refers to or its dimension, words, and whether it is needed."""

    def __init__(self, name: str, hint: Any, required: bool) -> None:
        marks = [mark for leaf in _leaves(hint) for mark in getattr(leaf, "__metadata__", ())]
        self.name = name
        self.required = required
        self.ref = next((str(mark) for mark in marks if isinstance(mark, Ref)), "")
        self.dimension = next((str(mark) for mark in marks if isinstance(mark, Dim)), "")
        self.least = next((str(mark) for mark in marks if isinstance(mark, LowerBound)), "")
        self.means = next((str(mark) for mark in marks if isinstance(mark, WordMeaning)), "")
        self.words = dict(next((mark for mark in marks if isinstance(mark, NamedValues)), ()))
        self.part = _part(hint)
        self.many = get_origin(hint) is tuple and self.part is None
        self.flag = hint is bool

    @property
    def expects(self) -> str:
        """What a family file may write here, in words."""
        if self.part:
            return "a list of tables with the fields " + ", ".join(spec.name for spec in field_specs(self.part))
        if self.flag:
            return "true or false"
        if self.ref:
            return f"a list of two {self.ref}s" if self.many else f"the name of a {self.ref}"
        words = " or ".join(f'"{word}"' for word in self.words)
        if words:
            return f"{words} ({self.means})" if self.means else words
        return f"a number or an expression ({self.dimension}{', ' if self.least else ''}{self.least})"


def _leaves(hint: Any) -> list[Any]:
    if get_origin(hint) is Annotated:
        return [hint]
    return [leaf for part in get_args(hint) for leaf in _leaves(part)]


def _part(hint: Any) -> type[Struct] | None:
    """The Struct of which a field holds a list, if it does: ``tuple[Bend, ...]``."""
    inner = get_args(hint)
    is_part = get_origin(hint) is tuple and isinstance(inner[0], type) and issubclass(inner[0], Struct)
    return inner[0] if is_part else None


def parts(component: Any) -> list[Any]:
    """A component and the parts it is made of (the bends of a rope, say)."""
    kind: type = type(component)
    inner = [part for spec in field_specs(kind) if spec.part for part in getattr(component, spec.name)]
    return [component, *inner]


@cache
def field_specs(component: type[Struct]) -> tuple[FieldSpec, ...]:
    """The fields of a component class, in order, with their meaning read from the annotations."""
    hints = get_type_hints(component, include_extras=True)
    names = component.__struct_fields__
    return tuple(
        FieldSpec(name, hints[name], place < len(names) - len(component.__struct_defaults__))
        for place, name in enumerate(names)
    )


@cache
def discover(package: str) -> dict[str, type[Struct]]:
    """Component classes of a package, by kind (= module name), in alphabetical order.

    Every public module of the package defines exactly one public Struct (besides the parts it is made of); there is
    no list to edit. Raises TypeError for a module without one, or with several.
    """
    home: ModuleType = importlib.import_module(package)
    found: dict[str, type[Struct]] = {}
    for kind in module_names(home.__path__):
        if kind.startswith("_"):
            continue
        module = importlib.import_module(f"{package}.{kind}")
        own = [
            item
            for name, item in vars(module).items()
            if isinstance(item, type)
            and issubclass(item, Struct)
            and not name.startswith("_")
            and item.__module__ == module.__name__
        ]
        if len(own) > 1:
            own = [item for item in own if item not in {spec.part for other in own for spec in field_specs(other)}]
        if len(own) != 1:
            raise TypeError(f"{module.__name__} must define exactly one public Struct, not {len(own)}")
        found[kind] = own[0]
    return found
