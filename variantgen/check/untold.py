"""Numbers of a form that no sheet tells and on which what is asked depends: such a problem cannot be solved.

Every number that stands in the file itself, in points, conditions, joints, drivers and what is derived, is changed a
little while everything that is printed stays; what follows from it follows, and the mechanism is solved anew. Numbers
of the same size and measure are taken for one that stands in several places, and changed together.

Some numbers are told in words and are left alone: whole ones and quarters without a unit ("the midpoint", the 2 of a
formula), right angles, their halves, and the angle of an equilateral triangle.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Variable,
)
from variantgen.algebra.values import walk
from variantgen.check.statement_reading import read_sheet
from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.parameters.expressions import FamilyExpression
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

    def written(self, length_unit: str) -> str:
        """The number with its unit, for a message."""
        if not self.measures:
            return f"{self.value:.6g}"
        own = unit({"length": length_unit, "angle": "deg"}.get(self.measures, _SI[self.measures]))
        return f"{own.from_si(self.value):.6g} {own.name}"


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
    asked = _askable(variants[0], asked)
    form, found = _with_numbers(variants[0].form, is_scene=family.folder is None)
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
            written = number.written(family.length_unit)
            yield Untold(
                ", ".join(number.places[:_PLACES]), _message(written, wrong or changed, bool(wrong)), bool(wrong)
            )


def _message(number: str, dependent: Sequence[str], asked: bool) -> str:
    """What is wrong with a number, and what to do; ``asked``: the quantities that depend on it are asked."""
    depend = f"{', '.join(dependent)} {'depends' if len(dependent) == 1 else 'depend'} on it"
    otherwise = "" if asked else ", which may be asked; name in may_ask what can be found from the sheet, or"
    remedy = "make it a parameter, which is printed, derive it from parameters, or let the statement tell it"
    return f"the number {number} is on no sheet, and {depend}{otherwise or ';'} {remedy}"


def _askable(variant: Variant, asked: Sequence[Quantity]) -> list[Quantity]:
    """What is asked, and of a family what may be asked."""
    form, known = variant.form, {quantity.name for quantity in asked}
    if variant.family.folder is None:
        return list(asked)
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
    numbers = list(sheet.numbers)
    if variant.family.folder is None:
        numbers += [number for data in sheet.data.values() for number in data]
    return [(abs(number.value), number.measures) for number in numbers] + _plain_decimals(said)


def _plain_decimals(said: Statement) -> list[tuple[float, str]]:
    """Decimals in the text, as those of ratios."""
    texts = [part for part in said.text if isinstance(part, str)]
    return [(float(number.replace(",", ".")), "") for text in texts for number in _DECIMAL.findall(text)]


def _is_said(number: _Number, said: Sequence[tuple[float, str]]) -> bool:
    return any(
        number.measures == measures and abs(number.value - value) <= _EQUAL * number.value for value, measures in said
    )


def _with_numbers(form: Form, is_scene: bool) -> tuple[Form, dict[str, _Number]]:
    """The form with its own numbers as further parameters.

    Left out are the laws of motion of a scene and the numbers in it that stand for themselves: they have names of their
    own on its sheet (:mod:`variantgen.families.literal_data`).
    """
    printed = {f"{law}{order}" for law in form.laws for order in ("", "_dot", "_ddot")} if is_scene else set()
    found: dict[str, _Number] = {}
    known: dict[tuple[float, str], str] = {}

    def variable(value: float, measures: str, place: str) -> Expression:
        key = (float(f"{abs(value):.12g}"), measures)
        name = known.setdefault(key, f"number {len(known) + 1}")  # no name of a file has a space
        places = found.setdefault(name, _Number(abs(value), measures, [])).places
        if place not in places:
            places.append(place)
        return Total(((1 if value > 0 else -1, Variable(name)),))

    def read(item: Any, place: str) -> Any:
        if isinstance(item, tuple):
            return tuple(read(part, f"{place}.{i + 1}") for i, part in enumerate(item))
        if isinstance(item, ComponentTemplate):
            kind = item.component.__module__.rpartition(".")[2]
            fields = {field: read(value, f"{place}.{kind}.{field}") for field, value in item.fields.items()}
            return ComponentTemplate(item.component, fields)
        if not isinstance(item, FamilyExpression) or (is_scene and not item.names):
            return item

        def change(part: Expression) -> Expression | None:
            size = _size(part)
            return size and variable(*size, f'{place} = "{item.text}"' if item.names else place)

        return FamilyExpression(item.text, _rewritten(item.tree, change))

    tables: dict[str, Any] = {
        table: {
            name: item if name in printed else read(item, f"{table}.{name}")
            for name, item in getattr(form, table).items()
        }
        for table in ("derived", "points")
    }
    lists = {name: read(getattr(form, name), name) for name in ("conditions", "joints", "drivers")}
    further = {
        name: Parameter(name, UNITS[_SI.get(number.measures, "1")], (Decimal(repr(number.value)),), symbol=name)
        for name, number in found.items()
    }
    return replace(form, **tables, **lists, parameters={**form.parameters, **further}), found


def _size(item: Expression) -> tuple[float, str] | None:
    """The value (SI) of a part of an expression that is one number of the file, and what it measures; else None."""
    match item:
        case Constant(value, measures) if measures in _SI:
            size = value, measures
        case Constant(value):
            size = value, ""
        case Times((factor, Variable(name))) if name == "deg" or name in _LENGTHS:
            if any(isinstance(part, Variable) for part in walk(factor)):
                return None
            size = float(FamilyExpression("", item).value({})), "angle" if name == "deg" else "length"
        case _:
            return None
    return None if _needs_no_number(*size) else size


def _needs_no_number(value: float, measures: str) -> bool:
    """Whether nothing need be told, or words do: zero, whole numbers and quarters, right angles and the like."""
    if measures == "angle":
        return any(abs(math.remainder(value, step)) < _EQUAL for step in _IN_WORDS)
    return value == 0 or (not measures and (_QUARTERS * value).is_integer())


def _rewritten(item: Expression, change: Callable[[Expression], Expression | None]) -> Expression:
    """An expression with those parts replaced for which ``change`` has something else."""
    other = change(item)
    if other is not None:
        return other
    parts = [_rewritten(part, change) for part in item.operands()]
    match item:
        case Total(terms):
            return Total(tuple((sign, part) for (sign, _), part in zip(terms, parts, strict=True)))
        case Times():
            return Times(tuple(parts))
        case Raised(_, exponent):
            return Raised(parts[0], exponent)
        case Applied(function):
            return Applied(function, *parts)
        case Ratio() | SquareRoot() | Magnitude():
            return type(item)(*parts)
    return item
