"""Values of an interval of time: the motion at a series of its instants, and what is found between them."""

from __future__ import annotations

import math

import numpy as np

from variantgen.algebra.expression import Value
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity
from variantgen.families.quantities.interval_kinds import INSTANT_OF, ZERO
from variantgen.families.quantities.kind import MEAN
from variantgen.mechanism.motion import Field
from variantgen.mechanism.turn.timed_motion import TimedMotion, timed_motion
from variantgen.methods.by_groups.turn_positions import rounded, turn_measure, turn_name
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import NumberOf, Point, Sentence

_INSTANTS = 9  # of the table


def passage_answer(book: Book, quantity: Quantity) -> Value:
    """The value of a quantity of an interval of time, with a step that says how it is found.

    Raises LookupError where it has none.
    """
    name = turn_name(quantity)
    if quantity.kind == "instant":  # the first step of the solution has found it
        return Value(name, "time", float(quantity.value(book.task.motion)[0]))
    if name in book.values:
        return book.values[name]
    task = book.task
    own = quantity.own_unit(task.variant.family.length_unit)
    answer = Value(name, turn_measure(quantity), own.from_si(float(quantity.value(task.motion)[0])))
    if not math.isfinite(answer.exact):
        raise LookupError(quantity.name)
    passage = timed_motion(task.motion, quantity.order)
    number = NumberOf(rounded(answer.exact, answer.measure))
    with book.step("passage.heading", value=name):
        if quantity.kind in ("shift", "average_v", "average_a"):
            _say_ends(book, passage, quantity)
            duration = NumberOf(rounded(float(passage.duration[0]), "time"))
            key = "shift" if quantity.kind == "shift" else "average"
            place = Point(quantity.target)
            book.say(f"passage.{key}", False, value=answer, number=number, duration=duration, point=place)
        elif (of := _followed(quantity)) is not None:
            say_rows(book, passage, of, is_signed=quantity.kind.startswith(ZERO) or quantity.is_turning)
            book.say(f"passage.{_way_to(quantity)}", False, value=answer, number=number, of=turn_name(of))
        else:
            key = "duration" if quantity.kind == "duration" else "return"
            book.say(f"passage.{key}", False, value=answer, number=number)
    book.values[name] = answer
    return answer


def _followed(quantity: Quantity) -> Quantity | None:
    """The quantity of an instant that is followed over the interval."""
    others = {"way": Quantity("v", quantity.target), "turned": Quantity("omega", quantity.target)}
    return quantity.of_instant or others.get(quantity.kind)


def _way_to(quantity: Quantity) -> str:
    """The key of the sentence that says how it is found."""
    kind = quantity.kind
    if kind.startswith(ZERO):
        return "zero"
    if kind.startswith(MEAN):
        return "mean"
    return "instant" if kind.startswith(INSTANT_OF) else kind if quantity.of_instant is None else "extreme"


def say_rows(book: Book, passage: TimedMotion, of: Quantity, is_signed: bool) -> None:
    """The quantity (of a rate the magnitude, unless it has a sign) at regular instants, once."""
    by_size = of.is_rotation and not is_signed
    sentence = "passage.magnitudes" if by_size else "passage.rows"
    name = turn_name(of)
    if book.has_said(sentence, value=name):
        return
    whole = Quantity(of.kind, of.target, "abs") if by_size else of
    times = np.linspace(float(passage.start[0]), float(passage.end[0]), _INSTANTS)
    own = of.own_unit(book.task.variant.family.length_unit)
    values = own.from_si(whole.value(passage.at(np.zeros(_INSTANTS, dtype=np.intp), times)))
    largest = float(np.max(np.abs(values)))
    rows = tuple(
        Sentence(
            "passage.at",
            {
                "time": NumberOf(rounded(time, "time")),
                "value": NumberOf(rounded(value, turn_measure(of), largest)),
            },
        )
        for time, value in zip(times.tolist(), values.tolist(), strict=True)
    )
    book.say(sentence, False, value=name, rows=rows)


def _say_ends(book: Book, passage: TimedMotion, quantity: Quantity) -> None:
    """The coordinates, or the components of the velocity, of a point at both ends of the interval, once."""
    is_place, point = quantity.kind != "average_a", quantity.target
    sentence = "passage.places" if is_place else "passage.velocities"
    if book.has_said(sentence, point=Point(point)):
        return
    times = np.array([passage.start[0], passage.end[0]])
    motion = passage.at(np.zeros(2, dtype=np.intp), times)
    length = book.task.variant.family.length_unit
    measure = "length" if is_place else "velocity"
    vectors: Field = np.asarray((motion.z if is_place else motion.v)[point])
    shown = unit(length if is_place else f"{length}/s").from_si(vectors)
    largest = float(np.max(np.abs(shown)))
    rows = tuple(
        Sentence(
            "passage.place",
            {
                "time": NumberOf(rounded(time, "time")),
                "first": NumberOf(rounded(vector.real, measure, largest)),
                "second": NumberOf(rounded(vector.imag, measure, largest)),
            },
        )
        for time, vector in zip(times.tolist(), shown.tolist(), strict=True)
    )
    book.say(sentence, False, point=Point(point), rows=rows)
