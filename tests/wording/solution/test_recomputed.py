"""Every printed equation is recomputed from its printed numbers, to one unit of the last printed digit."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import nullcontext, suppress

import pytest

from tests.calculator import UnreadableError, evaluate, last_unit
from tests.methods.applying import cases
from tests.methods.forms import FORMS
from variantgen.families.asking import read_ask
from variantgen.families.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.motion import Motion
from variantgen.methods.solution_options import SolutionOptions
from variantgen.variants.draw import FamilySampler
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Measured, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import FormulaLine, FormulaLines, SolutionText
from variantgen.wording.solution.explain import explain
from variantgen.wording.statement import given

SEEDS = 4
CASES, IDS = cases("projections", "velocity_pole", "acceleration_centre")
# Solutions of systems are printed rounded: put back, they leave a remainder of this relative size.
_REMAINDER = 1e-3


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
        self.waiting: list[tuple[str, str, str]] = []

    def read(self, found: SolutionText) -> None:
        for line in lines_of(found):
            self.line(line)
        assert not self.waiting, f"equations without a solution: {self.waiting}"

    def line(self, line: FormulaLine) -> None:
        texts = [to_plain(formula) for _, formula in line.pieces]
        whole = " = ".join(texts)
        if "\u20d7" in whole:
            return  # an equation of vectors has no numbers
        if len(texts) == 1:
            return  # a chain of links
        result = line.pieces[-1][1]
        if not isinstance(result, Measured) or len(texts) < 2:
            self.waiting.append((texts[0], texts[1], whole))
            if re.fullmatch("[a-zα-ω]", texts[0]):
                self.known.setdefault(texts[0], evaluate(texts[1], self.known, self.mark))  # a law says what it is
            self.settle()
            return
        number = result.number.text
        value = float(number.replace("−", "-").replace(self.mark, "."))
        # Degrees have three decimals or more, of which zeros at the end are not printed.
        decimals = len(number.partition(self.mark)[2])
        unit = 10.0 ** -max(decimals, 3) if result.unit.tight else last_unit(number, self.mark)
        for text in texts[1:-1]:
            # A law may go before what it comes down to: εR = a_O, where no number of ε is written.
            with suppress(UnreadableError) if len(texts) > 3 else nullcontext():
                self.compare(evaluate(text, self.known, self.mark), value, unit, whole)
        self.known[texts[0]] = value
        self.settle()
        if value < 0 and texts[0][0] in "va" and not texts[0].endswith((" x", " y")):
            self.known[texts[0]] = -value  # from here on the vector in its true direction

    def compare(self, found: float, wanted: float, unit: float, where: str) -> None:
        self.checked += 1
        if abs(found - wanted) > unit * (1 + 1e-9):
            self.wrong.append(f"{where}: {found:.9g}")

    def settle(self) -> None:
        """Put what has been found back into the equations that led to it."""
        for item in list(self.waiting):
            left, right, whole = item
            if left not in self.known and re.fullmatch(r"[va]_\S+", left):
                with suppress(ValueError):
                    self.known[left] = evaluate(right, self.known, self.mark)  # v_BC = ω_BCD · BC
            try:
                sides = [evaluate(side, self.known, self.mark) for side in (left, right)]
            except ValueError:
                continue
            self.waiting.remove(item)
            self.checked += 1
            size = max(abs(side) for side in sides)
            terms = [abs(value) for name, value in self.known.items() if name in whole]
            if abs(sides[0] - sides[1]) > _REMAINDER * max([size, *terms]):
                self.wrong.append(f"{whole}: {sides[0]:.9g} and {sides[1]:.9g}")


def lines_of(found: SolutionText) -> Iterator[FormulaLine]:
    for blocks in (*(section.blocks for section in found.sections), found.check):
        for block in blocks:
            if isinstance(block, FormulaLines):
                yield from block.lines


def known_data(variant: Variant, asked: list, language_name: str) -> tuple[dict[str, float], str]:
    language = load_language(language_name)
    known = {}
    for equation in given(variant, asked, language):
        text = equation.right.number.text.replace("−", "-").replace(language.decimal_mark, ".")
        known[to_plain(equation.left)] = float(text)
    return known, language.decimal_mark


@pytest.mark.parametrize(("name", "form"), FORMS, ids=["-".join(item) for item in FORMS])
def test_every_printed_equation_comes_out(name: str, form: str) -> None:
    drawn, motion = variants(name, form)
    for index, variant in enumerate(drawn):
        asked = read_ask(variant.form)
        language_name = ("en", "ru")[index % 2]
        found = explain(variant, motion, index, asked, load_language(language_name))
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
    reader = Reader(*known_data(variant, asked, "en"))
    reader.read(found)
    assert not reader.wrong, "\n".join(reader.wrong)
    assert reader.checked >= 3
