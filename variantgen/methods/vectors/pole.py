"""The vector equation with a pole, for a body of which one point is known and of another the path: dyads and crossings.

For velocities ``v_B = v_A + v_BA`` (guide, 3.1.2, formula 57), for accelerations ``a_B = a_A + a^n_BA + a^tau_BA``
(3.2.2, formula 63, Rivals). Two magnitudes are unknown, the problem of the third type of the guide. Each is found by
projecting on the axis across the other.
"""

from __future__ import annotations

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.methods.groups.group import Dyad, FloatingDyad, TwoPointBody
from variantgen.methods.groups.wanted import is_rate_wanted
from variantgen.methods.solution.book import Book, Known, Rate
from variantgen.methods.steps.step import Body, Fact, Point, Term, VectorOf
from variantgen.methods.vectors.point_paths import directed, on_path, sense_of
from variantgen.methods.vectors.points import VIEWS, across, modulus, vector
from variantgen.methods.vectors.vector_equation import pointing, solved, write


def solve_dyad(book: Book, group: Dyad) -> None:
    """Find the vector of the point on its path and the rate of the body."""
    point, pole, body = group.point_path.point, group.pole, group.body
    known = vector(book, pole)
    view = "velocities" if book.order == 1 else "accelerations"
    with book.step(f"pole.dyad_{book.letter}", view, body=Body(body), point=Point(point), pole=Point(pole)):
        book.say(
            f"pole.choose_{book.letter}", pole=Point(pole), body=Body(body), vector=VectorOf(Name(book.letter, point))
        )
        start = len(book.items)
        at_path, path = on_path(book, group.point_path)
        turning, turn = about_pole(book, point, pole, body)
        ways = pointing((*at_path, path), (*known, *turning, turn))
        path, turn = ways[path.name], ways[turn.name]
        write(book, (*at_path, path), (*known, *turning, turn), start)
        wanted = [path, turn] if is_rate_wanted(book.task, book.order, body, {point, pole}) else [path]
        sizes = solved(book, (*at_path, path), (*known, *turning, turn), wanted)
        book.vectors[point] = (*at_path, *directed(path, sizes[0]))
        if len(sizes) > 1:
            enter_rate(book, body, turn, sizes[1], book.geometry.length(point, pole))
        if len(book.vectors[point]) > 1 and any(q.point == point and q.kind == book.letter for q in book.task.sought):
            modulus(book, Name(book.letter, point), book.vectors[point])


def solve_floating_dyad(book: Book, group: FloatingDyad) -> None:
    """Find the rates of two bodies with a common hinge, each with a known pole: the hinge has one vector."""
    point = group.point
    knowns = [vector(book, pole) for pole in group.poles]
    first, second = group.bodies
    view = "velocities" if book.order == 1 else "accelerations"
    facts: dict[str, Fact] = {"first": Body(first), "second": Body(second), "point": Point(point)}
    kind = "omega" if book.order == 1 else "epsilon"
    facts["rates"] = (Name(kind, first), Name(kind, second))
    with book.step(f"pole.crossing_{book.letter}", view, **facts):
        poles: dict[str, Fact] = {"pole": Point(group.poles[0]), "other": Point(group.poles[1])}
        book.say(f"pole.two_poles_{book.letter}", **poles, **facts)
        start = len(book.items)
        sides: list[tuple[Term, ...]] = []
        turns: list[Term] = []
        for body, pole, known in zip(group.bodies, group.poles, knowns, strict=True):
            turning, turn = about_pole(book, point, pole, body)
            sides.append((*known, *turning))
            turns.append(turn)
        ways = pointing((*sides[0], turns[0]), (*sides[1], turns[1]))
        turns = [ways[turn.name] for turn in turns]
        sides = [(*side, turn) for side, turn in zip(sides, turns, strict=True)]
        write(book, sides[0], sides[1], start)
        sizes = solved(book, sides[0], sides[1], turns)
        for body, pole, turn, size in zip(group.bodies, group.poles, turns, sizes, strict=True):
            enter_rate(book, body, turn, size, book.geometry.length(point, pole))


def solve_two_point_body(book: Book, group: TwoPointBody) -> None:
    """The rate of a body from two known points: ``v_B = v_A + v_BA`` projected across AB."""
    point, pole, body = group.point, group.pole, group.body
    wanted = is_rate_wanted(book.task, book.order, body, {point, pole})
    if book.order == 2 and not wanted:
        return
    at_point, at_pole = vector(book, point), vector(book, pole)
    if not wanted:
        return
    facts: dict[str, Fact] = {"body": Body(body), "point": Point(point), "pole": Point(pole)}
    with book.step(f"known_points.{book.letter}", VIEWS[book.order], **facts):
        book.say(f"known_points.both_{book.letter}", **facts)
        start = len(book.items)
        turning, turn = about_pole(book, point, pole, body)
        turn = pointing(at_point, (*at_pole, *turning, turn))[turn.name]
        right = (*at_pole, *turning, turn)
        write(book, at_point, right, start)
        size = solved(book, at_point, right, [turn])[0]
        enter_rate(book, body, turn, size, book.geometry.length(point, pole))


def about_pole(book: Book, point: str, pole: str, body: str) -> tuple[Known, Term]:
    """The rotation of a point about a pole: what is known of it, and the vector across, assumed counter-clockwise."""
    name = Name(book.letter, point, "" if pole in book.task.fixed else pole)
    if book.order == 1:
        return (), across(book, name, None, (point, pole), 1)
    rate = book.omega[body]
    known: Known = ()
    if rate.sense:
        size = book.derive(name.component("n"), "acceleration", rate.size**2 * book.geometry.length(point, pole))
        angle = book.geometry.direction(point, pole)
        known = (book.term(name.component("n"), size, angle, "towards", start=Point(point), end=Point(pole)),)
    elif name.about:
        book.say("rates.no_normal", omega=Name("omega", body), vector=name.component("n"))
    return known, across(book, name.component("tau"), None, (point, pole), 1)


def enter_rate(book: Book, body: str, turn: Term, size: Value, arm: Value) -> None:
    """The rate of a body from the vector of its rotation: ``omega = v_BA / AB``, with its sense in words."""
    sense = sense_of(book, turn, size)
    kind = "omega" if book.order == 1 else "epsilon"
    if sense == 0:
        book.rates[body] = Rate(Value(Name(kind, body), book.rate_measure, 0.0), 0)
        book.say(f"rates.no_{kind}", False, body=Body(body))
        return
    (found,) = directed(turn, size)
    assert found.size is not None
    rate = Rate(book.derive(Name(kind, body), book.rate_measure, found.size / arm), sense)
    book.rates[body] = rate
    book.say(f"rates.{kind}_{rate.word}", body=Body(body), rate=Name(kind, body), vector=VectorOf(turn.name))
