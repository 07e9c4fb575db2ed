"""A contact that keeps a distance constant takes no compound motion.

Two circles touch, or a roller lies on a rim: the distance of the centres C and B is constant, and a rod CB may take the
place of the contact. ``v_B = v_C + v_BC`` and ``a_B = a_C + a^n_BC + a^tau_BC`` with ``a^n_BC = v_BC^2 / CB``. It
applies where C belongs to a turning body of known motion and the path of B is known. It costs two vectors and the
Coriolis acceleration less than the compound motion of B.

A circle touches a straight face of a body in translation: the distance of its centre from the face is constant, so that
centre and body have equal projections on the normal of the face. It applies where the figure shows no slot in which the
centre slides. It costs one projection, and no further vector.

Neither applies where relative motion or the Coriolis acceleration is asked, or where a method is wished.
"""

from __future__ import annotations

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angle_sums import angle_sum, difference, is_short
from variantgen.methods.geometry.geometry import Geometry, between, degrees
from variantgen.methods.groups.carriers import is_translating, is_within_reach
from variantgen.methods.groups.group import SlidingPair
from variantgen.methods.solution.book import Book, Known, resultant
from variantgen.methods.solution.named_angles import note_sum
from variantgen.methods.steps.step import Body, Derived, Fact, Point, Projection, Segment, Term, VectorOf, Word
from variantgen.methods.vectors.directions import on_paper
from variantgen.methods.vectors.natural_sum import ordered_sum, signed
from variantgen.methods.vectors.point_paths import directed, on_path
from variantgen.methods.vectors.points import across, vector
from variantgen.methods.vectors.vector_equation import named_shares, pointing, share_of, solved, write

_RELATIVE = ("v_rel", "a_rel", "a_cor")
_NOTHING = 1e-9  # of the largest velocity: a smaller one is none
_SQUARE, _STRAIGHT = 90.0, 1e-7  # degrees of a right angle, and within which an angle is one
_STEPS = {1: ("distance.velocity", "velocities"), 2: ("distance.acceleration", "accelerations")}


def is_free(book: Book, group: SlidingPair) -> bool:
    """Whether nothing asked or wished takes the compound motion of the sliding point."""
    point = group.path.point
    asked = any(q.target == point and q.kind in _RELATIVE for q in book.task.sought)
    return book.style.is_free and book.graphics is None and not asked and not group.driven


# A rod between two centres.


def is_rod(book: Book, group: SlidingPair) -> bool:
    """Whether a rod from the centre of the relative path may lead the point."""
    known = group.point_path is not None and not group.turning and not is_translating(book, group.carrier)
    return known and group.path.line is None and is_free(book, group) and is_within_reach(book, group.path.centre)


def solve_rod(book: Book, group: SlidingPair) -> None:
    """Find the vector of the point on its path by the rod from the centre of the circle on which it slides."""
    point, centre = group.path.point, group.path.centre
    assert group.point_path is not None
    at_centre = vector(book, centre)
    heading, view = _STEPS[book.order]
    facts: dict[str, Fact] = {"point": Point(point), "centre": Point(centre), "rod": Segment(centre, point)}
    pivot = book.task.linkage.pivot(group.carrier)
    if pivot is not None and group.point_path.straight:
        facts |= {"pivot": Point(pivot), "crank": Segment(pivot, centre)}
    book.relative.setdefault((point, group.carrier), ())
    with book.step(heading, view, **facts):
        if book.order == 1:
            book.say("distance.slider_crank" if "crank" in facts else "distance.rod", False, **facts)
            if pivot is not None:
                _note_corner(book, (pivot, point), centre)
        known, path = on_path(book, group.point_path)
        if book.order == 1 and _is_translating_rod(book, point, centre):
            _enter_same(book, path, at_centre, facts)
            return
        book.say(f"distance.sum_{book.letter}", **facts)
        start = len(book.items)
        turning, turn = _about_centre(book, point, centre)
        ways = pointing((*known, path), (*at_centre, *turning, turn))
        path, turn = ways[path.name], ways[turn.name]
        left, right = (*known, path), (*at_centre, *turning, turn)
        write(book, left, right, start)
        sizes = solved(book, left, right, [path, turn] if book.order < book.task.order else [path])
        book.vectors[point] = (*known, *directed(path, sizes[0]))
        if len(sizes) > 1:
            book.values[turn.name] = sizes[1]


def _note_corner(book: Book, ends: tuple[str, str], vertex: str) -> None:
    """The angle of the crank and the rod, where it is a longer sum of angles: it is met in several projections."""
    rays = [book.geometry.direction(vertex, end) for end in ends]
    corner = difference(Name("angle", vertex, " ".join(ends)), *rays)
    if not is_short(angle_sum(corner)):
        book.geometry.items.append(Derived(corner))
        note_sum(book, corner)


def _is_translating_rod(book: Book, point: str, centre: str) -> bool:
    """Whether both ends of the rod have one velocity."""
    now = book.task.now
    return abs(now.v[point] - now.v[centre]) <= _NOTHING * book.task.largest_speed


def _enter_same(book: Book, path: Term, at_centre: Known, facts: dict[str, Fact]) -> None:
    """The velocity of the end of a rod in translation at the instant."""
    vectors: dict[str, Fact] = {"vector": VectorOf(path.name), "other": VectorOf(at_centre[0].name)}
    book.say("distance.same", False, **vectors, **facts)
    assert at_centre[0].size is not None
    size = book.derive(path.name, "velocity", at_centre[0].size)
    book.vectors[path.point] = (Term(path.name, size, at_centre[0].angle, path.way),)


def _about_centre(book: Book, point: str, centre: str) -> tuple[Known, Term]:
    """The rotation of the rod about the centre: the normal acceleration, and the vector across the rod."""
    name = Name(book.letter, point, centre)
    if book.order == 1:
        return (), across(book, name, None, (point, centre), 1)
    normal: Known = ()
    speed = book.values.get(Name("v", point, centre))
    if speed is None or speed.exact == 0:
        vectors: dict[str, Fact] = {"vector": VectorOf(name.component("n")), "rod": Segment(centre, point)}
        book.say("distance.no_normal", **vectors)
    else:
        size = book.derive(name.component("n"), "acceleration", speed**2 / book.geometry.length(point, centre))
        angle = book.geometry.direction(point, centre)
        ends: dict[str, Fact] = {"start": Point(point), "end": Point(centre)}
        normal = (book.term(name.component("n"), size, angle, "towards", **ends),)
    return normal, across(book, name.component("tau"), None, (point, centre), 1)


# A flat face.


def is_face(book: Book, group: SlidingPair) -> bool:
    """Whether the point is the centre of a circle that touches a straight face of a translating carrier."""
    line, hidden = group.path.line, set(book.task.form.figure.hidden)
    led = group.carrier_path is not None and group.carrier_path.straight and is_translating(book, group.carrier)
    discs = {disc.centre for disc in book.task.form.figure.discs}
    return led and line is not None and set(line) <= hidden and group.path.point in discs and is_free(book, group)


def solve_face(book: Book, group: SlidingPair) -> None:
    """Find the vector of the carrier by equal projections on the normal of its face."""
    assert group.carrier_path is not None and group.path.line is not None
    point, carried = group.path.point, group.carrier_path.point
    known = vector(book, point)
    heading, view = _STEPS[book.order]
    names = Name(book.letter, point), Name(book.letter, carried)
    facts: dict[str, Fact] = {"point": Point(carried), "centre": Point(point), "carrier": Body(group.carrier)}
    facts |= {"vector": VectorOf(names[0]), "sought": VectorOf(names[1])}
    book.relative.setdefault((point, group.carrier), ())
    with book.step(heading, view, **facts):
        book.say(f"distance.face_{book.letter}", False, **facts)
        _, path = on_path(book, group.carrier_path)
        axis = _normal(book, group.path.line, path.angle, resultant(known))
        shares = named_shares(book, known, axis)
        if not shares:
            book.say("distance.face_nothing", False, **facts)
            book.vectors[carried] = ()
            return
        ahead = between(path.angle.exact, axis.exact) < _SQUARE
        path = Term(path.name, None, path.angle if ahead else Geometry.turned(path.angle, 180.0), path.way)
        own = share_of(path, axis)
        assert own is not None, "a body does not move along its own face"
        book.say("distance.face_sense", side=Word(on_paper(path.angle.exact)), **facts)
        if own.factor is not None:
            book.items.append(Projection((), (own,), shares, axis))
        whole = ordered_sum(signed(shares))
        size = book.derive(path.name, book.measure, whole if own.factor is None else whole / own.factor)
        book.vectors[carried] = (Term(path.name, size, path.angle, path.way),)


def _normal(book: Book, face: tuple[str, str], path: Value, ahead: complex) -> Value:
    """The direction of the normal of a face, to the side of a vector; along the path of the body where it is that."""
    line = book.geometry.vector(*face)
    square = abs(between(path.exact, degrees(line)) - _SQUARE) < _STRAIGHT
    normal = path if square else Geometry.turned(book.geometry.direction(*face), 90.0)
    return normal if between(normal.exact, degrees(ahead)) < _SQUARE else Geometry.turned(normal, 180.0)
