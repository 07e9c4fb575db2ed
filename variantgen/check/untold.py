"""Numbers of a form that no sheet tells and on which what is asked depends: such a problem cannot be solved.

Every number that stands in the file itself, in points, conditions, joints, drivers and what is derived, is changed a
little while everything that is printed stays; what follows from it follows, and the mechanism is solved anew. Numbers
of the same size and measure are taken for one that stands in several places, and changed together.

Some numbers are told in words and are left alone: whole ones and quarters without a unit ("the midpoint", the 2 of a
formula), right angles, their halves, and the angle of an equilateral triangle.

Of a scene, which has no words of its own, :mod:`variantgen.check.scene_numbers` asks the same in another way.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np
from numpy.typing import NDArray

from variantgen.algebra.expression import (
    Expression,
    Total,
    Variable,
)
from variantgen.check.form_numbers import changed_numbers, number_of
from variantgen.check.scene_numbers import undetermined
from variantgen.check.statement_reading import read_sheet
from variantgen.families.family import Form
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.units import LENGTHS, UNITS, unit
from variantgen.families.quantities import Quantity, motion_order, parse_quantity
from variantgen.mechanism.outcome import Outcome
from variantgen.resources import languages
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import Language, load_language
from variantgen.wording.statement import Statement, statement

_LENGTHS = {*LENGTHS, "inch"}
_CHANGE = 1e-3  # relative: so much a number is changed
_NOTHING = 1e-6  # relative: what rounding changes in an answer
_ROUNDING = 1e-9  # relative to the largest answer in the same unit
_EQUAL = 1e-9
_IN_WORDS = (math.pi / 4, math.pi / 3)  # angles whose multiples are told in words: right angles, equilateral triangles
_QUARTERS = 4
_PLACES = 3  # that are named
_SI = {
    "length": "m", "velocity": "m/s", "acceleration": "m/s^2", "angle": "rad", "angular velocity": "rad/s",
    "angular acceleration": "rad/s^2", "time": "s",
}  # fmt: skip
_DECIMAL = re.compile(r"\d+[.,]\d+")


@dataclass(frozen=True)
class _Number:
    """A number of a file: its absolute value (SI), what it measures ("" nothing), the places where it stands."""

    value: float
    measures: str
    places: list[str]


@dataclass(frozen=True)
class Untold:
    """A number that no sheet tells: its places, what is wrong, and whether something asked depends on it.

    If not, only something does that may be asked of the family.
    """

    places: str
    message: str
    asked: bool


def untold_numbers(variants: Sequence[Variant], asked: Sequence[Quantity]) -> Iterator[Untold]:
    """The numbers of a form that answers of these variants of it depend on and no sheet tells in every language.

    Raises InputError if a statement is missing or faulty.
    """
    family, names = variants[0].family, {quantity.name for quantity in asked}
    if family.is_scene:
        for own, dependent in undetermined(variants[0], asked):
            yield Untold(
                own.place,
                _message(_written(own.value, own.measures, family.length_unit), dependent, True),
                True,
            )
        return
    asked = _askable(variants[0], asked)
    form, found = _with_numbers(variants[0].form)
    if not found:
        return
    sheets_of = [[_told(variant, asked, load_language(name)) for name in languages()] for variant in variants]
    for name, number in found.items():
        seen = [
            variant
            for variant, sheets in zip(variants, sheets_of, strict=True)
            if not all(_is_said(number, sheet) for sheet in sheets)
        ]
        changed = _changed_answers(form, found, name, seen, asked) if seen else []
        if changed:
            wrong = [name for name in changed if name in names]
            written = _written(number.value, number.measures, family.length_unit)
            yield Untold(
                ", ".join(number.places[:_PLACES]), _message(written, wrong or changed, bool(wrong)), bool(wrong)
            )


def _written(value: float, measures: str, length_unit: str) -> str:
    """A number with its unit, for a message."""
    if not measures:
        return f"{value:.6g}"
    own = unit({"length": length_unit, "angle": "deg"}.get(measures, _SI[measures]))
    return f"{own.from_si(value):.6g} {own.name}"


def _message(number: str, dependent: Sequence[str], asked: bool) -> str:
    """What is wrong with a number, and what to do; ``asked``: the quantities that depend on it are asked."""
    depend = f"{', '.join(dependent)} {'depends' if len(dependent) == 1 else 'depend'} on it"
    otherwise = "" if asked else ", which may be asked; name in may_ask what can be found from the sheet, or"
    remedy = "make it a parameter, which is printed, derive it from parameters, or let the statement tell it"
    return f"the number {number} is on no sheet, and {depend}{otherwise or ';'} {remedy}"


def _askable(variant: Variant, asked: Sequence[Quantity]) -> list[Quantity]:
    """What is asked, and of a family what may be asked."""
    form, known = variant.form, {quantity.name for quantity in asked}
    further = [name for name in form.askable if "." not in name and name not in known]
    return [*asked, *(parse_quantity(name, form.sample) for name in further)]


def _changed_answers(
    form: Form, found: Mapping[str, _Number], name: str, variants: Sequence[Variant], asked: Sequence[Quantity]
) -> list[str]:
    """Names of the asked quantities that change with a number."""
    whole = {other: Decimal(repr(number.value)) for other, number in found.items()}
    moved = {**whole, name: whole[name] * (1 + Decimal(repr(_CHANGE)))}
    batch = [replace(v, form=form, printed={**v.printed, **own}) for own in (whole, moved) for v in variants]
    motion = solve_variants(batch, motion_order(asked))
    solved = (motion.outcome == Outcome.SOLVED).reshape(2, -1).all(axis=0)
    values = {q: np.reshape(q.value(motion), (2, -1)) for q in asked}
    sizes: dict[str, float] = {}
    for q, both in values.items():
        largest = float(np.max(np.abs(both[:, solved]), initial=0.0, where=np.isfinite(both[:, solved])))
        sizes[q.unit("m").name] = max(sizes.get(q.unit("m").name, 0.0), largest)
    return [q.name for q, both in values.items() if np.any(_differs(q, both[:, solved], sizes[q.unit("m").name]))]


def _differs(quantity: Quantity, values: NDArray[np.float64], size: float) -> NDArray[np.bool_]:
    """Whether an answer before and after, the rows of ``values``, is another one.

    ``size`` is that of all answers in the same unit: beside it an answer of zero is rounding.
    """
    with np.errstate(invalid="ignore"):  # what has no value is infinite, before and after
        change = values[1] - values[0]
        if quantity.is_angle:
            return np.asarray(np.abs(np.angle(np.exp(1j * change))) > _NOTHING)
        return np.asarray(np.abs(change) > _NOTHING * np.abs(values[0]) + _ROUNDING * size)


def _told(variant: Variant, asked: Sequence[Quantity], language: Language) -> list[tuple[float, str]]:
    """The numbers that the sheet of a variant tells beside parameters: absolute values in SI and what they measure."""
    said = statement(variant, asked, language)
    sheet = read_sheet(said, variant.form, language)
    return [(abs(number.value), number.measures) for number in sheet.numbers] + _plain_decimals(said)


def _plain_decimals(said: Statement) -> list[tuple[float, str]]:
    """Decimals in the text, as those of ratios."""
    texts = [part for part in said.text if isinstance(part, str)]
    return [(float(number.replace(",", ".")), "") for text in texts for number in _DECIMAL.findall(text)]


def _is_said(number: _Number, said: Sequence[tuple[float, str]]) -> bool:
    return any(
        number.measures == measures and abs(number.value - value) <= _EQUAL * number.value for value, measures in said
    )


def _with_numbers(form: Form) -> tuple[Form, dict[str, _Number]]:
    """The form with its own numbers as further parameters."""
    found: dict[str, _Number] = {}
    known: dict[tuple[float, str], str] = {}

    def change(part: Expression, place: str) -> Expression | None:
        size = _size(part)
        if size is None:
            return None
        value, measures = size
        key = (float(f"{abs(value):.12g}"), measures)
        name = known.setdefault(key, f"number {len(known) + 1}")  # no name of a file has a space
        places = found.setdefault(name, _Number(abs(value), measures, [])).places
        if place not in places:
            places.append(place)
        return Total(((1 if value > 0 else -1, Variable(name)),))

    changed = changed_numbers(form, change)
    further = {
        name: Parameter(name, UNITS[_SI.get(number.measures, "1")], (Decimal(repr(number.value)),), symbol=name)
        for name, number in found.items()
    }
    return replace(changed, parameters={**form.parameters, **further}), found


def _size(part: Expression) -> tuple[float, str] | None:
    """The value (SI) of a part of an expression that is one number of the file, and what it measures; else None."""
    size = number_of(part)
    return None if size is None or _needs_no_number(*size) else size


def _needs_no_number(value: float, measures: str) -> bool:
    """Whether nothing need be told, or words do: zero, whole numbers and quarters, right angles and the like."""
    if measures == "angle":
        return any(abs(math.remainder(value, step)) < _EQUAL for step in _IN_WORDS)
    return value == 0 or (not measures and (_QUARTERS * value).is_integer())
