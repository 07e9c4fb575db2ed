"""Every printed line is recomputed from its printed numbers, and no number has more digits than a hand would write.

After "=" a reader with a calculator gets the printed number but for one in its last digit (1.5 units, by rounding),
and where angles are added the printed number itself; after "≈" what it misses by is small beside the number.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from contextlib import nullcontext, suppress

import pytest
from msgspec import Struct
from msgspec.structs import astuple

from tests.calculator import UnreadableError, evaluate, last_unit
from tests.methods.applying import cases
from tests.methods.forms import FORMS
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.motion import Motion
from variantgen.methods.solution_options import SolutionOptions
from variantgen.variants.draw import FamilySampler
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Equation, Formula, Measured, Number, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import FormulaLine, FormulaLines, Program, SolutionText
from variantgen.wording.solution.explain import explain
from variantgen.wording.statement import given

SEEDS = 4
CASES, IDS = cases("projections", "velocity_pole", "acceleration_centre")
NEAR = 0.02  # by how much a number after "≈" may be off
COMPONENTS = (" x", " y", " n", " t", " τ", " ξ", " η")  # along an axis, with a sign
DIGITS = 4  # significant digits of a printed number
ANGLES_ADDED = re.compile(r"[−(]*[\d.,]+°(/2)?\)?( ?[+−] ?\(?[\d.,]+°(/2)?\)?)+")
ANGLE_DECIMALS = 2


def variants(name: str, form: str) -> tuple[list[Variant], Motion]:
    family = restrict(load_family(name), None, None, (form,) if form else ())
    drawn = FamilySampler(family, None).after([("recomputed", i) for i in range(SEEDS)], [0] * SEEDS)
    asked = read_ask(drawn[0].form)
    return drawn, solve_variants(drawn, max(q.order for q in asked))


class Reader:
    """Goes through a solution with a calculator and notes what does not come out."""

    def __init__(self, known: dict[str, float], mark: str) -> None:
        self.known = known
        self.mark = mark
        self.wrong: list[str] = []
        self.checked = 0
        self.one_side: tuple[float, float] | None = None
        self.printed: dict[str, float] = {}
        self.halves: dict[str, float] = {}  # half a unit of the last digit of what has been computed
        self.waiting: list[tuple[str, str, str]] = []
        self.last = ""

    def read(self, found: SolutionText) -> None:
        for line in lines_of(found):
            self.line(line)
        self.eliminate()
        assert not self.waiting, f"equations without a solution: {self.waiting}"
        assert self.one_side is None, "an equation with one side"

    def line(self, line: FormulaLine) -> None:
        texts = [to_plain(formula) for _, formula in line.pieces]
        whole = " = ".join(texts)
        if "\u20d7" in whole:
            return  # an equation of vectors has no numbers
        if any(sign == "<" for sign, _ in line.pieces):
            self.rising([(sign, text) for (sign, _), text in zip(line.pieces, texts, strict=True)], whole)
            return
        result = line.pieces[-1][1]
        in_numbers = not re.search(r"[^\W\d]_|[A-Z]{2}|[xyz]", texts[0])
        if isinstance(result, Number) and in_numbers:
            self.side(texts, line.pieces[-1][0], whole)
            return
        if len(texts) == 1:
            return  # a chain of links
        if not isinstance(result, Measured):
            self.waiting.append((texts[0], texts[1], whole))
            if re.fullmatch("[a-zα-ω]", texts[0]):
                self.known.setdefault(texts[0], evaluate(texts[1], self.known, self.mark))  # a law says what it is
            self.settle()
            return
        number = result.number.text
        value = number_of(number, self.mark)
        unit = 10.0**-ANGLE_DECIMALS if result.unit.tight else last_unit(number, self.mark, DIGITS)
        nameless = in_numbers and re.match(r"[−(]*\d", texts[0])  # a sum in numbers, which has no symbol
        for text in texts[:-1] if nameless else texts[1:-1]:
            # A law may go before what it comes down to: εR = a_O, where no number of ε is written.
            with suppress(UnreadableError) if len(texts) > 3 else nullcontext():
                self.compare(text, value, unit, line.pieces[-1][0], whole)
        if value < 0 and re.match(r"\(?[va][_^]", texts[0]) and not texts[0].endswith(COMPONENTS):
            self.wrong.append(f"{whole}: a vector that points against its direction")
        if 0 < abs(value - self.printed.get(texts[0], value)) < NEAR * abs(value):
            self.wrong.append(f"{whole}: another number than before, {self.printed[texts[0]]}")
        self.printed[texts[0]] = value
        self.known[texts[0]], self.halves[texts[0]] = value, unit / 2
        self.settle()

    def rising(self, pieces: list[tuple[str, str]], whole: str) -> None:
        """Numbers each of which is smaller than the next, some with the sum from which they come."""
        before = -math.inf
        for sign, text in pieces:
            found = evaluate(text, self.known, self.mark)
            if sign in ("=", "≈"):
                self.compare(self.last, found, last_unit(text, self.mark, DIGITS), sign, whole)
            elif found <= before:
                self.wrong.append(f"{whole}: {found:.9g} is not larger than {before:.9g}")
            before, self.last = found, text
        self.checked += 1

    def side(self, texts: list[str], sign: str, whole: str) -> None:
        """One side of an equation, which has another after it: a sum in numbers, and its number."""
        if len(texts) > 2:  # a side that is a number, and the other
            self.side(texts[:1], "", whole)
            texts = texts[1:]
        value = number_of(texts[-1], self.mark)
        if len(texts) > 1:
            unit = last_unit(texts[-1], self.mark, DIGITS)
            self.compare(texts[0], value, unit, sign, whole)
        doubt = self.doubt(texts[0])
        if self.one_side is None:
            self.one_side = (value, doubt) if value else None  # a sum that comes to nothing is the whole equation
            return
        (other, before), self.one_side = self.one_side, None
        if abs(value - other) > 1.01 * (doubt + before):
            self.wrong.append(f"{whole}: the other side is {other}")

    def compare(self, text: str, wanted: float, unit: float, sign: str, where: str) -> None:
        """What a reader gets from a text: the number but for one in its last digit, or nearly that by rounding."""
        found = evaluate(text, self.known, self.mark)
        self.checked += 1
        allowed = (0.6 if ANGLES_ADDED.fullmatch(text) else 1.5) * unit
        if sign == "≈":
            by_rounding = 1.01 * self.doubt(text) + unit
            allowed = max(allowed, min(by_rounding, NEAR * abs(wanted) or by_rounding))
        if abs(found - wanted) > allowed * (1 + 1e-9):
            self.wrong.append(f"{where}: {sign} {wanted}, but {found:.9g}")

    def eliminate(self) -> None:
        """Work out the root that a system has and the text does not print from one equation: the others must hold."""
        sides = [(left, right) for left, right, _ in self.waiting]
        missing = {name for pair in sides for text in pair for name in re.findall(r"[αε]_\w+\sz", text)} - {*self.known}
        if len(missing) != 1:
            return
        (name,), roots = missing, []
        for left, right in sides:
            at = [dict(self.known, **{name: trial}) for trial in (0.0, 1.0)]
            zero, one = (evaluate(left, found, self.mark) - evaluate(right, found, self.mark) for found in at)
            self.known[name] = -zero / (one - zero)
            roots.append((((self.doubt(left) + self.doubt(right)) / abs(one - zero)), self.known[name]))
        self.halves[name], self.known[name] = min(roots)
        self.settle()

    def settle(self) -> None:
        """Put what has been found back into the equations that led to it, those first that say what a letter is."""
        for item in sorted(self.waiting, key=lambda item: not re.fullmatch(r"\(?[va][_^]\S+", item[0])):
            left, right, whole = item
            if left not in self.known and re.fullmatch(r"\(?[va][_^]\S+", left):
                with suppress(ValueError):
                    self.known[left] = evaluate(right, self.known, self.mark)  # v_BC = ω_BCD · BC
                    self.halves[left] = self.doubt(right)
            try:
                sides = [evaluate(side, self.known, self.mark) for side in (left, right)]
            except ValueError:
                continue
            self.waiting.remove(item)
            self.checked += 1
            if abs(sides[0] - sides[1]) > 1.01 * (self.doubt(left) + self.doubt(right)) + 1e-9 * abs(sides[0]):
                self.wrong.append(f"{whole}: {sides[0]:.9g} and {sides[1]:.9g}")

    def doubt(self, text: str) -> float:
        """By how much the value of a text may be off since the printed numbers in it are rounded."""
        middle = evaluate(text, self.known, self.mark)
        off = 0.0
        for name, half in self.halves.items():
            if name in text:
                off += abs(evaluate(text, {**self.known, name: self.known[name] + half}, self.mark) - middle)
        for found in re.finditer(rf"(?<![\d^_])\d+(?:{re.escape(self.mark)}\d+°?|\d{{3,}})", text):
            half = 0.5 * (10.0**-ANGLE_DECIMALS if found[0].endswith("°") else last_unit(found[0], self.mark, DIGITS))
            other = f"{number_of(found[0].rstrip('°'), self.mark) + half:.9f}".replace(".", self.mark)
            changed = text[: found.start()] + other + text[found.end() :]
            off += abs(evaluate(changed, self.known, self.mark) - middle)
        return off


def lines_of(found: SolutionText) -> Iterator[FormulaLine]:
    for blocks in (*(section.blocks for section in found.sections), found.check):
        for block in blocks:
            if isinstance(block, FormulaLines):
                yield from block.lines


def number_of(text: str, mark: str) -> float:
    """The number that a text stands for."""
    return float(text.replace("−", "-").replace(mark, "."))


def numbers_in(formula: Formula) -> Iterator[tuple[str, bool]]:
    """The printed numbers of a formula, and whether they are angles in degrees."""
    match formula:
        case Measured(Number(text), unit):
            yield text, unit.tight
        case Number(text):
            yield text, False
        case Struct():
            yield from numbers_in(astuple(formula))
        case tuple():
            for part in formula:
                yield from numbers_in(part)


def all_numbers(found: SolutionText) -> Iterator[tuple[str, bool]]:
    """The printed numbers of the steps, the check and the answer."""
    for blocks in (*(section.blocks for section in found.sections), found.check):
        for block in blocks:
            if not isinstance(block, Program):
                yield from numbers_in(block)
    yield from numbers_in(found.answer)


def too_long(text: str, is_angle: bool, data: set[float], mark: str) -> bool:
    """Whether a number has more digits than a hand would write; the data have as many as the statement gives."""
    if abs(number_of(text, mark)) in data:
        return False
    digits = text.strip("−-").replace(mark, "").lstrip("0")
    if mark not in text:
        digits = digits.rstrip("0")
    decimals = len(text.partition(mark)[2])
    return decimals > ANGLE_DECIMALS if is_angle else len(digits) > DIGITS


def last_of(found: SolutionText) -> dict[str, str]:
    """The numbers that lines end with, by symbol."""
    pieces = [line.pieces for line in lines_of(found)]
    return {to_plain(p[0][1]): p[-1][1].number.text for p in pieces if isinstance(p[-1][1], Measured)}


def check_digits(found: SolutionText, known: dict[str, float], mark: str) -> None:
    """No number is too long, and an answer is printed with the digits that its step leads to."""
    data = {abs(number) for number in known.values()}
    long = [text for text, is_angle in all_numbers(found) if too_long(text, is_angle, data, mark)]
    assert not long, long
    lines = last_of(found)
    for part in found.answer:
        if isinstance(part, Equation) and isinstance(part.right, Measured) and to_plain(part.left) in lines:
            steps, answer = (number_of(text, mark) for text in (lines[to_plain(part.left)], part.right.number.text))
            assert abs(steps) == abs(answer), to_plain(part)


def known_data(variant: Variant, asked: list, language_name: str) -> tuple[dict[str, float], str]:
    language = load_language(language_name)
    known = {}
    for equation in given(variant, asked, language):
        text = equation.right.number.text.replace("−", "-").replace(language.decimal_mark, ".")
        known[to_plain(equation.left)] = float(text)
    for name in variant.form.figure.graph:  # read off at first
        symbol = language.symbol(variant.form.parameters[name].symbol, variant.form.symbols)
        known[to_plain(symbol)] = float(abs(variant.printed[name]))
    return known, language.decimal_mark


@pytest.mark.parametrize(("name", "form"), FORMS, ids=["-".join(item) for item in FORMS])
def test_every_printed_equation_comes_out(name: str, form: str) -> None:
    drawn, motion = variants(name, form)
    for index, variant in enumerate(drawn):
        asked = read_ask(variant.form)
        language_name = ("en", "ru")[index % 2]
        found = explain(variant, motion, index, asked, load_language(language_name))
        check_digits(found, *known_data(variant, asked, language_name))
        reader = Reader(*known_data(variant, asked, language_name))
        reader.read(found)
        assert not reader.wrong, "\n".join(reader.wrong)
        assert reader.checked >= 3


@pytest.mark.parametrize(("name", "form", "method"), CASES, ids=IDS)
def test_other_methods_come_out_as_well(name: str, form: str, method: str) -> None:
    """The other methods by groups of links; those for whole problems have tests of their own."""
    drawn, motion = variants(name, form)
    variant, asked = drawn[0], read_ask(drawn[0].form)
    found = explain(variant, motion, 0, asked, load_language("en"), SolutionOptions((method,)))
    check_digits(found, *known_data(variant, asked, "en"))
    reader = Reader(*known_data(variant, asked, "en"))
    reader.read(found)
    assert not reader.wrong, "\n".join(reader.wrong)
    assert reader.checked >= 3
