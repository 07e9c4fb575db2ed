"""The instant of the problem, where it is found by what happens at it: the first step of a solution."""

from __future__ import annotations

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import simplified
from variantgen.families.found_instant import watched
from variantgen.families.parameters.units import unit
from variantgen.mechanism.turn.timed_motion import timed_motion
from variantgen.methods.by_groups.passage_answers import say_rows
from variantgen.methods.by_groups.turn_positions import rounded, turn_name
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Derived, Fact, NumberOf, Step


def instant_steps(book: Book) -> list[Step]:
    """The step that finds the instant; none where it is given."""
    task, event = book.task, book.task.form.found_instant
    if event is None or task.form.interval is None:
        return []
    time = task.given[task.form.interval.time]
    measure = unit(event.unit).measures
    size = unit(task.unit_of(measure)).from_si(unit(event.unit).to_si(event.value))
    facts: dict[str, Fact] = {"time": time, "number": NumberOf(rounded(time.exact, "time"))}
    facts |= {"value": NumberOf(rounded(size, measure))}
    quantity = watched(task.form)
    with book.step("instant.heading"):
        if quantity is not None:
            say_rows(book, timed_motion(task.motion, quantity.order), quantity, is_signed=True)
            book.say("instant.reached", False, of=turn_name(quantity), **facts)
        else:
            name = Name("parameter", event.name)
            law = task.expressed(task.form.derived[event.name], degrees=measure == "angle")
            book.say("instant.law", False, of=name, **facts)
            if law is not None:
                shown = simplified(law)
                book.items.append(Derived(Value(name, measure, shown.number(True), shown)))
    return [book.steps.pop()]
