"""A check of an acceleration by that of a point A on a link about a fixed axis O, ``OA sqrt(epsilon^2 + omega^4)``.

That makes the angle ``arctan(epsilon / omega^2)`` with AO. The solution has gone by the components ``omega^2 OA`` and
``epsilon OA``; this has the magnitude and the angle of the whole. It applies to a point of a body in translation, of
which A is another point, and to a carrier whose acceleration is the projection of a_A. It costs one line.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct

from variantgen.algebra.expression import Applied, Expression, Ratio, SquareRoot, Total, Value, cos
from variantgen.algebra.name import Name
from variantgen.mechanism.linkage import Linkage
from variantgen.methods.geometry.angle_sums import difference
from variantgen.methods.geometry.geometry import between, degrees
from variantgen.methods.solution.book import Book, resultant
from variantgen.methods.steps.step import Balance, Derived, Fact, Item, Point, Segment, Sentence, Step, VectorOf

_FACE = "distance.face_a"  # says that the accelerations of a centre and of a carrier have equal projections
_COMPONENTS = 2
_SAME = 1e-9  # relative: nearer vectors are one
_NO_ANGLE = 1e-7  # degrees


class _Turning(Struct, frozen=True):
    """A point on a link about a fixed pivot whose rates a reader knows."""

    point: str
    pivot: str
    body: str
    omega: Value
    epsilon: Value

    @property
    def facts(self) -> dict[str, Fact]:
        """What a sentence about it says."""
        rates: dict[str, Fact] = {kind: Name(kind, self.body) for kind in ("omega", "epsilon")}
        return rates | {"segment": Segment(self.pivot, self.point)}

    def size(self, book: Book) -> Expression:
        """The magnitude of its acceleration."""
        return book.geometry.length(self.pivot, self.point) * SquareRoot(
            Total(((1, self.epsilon**2), (1, self.omega**4)))
        )

    @property
    def slope(self) -> Expression:
        """The angle of its acceleration with the line to the pivot."""
        return Applied("arctan", Ratio(self.epsilon, self.omega**2))


def about_axis(book: Book, steps: Sequence[Step]) -> list[Item]:
    """The last acceleration that is that of such a point or a projection of it; nothing where there is none."""
    if book.task.order < 2:
        return []
    found = {item.value.name: item.value for step in steps for item in step.items if isinstance(item, Derived)}
    turning = list(_turning(book))
    for point, terms in reversed(book.acceleration.items()):
        whole = found.get(Name("a", point))
        if whole is None or not whole.exact:
            continue
        for other in turning:
            if len(terms) == _COMPONENTS and _is_same(book, point, other.point):
                facts: dict[str, Fact] = {"vector": VectorOf(Name("a", point)), **other.facts}
                return [Sentence("check.about_axis", facts, detail=False), _balance(whole, other.size(book))]
        items = _projected(book, point, whole, turning)
        if items:
            return items
    return []


def _turning(book: Book) -> Iterator[_Turning]:
    """The points that turn about fixed pivots with two components of acceleration, at given rates."""
    linkage = Linkage(book.task.scene)
    for body, members in book.task.scene.bodies.items():
        pivot, rates = linkage.pivot(body), [book.omega.get(body), book.epsilon.get(body)]
        known = [rate.size for rate in rates if rate is not None and rate.sense and rate.size.expression is None]
        if pivot is None or len(known) < _COMPONENTS:
            continue
        for point in members:
            if point != pivot and len(book.acceleration.get(point, ())) == _COMPONENTS:
                yield _Turning(point, pivot, body, *known)


def _is_same(book: Book, first: str, second: str) -> bool:
    """Whether two points have one acceleration."""
    vectors = [resultant(book.acceleration[point]) for point in (first, second)]
    return abs(vectors[0] - vectors[1]) <= _SAME * abs(vectors[1])


def _projected(book: Book, point: str, whole: Value, turning: Sequence[_Turning]) -> list[Item]:
    """The acceleration of a carrier as the projection of that of the centre that keeps its distance from a face."""
    (term, *_), geometry = book.acceleration[point], book.geometry
    for other in turning:
        said: dict[str, Fact] = {"sought": VectorOf(term.name), "centre": Point(other.point)}
        if not book.has_said(_FACE, **said):
            continue
        line = difference(None, geometry.direction(other.point, other.pivot), term.angle)
        ahead = between(degrees(resultant(book.acceleration[other.point])), term.angle.exact)
        for sum_of_both in (
            ((1, line), (1, other.slope)),
            ((1, line), (-1, other.slope)),
            ((1, other.slope), (-1, line)),
        ):
            angle = Total(sum_of_both)
            if abs(angle.number(True) - ahead) < _NO_ANGLE:
                facts: dict[str, Fact] = {"vector": VectorOf(term.name), "own": VectorOf(Name("a", other.point))}
                facts |= other.facts
                size = other.size(book) * cos(angle)
                return [Sentence("check.about_axis_projected", facts, detail=False), _balance(whole, size)]
    return []


def _balance(whole: Value, size: Expression) -> Balance:
    """Both numbers of one magnitude."""
    sides = [Value(None, "number", item.number(True), item, whole.exact) for item in (whole, size)]
    return Balance(*sides)
