"""A hydraulic cylinder or another link of given extension: a link that turns and of which the rod slides out.

The end B of the rod is in compound motion: along the cylinder FB with the given velocity, and with it about F.
``v_B = v_rel + v_tr``; ``a_B = a_rel + a_tr^n + a_tr^tau + a_cor``. Projected on FB, what is across the cylinder falls
out: the rate of the cylinder is not needed.
"""

from __future__ import annotations

from variantgen.algebra.expression import Constant, Value
from variantgen.algebra.name import Name
from variantgen.families.family import ComponentTemplate
from variantgen.mechanism.drivers.extension import Extension
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.groups.group import ExtendingLink
from variantgen.methods.solution.book import Book, Known, resultant
from variantgen.methods.steps.step import Body, Fact, Point, Segment, Term, VectorOf, Word
from variantgen.methods.vectors.given_motion import amount, as_stated
from variantgen.methods.vectors.point_paths import directed
from variantgen.methods.vectors.points import across, vector
from variantgen.methods.vectors.pole import about_pole, enter_rate
from variantgen.methods.vectors.sliding.coriolis import say_unneeded
from variantgen.methods.vectors.vector_equation import pointing, solved, write


def solve_extending_link(book: Book, group: ExtendingLink) -> None:
    """Find the rate of the body that the cylinder turns."""
    point, base = group.point, group.base
    carried = vector(book, base)
    facts: dict[str, Fact] = {"point": Point(point), "segment": Segment(base, point), "base": Point(base)}
    view = "velocities" if book.order == 1 else "accelerations"
    with book.step(f"cylinder.{book.measure}", view, body=Body(group.body), **facts):
        if not book.has_said("cylinder.compound", **facts):
            book.say("cylinder.compound", **facts)
        if book.order == 2 and _rate(book, group) == 0 and book.relative[point, _link(group)]:
            book.say("cylinder.uniform", False)
        book.say(f"cylinder.sum_{book.letter}")
        start = len(book.items)
        known, turn = about_pole(book, point, group.pivot, group.body)
        sliding = _along(book, group)
        own, swing = _transport(book, group)
        ways = pointing((*known, turn), (*carried, *sliding, *own, swing))
        turn, swing = ways[turn.name], ways[swing.name]
        left, right = (*known, turn), (*carried, *sliding, *own, swing)
        write(book, left, right, start)
        sizes = solved(book, left, right, [turn, swing] if book.order < book.task.order else [turn])
        say_unneeded(book, tuple(term for term in own if term.name.part == "cor"))
        if book.order == 1:
            book.relative[point, _link(group)] = sliding
            book.relative[base, _link(group)] = directed(swing, sizes[-1]) if len(sizes) > 1 else ()
        enter_rate(book, group.body, turn, sizes[0], book.geometry.length(point, group.pivot))


def _link(group: ExtendingLink) -> str:
    """The name under which the motion of the cylinder is kept: it is no body of the scene."""
    return f"{group.base}{group.point}"


def _rate(book: Book, group: ExtendingLink) -> float:
    """How fast the cylinder becomes longer, or its rate does."""
    driver = book.task.scene.drivers[group.driver]
    assert isinstance(driver, Extension)
    return float(driver.rates(book.order)[0])


def _along(book: Book, group: ExtendingLink) -> Known:
    """The given vector along the cylinder."""
    template: ComponentTemplate = book.task.form.drivers[group.driver]
    rate = _rate(book, group)
    if rate == 0:
        return ()
    size = amount(book, template, book.letter, book.measure)
    name = as_stated(Name(book.letter, group.point, part="rel"), size)
    ends = (group.base, group.point) if rate > 0 else (group.point, group.base)
    return (book.term(name, size, book.geometry.direction(*ends), "given", point=Point(group.point)),)


def _transport(book: Book, group: ExtendingLink) -> tuple[Known, Term]:
    """The rotation of the cylinder about its base: what is known of it, and the vector across, of unknown magnitude."""
    point, base = group.point, group.base
    name = Name(book.letter, point, part="tr")
    if book.order == 1:
        return (), across(book, name, None, (point, base), 1)
    turn = across(book, name.component("tau"), None, (point, base), 1)
    swing = book.relative[base, _link(group)]
    if not swing:
        return (), turn
    (term,) = swing
    assert term.size is not None
    length = book.geometry.length(base, point)
    size = book.derive(name.component("n"), "acceleration", term.size**2 / length)
    angle = book.geometry.direction(point, base)
    normal = book.term(name.component("n"), size, angle, "towards", start=Point(point), end=Point(base))
    return (normal, *_coriolis(book, group, term, length)), turn


def _coriolis(book: Book, group: ExtendingLink, swing: Term, length: Value) -> Known:
    """``a_cor = 2 omega v_rel`` with ``omega = v_tr / FB`` of the cylinder, by the rule of Zhukovsky."""
    relative = book.relative[group.point, _link(group)]
    if not relative:
        return ()
    name = Name("a", group.point, part="cor")
    assert relative[0].size is not None and swing.size is not None
    size = book.derive(name, "acceleration", Constant(2) * swing.size * relative[0].size / length)
    arm = book.geometry.vector(group.base, group.point)
    sense = 1 if (resultant((swing,)) * arm.conjugate()).imag > 0 else -1
    word = "counter_clockwise" if sense > 0 else "clockwise"
    book.say("relative.zhukovsky", vector=VectorOf(name), relative=VectorOf(relative[0].name), sense=Word(word))
    angle = Geometry.turned(relative[0].angle, 90.0 * sense)
    return (book.term(name, size, angle, "zhukovsky", relative=VectorOf(relative[0].name)),)
