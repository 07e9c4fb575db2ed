"""Numbers of a scene that its sheet leaves open and on which what is asked depends.

The sheet of a scene is made of its numbers by the program, and may state others in their place: the sides of a triangle
for a place on a plate. So every number of the file is changed a little, one after the other, and the sheet is read each
time. A change of several numbers together that leaves the whole sheet as it is must leave every answer as it is: with
the rates J of what is printed, and K of what is asked, ``J n = 0`` demands ``K n = 0``.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from variantgen.algebra.expression import Constant, Expression
from variantgen.check.form_numbers import changed_numbers, number_of
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity, motion_order
from variantgen.resources import languages
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Measured, Symbol, to_plain
from variantgen.wording.language import Language, load_language
from variantgen.wording.statement import statement

_CHANGE = 1e-3  # relative: so much a number is changed
_EQUAL = 1e-9
_OPEN = 0.02  # of the largest rate of an answer: what the six digits of a sheet leave undecided
_SEEN = 1e-3  # relative rates below it are rounding of the sheet
_RANK = 5e-3  # of the largest singular value


@dataclass(frozen=True)
class StatedNumber:
    """A number of the file: its value (SI), what it measures ("" nothing), and the places that have it together."""

    value: float
    measures: str
    places: tuple[int, ...]
    names: tuple[str, ...]

    @property
    def place(self) -> str:
        """The places as the file names them."""
        return ", ".join(self.names)


def undetermined(variant: Variant, asked: Sequence[Quantity]) -> Iterator[tuple[StatedNumber, list[str]]]:
    """The numbers of a scene that its sheet leaves open, each with the names of the answers that depend on it."""
    motion = solve_variants([variant], 0)
    size = float(motion.length_scale()[0])
    seen = _below_centres(variant.form, {name: complex(z[0]) for name, z in motion.z.items()}, size)
    numbers = [own for number in _numbers(variant.form, seen) for own in _each_or_together(variant, number, size)]
    if not numbers:
        return
    language = load_language(languages()[0])
    printed = _printed(variant, asked, language)
    seen_rates: list[dict[str, float]] = []
    answers: list[list[float]] = []
    for i, number in enumerate(numbers):
        ahead, behind = (_changed(variant, number, sign * _CHANGE, size) for sign in (1, -1))
        sheets = [_printed(other, asked, language) for other in (ahead, behind)]
        if any(sheet.keys() != printed.keys() for sheet in sheets):  # another datum on the sheet: it is seen
            seen_rates.append({str(i): 1.0})
        else:
            seen_rates.append(_rates(sheets[0], sheets[1], printed))
        answers.append(_answer_rates(ahead, behind, asked))
    lines = dict.fromkeys(name for rates in seen_rates for name in rates)
    sheet = np.array([[rates.get(name, 0.0) for rates in seen_rates] for name in lines]).reshape(
        len(lines), len(numbers)
    )
    sought = np.array(answers).T
    free = _null_space(sheet)
    left = np.abs(sought @ free)
    largest = np.max(np.abs(sought), axis=1, initial=0.0)
    for column, number in enumerate(numbers):
        names = [q.name for q, row, most in zip(asked, left, largest, strict=True) if row[column] > _OPEN * most > 0]
        if names:
            yield number, names


def _numbers(form: Form, seen: Collection[str]) -> list[StatedNumber]:
    """The numbers of a file, each with the places where it stands, but those ``seen`` in the figure.

    Laws of time stand on the sheet as they are.
    """
    found: dict[tuple[float, str, int], list[tuple[int, str]]] = {}
    count = 0

    def note(part: Expression, place: str) -> Expression | None:
        nonlocal count
        size = number_of(part)
        if size is None:
            return None
        value, measures = size
        if place not in seen and not _needs_no_number(value, measures, place):
            apart = count if value == 0 else -1  # zeros have nothing to do with each other
            found.setdefault((float(f"{value:.12g}"), measures, apart), []).append((count, place))
        count += 1
        return part

    changed_numbers(form, note, _laws(form))
    return [
        StatedNumber(value, measures, tuple(i for i, _ in places), tuple(dict.fromkeys(name for _, name in places)))
        for (value, measures, _), places in found.items()
    ]


def _below_centres(form: Form, at: Mapping[str, complex], size: float) -> set[str]:
    """The coordinates of contacts of wheels right below, above or beside their centres: the figure shows it."""
    found = set()
    for template in form.joints:
        if {"centre", "contact"} <= template.fields.keys():
            contact = template.fields["contact"]
            arm = at[contact] - at[template.fields["centre"]]
            found |= {
                f"points.{contact}.coordinates.{axis}"
                for axis, across in (("x", arm.real), ("y", arm.imag))
                if abs(across) < _EQUAL * size
            }
    return found


def _laws(form: Form) -> frozenset[str]:
    return frozenset(f"{law}{order}" for law in form.laws for order in ("", "_dot", "_ddot"))


def _needs_no_number(value: float, measures: str, place: str) -> bool:
    """Whether the figure tells it: right angles, sides, and zeros but those of coordinates."""
    if measures == "angle":
        return abs(math.remainder(value, math.pi / 2)) < _EQUAL
    return place.endswith((".side", ".branch")) or (value == 0 and ".coordinates." not in place)


def _each_or_together(variant: Variant, number: StatedNumber, size: float) -> list[StatedNumber]:
    """A number place by place; all together where the mechanism contradicts itself otherwise; nothing if even then."""
    whole = zip(number.places, number.names, strict=False) if len(number.names) == len(number.places) else ()
    apart = [replace(number, places=(index,), names=(name,)) for index, name in whole]
    for choice in (apart, [number]):
        if choice and all(_is_solved(variant, own, size) for own in choice):
            return choice
    return []


def _is_solved(variant: Variant, number: StatedNumber, size: float) -> bool:
    both = [_changed(variant, number, sign * _CHANGE, size) for sign in (1, -1)]
    return all(bool(solve_variants([other], 1).solved[0]) for other in both)


def _changed(variant: Variant, number: StatedNumber, by: float, size: float) -> Variant:
    """The variant with one number changed by a part of itself, or of the size of the mechanism where it is zero."""
    count = 0

    def change(part: Expression, place: str) -> Expression | None:
        nonlocal count
        found = number_of(part)
        if found is None:
            return None
        count += 1
        value, measures = found
        return Constant(value + by * (value or size), measures) if count - 1 in number.places else part

    return replace(variant, form=changed_numbers(variant.form, change, _laws(variant.form)))


def _printed(variant: Variant, asked: Sequence[Quantity], language: Language) -> dict[str, float]:
    """The numbers of a sheet by what stands before them, or by their order in the text.

    Letters in the text are zeros with their names: what is said in words, as that a guide passes through O, is seen to
    be no longer true.
    """
    said = statement(variant, asked, language)
    found = [(to_plain(e.left), e.right.number) for e in said.given if isinstance(e.right, Measured)]
    found += [("", part.number) for part in said.text if isinstance(part, Measured)]
    said_of = {f"of {to_plain(part)} {i}": 0.0 for i, part in enumerate(said.text) if isinstance(part, Symbol)}
    return said_of | {f"{name} {i}": float(Fraction(_plain(number.text))) for i, (name, number) in enumerate(found)}


def _plain(number: str) -> str:
    return number.replace(",", ".").replace("\N{MINUS SIGN}", "-")


def _rates(ahead: Mapping[str, float], behind: Mapping[str, float], here: Mapping[str, float]) -> dict[str, float]:
    """How fast the numbers of a sheet change, of their size; what rounding alone may do is nothing."""
    largest = max(map(abs, here.values()), default=1.0)
    found = {name: (ahead[name] - behind[name]) / (2 * _CHANGE * (abs(size) or largest)) for name, size in here.items()}
    return {name: rate for name, rate in found.items() if abs(rate) > _SEEN}


def _answer_rates(ahead: Variant, behind: Variant, asked: Sequence[Quantity]) -> list[float]:
    """How fast the answers change (SI)."""
    found = []
    for quantity in asked:
        values = [float(quantity.value(solve_variants([other], motion_order(asked)))[0]) for other in (ahead, behind)]
        gap = values[0] - values[1]
        found.append(math.remainder(gap, math.tau) if quantity.is_angle else gap)
    return [gap / (2 * _CHANGE) if math.isfinite(gap) else 0.0 for gap in found]


def _null_space(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """The projection on what the rows do not see, shape (numbers, numbers)."""
    largest = np.max(np.abs(rows), axis=1, initial=0.0, keepdims=True)
    seen = (rows / np.where(largest > 0, largest, 1.0))[largest[:, 0] > 0]
    if not len(seen):
        return np.eye(rows.shape[1])
    _, sizes, ways = np.linalg.svd(seen)
    rank = int(np.sum(sizes > _RANK * sizes[0]))
    return np.asarray(ways[rank:].T @ ways[rank:])
