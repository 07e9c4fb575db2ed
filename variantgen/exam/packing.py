"""Solved problems as bytes, for other processes and for a build that goes on later.

They are JSON, so that a file put in their place can be nothing but wrong data. The exam and its families are not
packed: tasks and families are named by their places, forms by their names, and found again in the exam that the reader
has. Numbers come back to the last bit: printed values are texts, others are written as Python writes them (the
shortest that is read as the same).

A problem is ``[task, family, form, printed values, sense, turns, attempt, answers, work]``, an answer
``[quantity, value, tolerance, margin, surd, unnoticed]``.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from decimal import Decimal
from math import isfinite
from typing import Any

from msgspec.structs import astuple

from variantgen.errors import VariantgenError
from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Answer, Item
from variantgen.families.parameters.units import Unit
from variantgen.families.quantities import Quantity, split_name
from variantgen.methods.hand.work import Work
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Surd


class PackingError(VariantgenError):
    """Bytes that no problems were packed to, or those of another exam."""


def pack(exam: Exam, items: Sequence[Item]) -> bytes:
    """Problems of an exam, with their answers, as bytes."""
    places: dict[int, tuple[int, int]] = {}
    tasks = {id(task): i for i, task in enumerate(exam.tasks)}
    for i, task in enumerate(exam.tasks):
        for k, family in enumerate(task.families):
            places.setdefault(id(family), (i, k))  # the same object may belong to several tasks
    packed = [[tasks[id(item.task)], *_packed(item, places)] for item in items]
    return json.dumps(packed, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()


def _packed(item: Item, places: Mapping[int, tuple[int, int]]) -> list[Any]:
    variant = item.variant
    return [
        places[id(variant.family)],
        variant.form.name,
        {name: str(value) for name, value in variant.printed.items()},
        variant.sense,
        variant.turns,
        variant.attempt,
        [
            [a.quantity.written, a.value, a.tolerance, a.relative_tolerance, a.surd and _numbers(a.surd), a.unnoticed]
            for a in item.answers
        ],
        item.work and astuple(item.work),
    ]


def _numbers(surd: Surd) -> tuple[int, int, int]:
    return surd.numerator, surd.denominator, surd.radicand


def unpack(exam: Exam, content: bytes) -> tuple[Item, ...]:
    """The problems that were packed. Raises PackingError for bytes that are no problems of this exam."""
    try:
        found = json.loads(content)
        if type(found) is not list:
            raise ValueError("no list")
        return tuple(_item(exam, *one) for one in found)
    except (ValueError, TypeError, LookupError, ArithmeticError, AttributeError, RecursionError) as error:
        raise PackingError(f"packed problems cannot be read: {type(error).__name__}") from error


def _item(
    exam: Exam,
    task: int,
    place: tuple[int, int],
    name: str,
    printed: Mapping[str, str],
    sense: int,
    turns: int,
    attempt: int,
    answers: Sequence[Sequence[Any]],
    work: Sequence[int] | None,
) -> Item:
    """A problem. Raises one of the errors that :func:`unpack` expects if there cannot be such a one."""
    family = exam.tasks[place[0]].families[place[1]]
    form = family.forms[name]
    if printed.keys() != form.parameters.keys() or sense not in (1, -1) or turns not in range(4):
        raise ValueError(name)
    values = {parameter: Decimal(text) for parameter, text in printed.items()}
    if not (all(value.is_finite() for value in values.values()) and _are(int, (sense, turns, attempt))):
        raise ValueError(name)
    if not _are(int, work or ()):
        raise ValueError(name)
    variant = Variant(family, form, values, sense, turns, attempt)
    found = tuple(_answer(family.length_unit, *answer) for answer in answers)
    return Item(exam.tasks[task], variant, found, Work(*work) if work else None)


def _answer(
    length: str,
    name: str,
    value: float,
    tolerance: float,
    relative_tolerance: float,
    surd: Sequence[int] | None,
    unnoticed: Sequence[str],
) -> Answer:
    quantity, unit = _quantity(name, length)
    numbers = value, tolerance, relative_tolerance
    if not (_are(float, numbers) and all(map(isfinite, numbers)) and _are(int, surd or ()) and _are(str, unnoticed)):
        raise ValueError(name)
    return Answer(quantity, unit, value, tolerance, relative_tolerance, Surd(*surd) if surd else None, tuple(unnoticed))


def _are(kind: type, values: Sequence[object]) -> bool:
    return all(type(value) is kind for value in values)


def _quantity(name: str, length: str) -> tuple[Quantity, Unit]:
    """A quantity and its unit, where lengths have this one."""
    quantity = split_name(name)
    return quantity, quantity.unit(length)
