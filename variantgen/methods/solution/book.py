"""The book of a solution: what is known so far of points and bodies, and the steps that found it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from typing import Protocol, cast

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angles import AngleForm
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.rays import Centre
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.methods.steps.step import Derived, Fact, Item, Segment, Sentence, Step, Term

Known = tuple[Term, ...]


class Rate(Struct, frozen=True):
    """An angular velocity or acceleration: its magnitude, and its sense (1 counter-clockwise, -1 clockwise, 0 none)."""

    size: Value
    sense: int

    @property
    def word(self) -> str:
        """The key of the word for the sense."""
        return "clockwise" if self.sense < 0 else "counter_clockwise"


class Graphics(Protocol):
    """The solution of vector equations by drawing, in place of projections."""

    def write(self, book: Book, left: Sequence[Term], right: Sequence[Term], start: int) -> None:
        """Write an equation."""

    def solve(self, book: Book, left: Sequence[Term], right: Sequence[Term], wanted: Sequence[Term]) -> list[Value]:
        """Magnitudes of the wanted vectors, negative against the assumed direction."""

    def compose(self, book: Book, name: Name, terms: Sequence[Term]) -> Known:
        """The sum of known vectors."""

    def size(self, book: Book, name: Name, terms: Known) -> Value:
        """The magnitude of a known vector."""

    def component(self, book: Book, name: Name, terms: Sequence[Term]) -> Expression:
        """A projection (``x`` or ``y`` in the name) of a known vector on an axis of the paper."""


class Book(Struct):
    """Vectors of points as sums of known terms, rates of bodies, and the steps written so far.

    A point at rest has no terms. ``values`` are all that were derived, by name. ``relative``, ``relative_acceleration``
    and ``coriolis`` belong to points that slide on bodies, by (point, body). ``order`` says what is worked out with
    this book: 1 velocities, 2 accelerations; :meth:`at` gives the same book for another one. ``centres`` are the
    velocity (P) and acceleration (Q) centres found so far, by letter and body; ``carry`` is how a further point of a
    body in plane motion is found, if not by the pole formula.
    """

    task: Task
    steps: list[Step] = field(default_factory=list)
    velocity: dict[str, Known] = field(default_factory=dict)
    acceleration: dict[str, Known] = field(default_factory=dict)
    omega: dict[str, Rate] = field(default_factory=dict)
    epsilon: dict[str, Rate] = field(default_factory=dict)
    relative: dict[tuple[str, str], Known] = field(default_factory=dict)
    relative_acceleration: dict[tuple[str, str], Known] = field(default_factory=dict)
    coriolis: dict[tuple[str, str], Known] = field(default_factory=dict)
    values: dict[Name, Value] = field(default_factory=dict)
    order: int = 1
    graphics: Graphics | None = None
    style: MethodStyle = field(default_factory=MethodStyle)
    centres: dict[tuple[str, str], Centre] = field(default_factory=dict)
    carry: Callable[[Book, str, str, str], None] | None = None
    named_angles: dict[AngleForm, Value] = field(default_factory=dict)  # sums of angles that have a name
    geometry: Geometry = cast(Geometry, None)  # that of the task, made at once

    def __post_init__(self) -> None:
        if self.geometry:
            return  # the same book for another order
        self.geometry = Geometry(self.task)
        for point in self.task.fixed:
            self.velocity[point] = self.acceleration[point] = ()

    def at(self, order: int, carry: Callable[[Book, str, str, str], None] | None = None) -> Book:
        """The same book, with all that is written in it now and later, for velocities (1) or accelerations (2)."""
        return replace(self, order=order, carry=carry)

    # What is known, at the order that is worked out.

    @property
    def vectors(self) -> dict[str, Known]:
        """Velocities or accelerations by point."""
        return self.velocity if self.order == 1 else self.acceleration

    @property
    def rates(self) -> dict[str, Rate]:
        """Angular velocities or accelerations by body."""
        return self.omega if self.order == 1 else self.epsilon

    @property
    def letter(self) -> str:
        """``v`` or ``a``."""
        return "v" if self.order == 1 else "a"

    @property
    def measure(self) -> str:
        """The measure of the vectors: velocity or acceleration."""
        return "velocity" if self.order == 1 else "acceleration"

    @property
    def rate_measure(self) -> str:
        """The measure of the rates: angular velocity or angular acceleration."""
        return "angular velocity" if self.order == 1 else "angular acceleration"

    @property
    def scale(self) -> float:
        """Natural scale of the vectors: the largest of the mechanism."""
        return self.task.largest_speed if self.order == 1 else self.task.largest_acceleration

    def exact(self, point: str) -> complex:
        """The solver's vector of a point."""
        now = self.task.now
        return (now.v if self.order == 1 else now.a)[point]

    def exact_rate(self, body: str) -> float:
        """The solver's rate of a body."""
        now = self.task.now
        return (now.omega if self.order == 1 else now.epsilon)[body]

    # Writing.

    def step(self, key: str, *views: str, **facts: Fact) -> Step:
        """A new step with its heading; what is written next belongs to it, for the reader of a method in a block."""
        made = Step(Sentence(key, facts, detail=False), views=views)
        self.steps.append(made)
        return made

    @property
    def items(self) -> list[Item]:
        """The items of the step that is being written."""
        return self.steps[-1].items

    def say(self, key: str, detail: bool = True, /, **facts: Fact) -> None:
        """Add a sentence; a short solution leaves out a ``detail``."""
        self.items.append(Sentence(key, facts, detail))

    def show(self, view: str) -> None:
        """Add a figure to the step that is being written."""
        self.steps[-1].views = (*self.steps[-1].views, view)

    def has_said(self, key: str, /, **facts: Fact) -> bool:
        """Whether a sentence with these facts (and perhaps others) has been said in any step."""
        said = (item for step in self.steps for item in step.items if isinstance(item, Sentence) and item.key == key)
        return any(all(item.facts.get(name) == fact for name, fact in facts.items()) for item in said)

    def derive(self, name: Name, measure: str, expression: Expression, law: Expression | None = None) -> Value:
        """A new value by an expression (and the ``law`` behind it), with the line that shows it."""
        value = Value(name, measure, expression.number(True), expression, self.size_of(measure))
        self.items.append(Derived(value, law=law))
        self.values[name] = value
        return value

    def size_of(self, measure: str) -> float:
        """The natural scale of a measure, below which numbers are rounding."""
        return self.task.scales.get(measure, 0.0)

    def term(self, name: Name, size: Value | None, angle: Value, key: str, **facts: Fact) -> Term:
        """A vector with the reason of its direction (a sentence of the file ``ways``)."""
        return Term(name, size, angle, Sentence(f"ways.{key}", facts))


def along(start: str, end: str) -> dict[str, Fact]:
    """Facts of a way along or across a segment."""
    return {"segment": Segment(start, end)}


def resultant(terms: Sequence[Term]) -> complex:
    """The exact sum of known vectors as a complex number."""
    return sum(
        (cmath.rect(term.size.exact, math.radians(term.angle.exact)) for term in terms if term.size is not None), 0j
    )
