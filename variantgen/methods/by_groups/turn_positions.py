"""Values of a whole turn of the crank, position by position, where no triangles of limit positions lead to them."""

from __future__ import annotations

import math

import numpy as np

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.families.quantities import Quantity
from variantgen.families.quantities.kind import MEAN
from variantgen.families.quantities.kinds import ANGLE_OF
from variantgen.mechanism.turn.crank_turn import FULL_TURN, CrankTurn, crank_turn
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import NumberOf, Sentence

_STEPS = 12  # positions of the table
_NOTHING = 1e-9


def turn_name(quantity: Quantity) -> Name:
    """The name of the value of a quantity of a turn."""
    return Name("turn", quantity.name)


def turn_measure(quantity: Quantity) -> str:
    """What a quantity of a turn measures."""
    return quantity.own_unit("m").measures if not quantity.is_angle else "angle"


def by_positions(book: Book, quantity: Quantity) -> Value:
    """Values at regular angles of the crank, and what is found between them."""
    task = book.task
    length = task.variant.family.length_unit
    own = quantity.own_unit(length)
    answer = Value(turn_name(quantity), turn_measure(quantity), own.from_si(float(quantity.value(task.motion)[0])))
    if not math.isfinite(answer.exact):
        raise LookupError(quantity.name)
    of = quantity.of_instant
    if of is None:
        book.say("turn.by_positions", False, value=answer, number=NumberOf(rounded(answer.exact, answer.measure)))
        return answer
    sentence = "turn.magnitudes" if of.is_rotation else "turn.rows"
    if not book.has_said(sentence, value=turn_name(of)):
        rows = _rows(crank_turn(task.motion, of.order), of, length)
        book.say(sentence, False, value=turn_name(of), rows=rows)
    key = "mean" if quantity.kind.startswith(MEAN) else "angle" if quantity.kind.startswith(ANGLE_OF) else "extreme"
    book.say(f"turn.{key}", False, value=answer, number=NumberOf(rounded(answer.exact, answer.measure)))
    book.values[turn_name(quantity)] = answer
    return answer


def _rows(turn: CrankTurn, of: Quantity, length: str) -> tuple[Sentence, ...]:
    """The quantity (the magnitude of a rate) at regular angles of the crank, with four digits."""
    angles = np.linspace(0.0, FULL_TURN, _STEPS, endpoint=False)
    whole = Quantity(of.kind, of.target, "abs") if of.is_rotation else of
    own = of.own_unit(length)
    values = own.from_si(whole.value(turn.at(np.zeros(_STEPS, dtype=np.intp), angles)))
    largest = float(np.max(np.abs(values)))
    return tuple(
        Sentence(
            "turn.at",
            {
                "angle": NumberOf(rounded(angle, "angle")),
                "value": NumberOf(rounded(value, turn_measure(of), largest)),
            },
        )
        for angle, value in zip(np.degrees(angles).tolist(), values.tolist(), strict=True)
    )


def rounded(number: float, measure: str, largest: float = 0.0) -> Value:
    """A number with four digits; what is nothing beside the largest is zero."""
    shown = 0.0 if abs(number) < _NOTHING * largest else float(f"{number:.4g}")
    return Value(None, measure, shown)
