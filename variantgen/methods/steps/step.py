"""Steps of a solution: sentences by key with their facts, and lines of formulas. Nothing here knows a language."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

from msgspec import Struct, field

from variantgen.algebra.expression import Applied, Expression, Value
from variantgen.algebra.name import OWN_AXES, Name
from variantgen.families.quantities import Quantity
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.methods.steps.step_geometry import ChainGraph, StepGeometry


class Body(Struct, frozen=True):
    """A body in a sentence; the template chooses the case: ``{body}``, ``{body.of}``, ``{body.with}``."""

    name: str


class Point(Struct, frozen=True):
    """A point in a sentence."""

    name: str


class Segment(Struct, frozen=True):
    """A segment, line or ray through two points in a sentence: ``AB``; ``centre_of`` makes the second the velocity
    centre of a body.
    """

    start: str
    end: str
    centre_of: str = ""


def triangle(first: str, second: str, third: str, centre_of: str = "") -> Segment:
    """A triangle in a sentence by its corners, ``ABC``; ``centre_of`` makes the third the velocity centre of a body."""
    return Segment(first + second, third, centre_of)


class Word(Struct, frozen=True):
    """A word of the language by its key in the table ``words``: a sense, a direction on paper, a kind of axis."""

    key: str


class VectorOf(Struct, frozen=True):
    """A vector in a sentence, with an arrow: of the given name."""

    name: Name


class CentreOf(Struct, frozen=True):
    """The velocity centre of a body (P), or with ``kind`` ``Q`` its acceleration centre."""

    body: str
    kind: str = "P"


class AxisOf(Struct, frozen=True):
    """The letter of an axis of projection in a sentence."""

    letter: str


class NumberOf(Struct, frozen=True):
    """A value in a sentence as its number with its unit only, or ``worked_out``: its arithmetic and then the number."""

    value: Value
    worked_out: bool = False


# A Name or a Value in a sentence is written as its symbol; a tuple as a list.
Fact: TypeAlias = (
    "Body | Point | Segment | Word | VectorOf | CentreOf | AxisOf | NumberOf | Name | Value | Sentence "
    "| tuple[Fact, ...]"
)


class Sentence(Struct, frozen=True, dict=True):
    """A sentence of the templates: ``key`` is ``file.name``, ``facts`` fill its fields.

    ``detail`` marks what a short solution leaves out.
    """

    key: str
    facts: Mapping[str, Fact] = field(default_factory=dict)
    detail: bool = True


class Derived(Struct, frozen=True, dict=True):
    """``name = expression = with numbers = result unit``.

    ``symbolic`` False leaves out the first expression (a line before has shown it), ``numeric`` False the second.
    ``law`` is a formula in symbols that goes before an expression to which it comes down: ``a^tau = epsilon R = a_O``.
    """

    value: Value
    symbolic: bool = True
    numeric: bool = True
    detail: bool = False
    law: Expression | None = None


class Term(Struct, frozen=True):
    """A vector of a vector equation.

    ``size`` is its magnitude, None as long as it is unknown; ``angle`` the direction on paper (degrees from the x
    axis, counter-clockwise), for an unknown vector the assumed one. ``way`` says where the direction comes from, as a
    sentence for the table of vectors.
    """

    name: Name
    size: Value | None
    angle: Value
    way: Sentence

    @property
    def is_laid(self) -> bool:
        """Whether it is a component along an axis that the solution has laid."""
        return self.name.part.rpartition(" ")[2] in OWN_AXES

    @property
    def point(self) -> str:
        """The point whose vector it is, also where the data give the vector a letter of its own."""
        if self.name.kind != "parameter":
            return self.name.of
        fact = self.way.facts.get("point") or self.way.facts["segment"]
        assert isinstance(fact, Point | Segment)
        return fact.name if isinstance(fact, Point) else fact.start


class VectorLine(Struct, frozen=True, dict=True):
    """A vector equation: sums of vectors on both sides."""

    left: tuple[Term, ...]
    right: tuple[Term, ...]


class TermTable(Struct, frozen=True, dict=True):
    """The vectors of an equation with direction and magnitude, known or not."""

    terms: tuple[Term, ...]


class Share(Struct, frozen=True):
    """The projection of a vector on an axis: ``sign * size * cos(angle)``; ``angle`` None is a zero angle.

    ``function`` "sin" stands for the cosine of the angle to 90 degrees.
    """

    sign: int
    term: Term
    angle: Value | None
    function: str = "cos"

    @property
    def factor(self) -> Expression | None:
        """What stands with the magnitude of the vector."""
        return None if self.angle is None else Applied(self.function, self.angle)

    @property
    def size(self) -> Expression:
        """The projection of a known vector without its sign."""
        assert self.term.size is not None, "a known vector has a magnitude"
        return self.term.size if self.angle is None else self.term.size * Applied(self.function, self.angle)


class Projection(Struct, frozen=True, dict=True):
    """A vector equation projected on an axis; an empty side is zero.

    ``words`` say what the axis is, and why the wanted vector points as it does; ``axis`` is its direction on paper,
    ``letter`` what the words call it.
    """

    words: tuple[Sentence, ...]
    left: tuple[Share, ...]
    right: tuple[Share, ...]
    axis: Value | None = None
    letter: str = ""

    @property
    def is_bare(self) -> bool:
        """Whether the projection is but one whole vector and zero, which the line of the result says."""
        shares = (*self.left, *self.right)
        return len(shares) == 1 and shares[0].factor is None


class LinearSystem(Struct, frozen=True, dict=True):
    """Equations linear in unknown values, with numbers, and their solution.

    ``rows`` are the coefficients, one row per equation, and ``right`` the right-hand sides; the unknowns carry the
    solution.
    """

    unknowns: tuple[Value, ...]
    rows: tuple[tuple[Value, ...], ...]
    right: tuple[Value, ...]


class Balance(Struct, frozen=True, dict=True):
    """Two sums that must be equal, each with its number: the sides of a vector equation on a further axis."""

    left: Value
    right: Value


class Ascending(Struct, frozen=True, dict=True):
    """Numbers each of which is smaller than the next: what a bound of magnitudes says."""

    values: tuple[Value, ...]


class EquationLine(Struct, frozen=True, dict=True):
    """An equation without a result of its own: both sides as expressions, checked when it is shown with numbers."""

    left: Expression
    right: Expression
    numeric: bool = False


class ProgramListing(Struct, frozen=True, dict=True):
    """A piece of a program, as text; ``results`` are the values that it prints, in order."""

    code: str
    results: tuple[Value, ...]


Item: TypeAlias = (
    Sentence
    | Derived
    | VectorLine
    | TermTable
    | Projection
    | Balance
    | Ascending
    | LinearSystem
    | EquationLine
    | ProgramListing
    | ChainGraph
)


class Step(Struct):
    """A numbered step: its heading and what follows; ``views`` are the kinds of figure that go with it.

    Of a finished solution they are the names of figures: with the body or the number of the equation that each shows.
    """

    heading: Sentence
    items: list[Item] = field(default_factory=list)
    views: tuple[str, ...] = ()

    def __enter__(self) -> Step:
        return self

    def __exit__(self, *error: object) -> None:
        pass


class Solution(Struct, frozen=True):
    """A whole solution: the steps, the answers with their values, the check by another method.

    ``approximate`` is the number of significant digits of answers that were measured, 0 where they were computed;
    ``centres`` are the rays to acceleration centres that it speaks of. Its figures draw ``vectors``: first those of
    the velocities, then, where accelerations are asked, those of the accelerations; each marks the ``geometry`` under
    its name.
    """

    steps: tuple[Step, ...]
    answers: tuple[tuple[str, Value], ...]
    check: tuple[Item, ...] = ()
    approximate: int = 0
    centres: tuple[Quantity, ...] = ()
    vectors: tuple[PointVectors, ...] = ()
    geometry: Mapping[str, StepGeometry] = field(default_factory=dict)
