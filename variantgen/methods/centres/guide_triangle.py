"""The velocity centre P of a rod with one end on a straight path: no law of sines.

B moves along a line, so BP is square to it, and the rod AB and the ray AP have the same projection on that line:
``AP cos(theta) = AB cos(psi)``. Across the line ``BP`` is the sum or difference of their other projections. Both angles
are with the line and mostly given or known from the position; it costs two lines and no angle of the triangle ABP.
"""

from __future__ import annotations

from variantgen.algebra.expression import Expression, Value
from variantgen.methods.geometry.angle_sums import angle_sum, is_short
from variantgen.methods.geometry.geometry import between
from variantgen.methods.groups.reached import KnownMotion
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import renamed
from variantgen.methods.solution.rays import Centre, CentreRay
from variantgen.methods.steps.step import Fact, Point, Segment, Share, Term
from variantgen.methods.vectors.natural_sum import ordered_sum
from variantgen.methods.vectors.vector_equation import share_of

_STRAIGHT = ("ways.guide", "ways.straight", "ways.slot")
_STEEP = 80.0  # degrees between the path and the ray from the other end: beyond that the centre is remote


def solve(book: Book, centre: Centre, terms: tuple[Term, Term], rays: tuple[Value, Value]) -> bool:
    """Find AP and BP if one of the points moves along a straight line; ``rays`` are the directions to the centre."""
    led = next((i for i in (1, 0) if _is_straight(book, terms[i])), -1)
    if led < 0 or not book.style.shortcuts:
        return False
    point, far = terms[led].point, terms[1 - led].point
    line, ray = terms[led].angle, rays[1 - led]
    if min(between(line.exact, ray.exact), 180.0 - between(line.exact, ray.exact)) > _STEEP:
        return False
    geometry = book.geometry
    side, rod = geometry.length(far, point), Term(terms[led].name, None, geometry.direction(point, far), terms[led].way)
    arm = Term(terms[led].name, None, ray, terms[led].way)
    shares = [share_of(term, axis) for axis in (line, rays[led]) for term in (rod, arm)]
    found = [None if share is None else _short(book, share) for share in shares]
    rod_on, arm_on = found[:2]
    if rod_on is None or arm_on is None or sum(share is None for share in shares) < sum(item is None for item in found):
        return False
    facts: dict[str, Fact] = {"ray": centre.segment(far), "segment": Segment(far, point), "point": Point(point)}
    book.say("perpendiculars.along_path", True, **facts)
    whole = _times(side, rod_on)
    length = book.derive(centre.length(far), "length", whole if arm_on.factor is None else whole / arm_on.factor)
    centre.rays[far] = CentreRay(length, ray)
    parts = [(share.sign, _times(size, share)) for size, share in zip((side, length), found[2:], strict=True) if share]
    centre.rays[point] = CentreRay(book.derive(centre.length(point), "length", ordered_sum(parts)), rays[led])
    return True


def _is_straight(book: Book, term: Term) -> bool:
    """Whether a velocity is that of a point on a straight path."""
    path = KnownMotion(book).point_path(term.point) if term.way.key == "ways.given" else None
    return term.way.key in _STRAIGHT or (path is not None and path.straight)


def _short(book: Book, share: Share) -> Share | None:
    """A projection whose angle is known or a short sum of known ones; None for another one."""
    found = renamed(book, share)
    return found if found is not share or share.angle is None or is_short(angle_sum(share.angle)) else None


def _times(size: Value, share: Share) -> Expression:
    """The projection of a length."""
    return size if share.factor is None else size * share.factor
