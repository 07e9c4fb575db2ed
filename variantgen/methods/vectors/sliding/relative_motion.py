"""Relative motion: a point slides on a moving body (sleeve, slot, groove).

Kirsanov, section 2.5, formulas 2.23 (velocities), 2.25 (accelerations), 2.26 (Coriolis).
``v = v_tr + v_rel`` and, by the theorem of Coriolis, ``a = a_tr + a_rel + a_cor`` with ``a_cor = 2 omega v_rel``, the
relative velocity turned by a right angle in the sense of the transport rotation (rule of Zhukovsky). The transport
vector is that of the point of the body below the sliding one.
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.mechanism.drivers.circling import Circling
from variantgen.mechanism.drivers.relative_travel import RelativeTravel
from variantgen.methods.groups.carriers import is_translating
from variantgen.methods.groups.group import SlidingPair
from variantgen.methods.groups.wanted import is_last_sought, is_rate_wanted, leads_on
from variantgen.methods.solution.book import Book, Known
from variantgen.methods.steps.step import Body, Fact, Point, Segment, Term, VectorOf
from variantgen.methods.vectors.contacts import constant_distance
from variantgen.methods.vectors.given_motion import amount, as_stated
from variantgen.methods.vectors.point_paths import directed, on_path
from variantgen.methods.vectors.points import RIGHT, across, enter_sum, modulus, rotation, vector
from variantgen.methods.vectors.pole import about_pole, enter_rate
from variantgen.methods.vectors.sliding.carrier_points import about_corner, seen
from variantgen.methods.vectors.sliding.coriolis import coriolis_of, say_uniform, say_unneeded
from variantgen.methods.vectors.vector_equation import pointing, solved, write


class _Sides(Struct):
    """Both sides of the equation, and its unknown vectors by what they are for."""

    left: list[Term]
    right: list[Term]
    turn: Term | None = None
    own: Term | None = None
    path: Term | None = None
    carrier_path: Term | None = None
    relative: Term | None = None
    relative_terms: Known = ()  # what is known of the relative vector

    def turn_to(self, ways: Mapping[Name, Term]) -> None:
        """Turn the unknown vectors to the sides to which they point."""
        self.left = [ways.get(term.name, term) for term in self.left]
        self.right = [ways.get(term.name, term) for term in self.right]
        for name in ("turn", "own", "path", "carrier_path", "relative"):
            term = getattr(self, name)
            if term is not None:
                setattr(self, name, ways[term.name])


def solve_sliding_pair(book: Book, group: SlidingPair) -> None:
    """Find what the sliding of a point tells: rates, the vector of the point or of the carrier, the relative motion."""
    group = about_corner(book, seen(book, group))
    if constant_distance.is_rod(book, group):
        constant_distance.solve_rod(book, group)
        return
    if constant_distance.is_face(book, group):
        constant_distance.solve_face(book, group)
        return
    point, carrier = group.path.point, group.carrier
    needed = [name for name in (group.pole, group.own_pole) if name]
    needed += [point] if group.point_path is None and not group.body and not group.driven else []
    for name in needed:
        vector(book, name)
    view = "velocities" if book.order == 1 else "accelerations"
    facts: dict[str, Fact] = {"point": Point(point), "carrier": Body(carrier)}
    with book.step(f"relative.{book.measure}", view, **facts):
        _say_law(book, group, facts)
        start = len(book.items)
        sides = _sides(book, group)
        if not group.driven:
            sides.turn_to(pointing(sides.left, sides.right))
        write(book, sides.left, sides.right, start)
        _solve(book, group, sides)


def _say_law(book: Book, group: SlidingPair, facts: dict[str, Fact]) -> None:
    """What is the relative and what the transport motion, and by which theorem their vectors are added."""
    # Where no velocity is asked, the step of the velocities may not be written.
    anew = book.order == 2 and all(quantity.order == 2 for quantity in book.task.sought)
    compound = "relative.compound_translation" if is_translating(book, group.carrier) else "relative.compound"
    if anew or not book.has_said(compound, **facts):
        book.say(compound, **facts)
    if not is_translating(book, group.carrier):
        _say_parts(book, group)
        book.say(f"relative.sum_{book.letter}")
        return
    named_by = group.carrier_path.point if group.carrier_path is not None else group.pole
    if named_by not in book.task.fixed:
        facts = {"vector": VectorOf(_named_as_given(book, named_by)), "carrier": facts["carrier"]}
        book.say(f"relative.translation_{book.letter}", **facts)


def _say_parts(book: Book, group: SlidingPair) -> None:
    """That the point is at rest, and what the transport vector consists of, where that is not a rotation alone."""
    point = group.path.point
    if point in book.task.fixed:
        book.say(f"relative.rest_{book.letter}", point=Point(point))
    if group.pole in book.task.fixed:
        return
    names = Name(book.letter, point, part="tr"), Name(book.letter, group.pole), Name(book.letter, point, group.pole)
    facts: dict[str, Fact] = dict(zip(("vector", "first", "second"), map(VectorOf, names), strict=True))
    book.say(f"relative.carried_{book.letter}", point=Point(point), carrier=Body(group.carrier), **facts)


def _named_as_given(book: Book, point: str) -> Name:
    """The name of the vector of a point: its own, or under which it is given."""
    terms = book.vectors.get(point, ())
    return terms[0].name if len(terms) == 1 else Name(book.letter, point)


def _sides(book: Book, group: SlidingPair) -> _Sides:
    """The absolute vector on the left, transport, Coriolis and relative vectors on the right."""
    point = group.path.point
    sides = _Sides([], [])
    if group.point_path is not None:
        known, sides.path = on_path(book, group.point_path)
        sides.left = [*known, sides.path]
    elif group.body:
        known, sides.own = about_pole(book, point, group.own_pole, group.body)
        sides.left = [*book.vectors[group.own_pole], *known, sides.own]
    elif group.driven:
        name = Name(book.letter, point)
        sides.path = book.term(name, None, RIGHT, "unknown")
        sides.left = [sides.path]
    else:
        sides.left = list(book.vectors[point])
    _add_transport(book, group, sides)
    coriolis = coriolis_of(book, point, group.carrier)
    if book.order == 2:
        book.coriolis[point, group.carrier] = coriolis
    sides.right += coriolis
    sides.relative_terms, sides.relative = _relative(book, group)
    sides.right += [*sides.relative_terms, *([sides.relative] if sides.relative else [])]
    return sides


def _add_transport(book: Book, group: SlidingPair, sides: _Sides) -> None:
    """The vector of the carrier's point: of its pole and of the rotation about it."""
    point, carrier, pole = group.path.point, group.carrier, group.pole
    if group.carrier_path is not None:
        known, sides.carrier_path = on_path(book, group.carrier_path)
        sides.right = [*known, sides.carrier_path]
        return
    fixed = pole in book.task.fixed
    sides.right = [] if fixed else list(book.vectors[pole])
    if is_translating(book, carrier):
        return
    if group.turning:
        known, sides.turn = about_pole(book, point, pole, carrier)
        if fixed:
            if book.order == 2 and not known:
                normal = Name(book.letter, point, part="tr").component("n")
                book.say("rates.no_normal", omega=Name("omega", carrier), vector=normal)
            known, sides.turn = tuple(_transport(book, t) for t in known), _transport(book, sides.turn)
        sides.right += [*known, sides.turn]
    else:
        name = Name(book.letter, point, part="tr") if fixed else Name(book.letter, point, pole)
        if book.order == 1 and not fixed and not book.omega[carrier].sense:
            book.say("rates.no_normal", omega=Name("omega", carrier), vector=name)
        sides.right += rotation(book, point, pole, carrier, name)


def _transport(book: Book, term: Term) -> Term:
    """A vector of the rotation about a fixed point under the name of transport motion."""
    part = f"tr {term.name.part}".strip()
    name = replace(term.name, part=part)
    if term.size is not None:
        term.size.name = name
        book.values[name] = book.values.pop(
            term.name, term.size
        )  # the old name is that of a component of the absolute vector
    return Term(name, term.size, term.angle, term.way)


def _relative(book: Book, group: SlidingPair) -> tuple[Known, Term | None]:
    """The relative vector: what is known of it and the rest along the path, assumed towards its second point."""
    path, point = group.path, group.path.point
    name = Name(book.letter, point, part="rel")
    known: Known = ()
    if path.line is None and book.order == 2:
        relative = book.relative[point, group.carrier]
        if relative:
            assert relative[0].size is not None
            own = name.component("n")
            book.say("relative.circle", point=Point(point), centre=Point(path.centre))
            size = book.derive(own, "acceleration", relative[0].size ** 2 / book.geometry.length(point, path.centre))
            angle = book.geometry.direction(point, path.centre)
            known = (book.term(own, size, angle, "towards", start=Point(point), end=Point(path.centre)),)
        name = name.component("tau")
    if group.driven:
        return (*known, *_given(book, group, name)), None
    if path.line is None:
        return known, across(book, name, None, (point, path.centre), 1)
    angle = book.geometry.direction(*path.line)
    figure, ends = book.task.form.figure, set(path.line)
    if ends & set(figure.hidden):
        return known, book.term(name, None, angle, "groove" if any(ends <= {*g} for g in figure.grooves) else "path")
    return known, book.term(name, None, angle, "slot", segment=Segment(*path.line))


def _given(book: Book, group: SlidingPair, name: Name) -> Known:
    """The given relative vector along the path."""
    path, point = group.path, group.path.point
    for template, driver in zip(book.task.form.drivers, book.task.scene.drivers, strict=True):
        if not isinstance(driver, RelativeTravel | Circling) or driver.point != point:
            continue
        rate = float(driver.rates(book.order)[0])
        if rate == 0:
            say_uniform(book, group)
            return ()
        size = amount(book, template, book.letter, book.measure)
        name = as_stated(name, size)
        sign = 1 if rate > 0 else -1
        if path.line is None:
            turn = sign * round(float(book.task.scene.frame.sense))
            return (across(book, name, size, (point, path.centre), turn),)
        angle = book.geometry.direction(*(path.line if sign > 0 else path.line[::-1]))
        return (book.term(name, size, angle, "given", point=Point(point)),)
    return ()


def _solve(book: Book, group: SlidingPair, sides: _Sides) -> None:
    """Solve the equation for what is unknown and enter it."""
    point, carrier = group.path.point, group.carrier
    if group.driven:
        name = Name(book.letter, point)
        relatives = book.relative if book.order == 1 else book.relative_acceleration
        relatives[point, carrier] = sides.relative_terms
        carried = any(point in members for members in book.task.scene.bodies.values())
        enter_sum(book, point, tuple(sides.right), carried or leads_on(book.task, point, carrier))
        modulus(book, name, book.vectors[point])
        _sum_up_relative(book, point, sides.relative_terms)
        return
    wanted = [term for term in _wanted(book, group, sides) if term is not None]
    sizes = dict(zip((t.name for t in wanted), solved(book, sides.left, sides.right, wanted), strict=True))
    say_unneeded(book, book.coriolis.get((point, carrier), ()) if book.order == 2 else ())
    _enter(book, group, sides, sizes)


def _wanted(book: Book, group: SlidingPair, sides: _Sides) -> list[Term | None]:
    """The unknown vectors that are needed: the relative velocity also for the accelerations that follow from it."""
    point, task = group.path.point, book.task
    kinds = ("v_rel",) if book.order == 1 else ("a_rel",)
    asked = any(q.target == point and q.kind in kinds for q in task.sought)
    # On a carrier in translation there is no Coriolis acceleration, on a straight path no normal one.
    leading = not is_translating(book, group.carrier) or group.path.line is None
    relative = sides.relative if asked or (leading and book.order < task.order) else None
    last = book.order == 2 and is_last_sought(task, point, book.vectors)
    turn = None if last or not is_rate_wanted(task, book.order, group.carrier, {point}) else sides.turn
    # The vector of the point itself follows from the rate of its body; another link may be hinged to the point.
    hinged = {name for name, members in task.scene.bodies.items() if point in members} - {group.body, group.carrier}
    sought = any(q.target == point and q.kind == book.letter for q in task.sought) or hinged & task.needed.bodies
    known = {group.own_pole} if sought else {point, group.own_pole}
    own = sides.own if sides.own and is_rate_wanted(task, book.order, group.body, known) else None
    return [sides.carrier_path, sides.path, turn, own, relative]


def _enter(book: Book, group: SlidingPair, sides: _Sides, sizes: dict[Name, Value]) -> None:
    """Note what was found, and the rates that follow."""
    point, carrier = group.path.point, group.carrier
    relatives = book.relative if book.order == 1 else book.relative_acceleration
    term = sides.relative
    relatives[point, carrier] = (
        (*sides.relative_terms, *directed(term, sizes[term.name])) if term and term.name in sizes else ()
    )
    _sum_up_relative(book, point, relatives[point, carrier])
    if sides.carrier_path is not None and group.carrier_path is not None:
        known = tuple(t for t in sides.right if t.point == group.carrier_path.point and t.size is not None)
        book.vectors[group.carrier_path.point] = (*known, *directed(sides.carrier_path, sizes[sides.carrier_path.name]))
    if sides.path is not None:
        known = tuple(t for t in sides.left if t.size is not None)
        book.vectors[point] = (*known, *directed(sides.path, sizes[sides.path.name]))
    for term, body, pole in ((sides.turn, carrier, group.pole), (sides.own, group.body, group.own_pole)):
        if term is not None and term.name in sizes:
            enter_rate(book, body, term, sizes[term.name], book.geometry.length(point, pole))


def _sum_up_relative(book: Book, point: str, terms: Known) -> None:
    """The magnitude of a relative vector that is known by components, where it is asked."""
    asked = any(q.target == point and q.kind == f"{book.letter}_rel" for q in book.task.sought)
    if asked and len(terms) > 1:
        modulus(book, Name(book.letter, point, part="rel"), terms)
