"""Numbers of a file that its sheets leave open and on which what is asked depends: such a problem cannot be solved.

Every number that stands in the file itself, in points, conditions, joints, drivers and what is derived, is changed a
little, one after the other, while the parameters stay; what follows from it follows, the mechanism is solved and the
sheet is read anew. The sheet may state other numbers in their place: the sides of a triangle for a place on a plate. So
a change of several numbers together that leaves the whole sheet as it is must leave every answer as it is: with the
rates J of what is printed, and K of what is asked, ``J n = 0`` demands ``K n = 0``.

The statement of a family is in the words of its author, which stay as they are: a number that stands in them in every
language is told. Whole ones and quarters without a unit ("the midpoint", the 2 of a formula), right angles, their
halves, and the angle of an equilateral triangle are told in other words. The sheet of a scene is made by the program;
what is not on it, its figure may tell.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Expression
from variantgen.check.answer_rates import CHANGE, AnswerRates, Numbers
from variantgen.check.form_numbers import SI, FileNumber, file_numbers, with_numbers
from variantgen.check.sheet_numbers import numbers_in_words, printed_numbers, sheet_rates
from variantgen.families.family import Form
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.resources import languages
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language

_EQUAL = 1e-9
_OPEN = 0.02  # of the largest rate of an answer: what the six digits of a sheet leave undecided
_RANK = 5e-3  # of the largest singular value
_IN_WORDS = (math.pi / 4, math.pi / 3)  # angles whose multiples are told in words: right angles, equilateral triangles
_QUARTERS = 4
_PLACES = 3  # that are named


class Untold(Struct, frozen=True):
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
        left_out, numbers = _laws(variants[0].form), _numbers_of_scene(variants[0])
    else:
        asked = _askable(variants[0], asked)
        left_out, numbers = frozenset[str](), _numbers_of_family(variants, asked)
    if not numbers:
        return
    for number, changed in _dependent(variants, left_out, numbers, asked):
        wrong = [name for name in changed if name in names]
        value = number.value if family.is_scene else abs(number.value)
        written = _written(value, number.measures, family.length_unit)
        places = ", ".join(list(dict.fromkeys(number.names))[:_PLACES])
        yield Untold(places, _message(written, wrong or changed, bool(wrong)), bool(wrong))


def _written(value: float, measures: str, length_unit: str) -> str:
    """A number with its unit, for a message."""
    if not measures:
        return f"{value:.6g}"
    own = unit({"length": length_unit, "angle": "deg"}.get(measures, SI[measures]))
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


def _numbers_of_family(variants: Sequence[Variant], asked: Sequence[Quantity]) -> list[FileNumber]:
    """The numbers of a file that the words of some variant do not say; one in several places is one and the same."""

    def is_in_other_words(value: float, measures: str, _: str) -> bool:
        if measures == "angle":
            return any(_is_multiple(value, step) for step in _IN_WORDS)
        return value == 0 or (not measures and (_QUARTERS * value).is_integer())

    found = file_numbers(variants[0].form, frozenset(), is_in_other_words)
    if not found:
        return []
    sheets = [numbers_in_words(variant, asked, load_language(name)) for variant in variants for name in languages()]
    return [number for number in found if not all(_is_said(number, sheet) for sheet in sheets)]


def _is_said(number: FileNumber, said: Sequence[tuple[float, str]]) -> bool:
    size = abs(number.value)
    return any(number.measures == measures and abs(size - value) <= _EQUAL * size for value, measures in said)


def _numbers_of_scene(variant: Variant) -> list[FileNumber]:
    """The numbers of a scene that its figure does not tell: right angles, sides, and zeros but those of coordinates.

    The figure shows also that a wheel touches right below, above or beside its centre. Laws of time stand on the sheet
    as they are.
    """
    motion = solve_variants([variant], 0)
    shown = set()
    for template in variant.form.joints:
        if {"centre", "contact"} <= template.fields.keys():
            contact = template.fields["contact"]
            arm = complex(motion.z[contact][0] - motion.z[template.fields["centre"]][0])
            shown |= {
                f"points.{contact}.coordinates.{axis}"
                for axis, across in (("x", arm.real), ("y", arm.imag))
                if abs(across) < _EQUAL * motion.length_scale()[0]
            }

    def is_in_figure(value: float, measures: str, place: str) -> bool:
        if measures == "angle":
            return _is_multiple(value, math.pi / 2)
        zero = value == 0 and ".coordinates." not in place
        return zero or place.endswith((".side", ".branch")) or place in shown

    return file_numbers(variant.form, _laws(variant.form), is_in_figure)


def _is_multiple(angle: float, step: float) -> bool:
    return abs(math.remainder(angle, step)) < _EQUAL


def _laws(form: Form) -> frozenset[str]:
    return frozenset(f"{law}{order}" for law in form.laws for order in ("", "_dot", "_ddot"))


def _dependent(
    variants: Sequence[Variant], left_out: frozenset[str], numbers: Sequence[FileNumber], asked: Sequence[Quantity]
) -> Iterator[tuple[FileNumber, list[str]]]:
    """The numbers on which answers depend and that the sheets of some variant leave open, with those answers."""
    answers = AnswerRates(variants, left_out, asked)
    # The sheet of a scene tells each place by itself, unless the mechanism contradicts itself if they differ.
    apart = [number.apart if variants[0].family.is_scene else [] for number in numbers]
    tried = [own for number, parts in zip(numbers, apart, strict=True) for own in (*parts, number)]
    rates, solved = answers.of(tried)
    order = {own: place for place, own in enumerate(tried)}
    chosen = [
        order[own]
        for number, parts in zip(numbers, apart, strict=True)
        for own in (parts if parts and all(np.all(solved[order[part]]) for part in parts) else [number])
        if np.any(solved[order[own]])
    ]
    if not chosen or not np.any(rates[:, chosen]):
        return
    open_for = np.zeros((len(asked), len(chosen)), dtype=bool)
    for place, variant in enumerate(variants):
        sheet = _sheet(variant, left_out, [tried[i] for i in chosen], asked, answers.sizes[place])
        sought = rates[:, chosen, place]
        left = np.abs(sought @ _null_space(sheet))
        undecided = _OPEN * np.max(np.abs(sought), axis=1, initial=0.0, keepdims=True) * bool(np.any(sheet))
        open_for |= (left > undecided) & (left > answers.least[:, place, None])
    for column, number in enumerate(chosen):
        names = [q.name for q, is_open in zip(asked, open_for[:, column], strict=True) if is_open]
        if names:
            yield tried[number], names


def _sheet(
    variant: Variant, left_out: frozenset[str], numbers: Sequence[FileNumber], asked: Sequence[Quantity], size: float
) -> Numbers:
    """The rates of what is printed, shape (printed numbers, numbers of the file)."""
    language = load_language(languages()[0])

    def changed(number: FileNumber, by: float) -> dict[str, float]:
        def moved(value: float, measures: str) -> Expression:
            return Constant(value + by * (value or size), measures)

        form = with_numbers(variant.form, left_out, dict.fromkeys(number.places, moved))
        return printed_numbers(replace(variant, form=form), asked, language)

    here = printed_numbers(variant, asked, language)
    rates = [
        found
        if (found := sheet_rates(changed(number, CHANGE), changed(number, -CHANGE), here, CHANGE)) is not None
        else {f"another datum by {i}": 1.0}
        for i, number in enumerate(numbers)
    ]
    lines = dict.fromkeys(name for own in rates for name in own)
    return np.array([[own.get(name, 0.0) for own in rates] for name in lines]).reshape(len(lines), len(numbers))


def _null_space(rows: Numbers) -> Numbers:
    """The projection on what the rows do not see, shape (numbers, numbers)."""
    largest = np.max(np.abs(rows), axis=1, initial=0.0, keepdims=True)
    seen = (rows / np.where(largest > 0, largest, 1.0))[largest[:, 0] > 0]
    if not len(seen):
        return np.eye(rows.shape[1])
    _, sizes, ways = np.linalg.svd(seen)
    rank = int(np.sum(sizes > _RANK * sizes[0]))
    return np.asarray(ways[rank:].T @ ways[rank:])
