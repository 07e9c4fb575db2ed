"""Solutions by the methods for a whole problem: what is printed with a result follows from the printed numbers."""

from __future__ import annotations

import pytest

from tests.calculator import last_unit
from tests.methods.applying import cases
from tests.methods.forms import variants
from tests.wording.solution.test_recomputed import DIGITS, Reader, known_data, number_of
from variantgen.families.asking import read_ask
from variantgen.methods.solution_options import SolutionOptions
from variantgen.wording.formula import Measured, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import FormulaLine, FormulaLines, Section
from variantgen.wording.solution.explain import explain
from variantgen.wording.solution.phrases import load_phrases

CASES, IDS = cases("coordinates", "analytical", "three_rates")


def results(section: Section) -> list[FormulaLine]:
    """Lines with a number as their result."""
    lines = [line for block in section.blocks if isinstance(block, FormulaLines) for line in block.lines]
    return [line for line in lines if len(line.pieces) > 1 and isinstance(line.pieces[-1][1], Measured)]


def note(reader: Reader, line: FormulaLine) -> None:
    """Take a printed number as known: how the position is found has its own test."""
    number, name = line.pieces[-1][1].number.text, to_plain(line.pieces[0][1])
    reader.known[name] = number_of(number, reader.mark)
    reader.halves[name] = last_unit(number, reader.mark, DIGITS) / 2


@pytest.mark.parametrize(("name", "form", "method"), CASES, ids=IDS)
def test_results_come_out(name: str, form: str, method: str) -> None:
    drawn, motion = variants(name, form, 1)
    asked = read_ask(drawn[0].form)
    for language in ("en", "ru"):
        found = explain(drawn[0], motion, 0, asked, load_language(language), SolutionOptions((method,)))
        reader = Reader(*known_data(drawn[0], asked, language))
        position = load_phrases(language).sentence("position.heading")
        for section in found.sections:
            for line in results(section):
                if "".join(map(str, section.heading)).lower() == "".join(map(str, position)).lower():
                    note(reader, line)
                else:
                    reader.line(line)
        assert not reader.wrong, "\n".join(reader.wrong)
        assert reader.checked >= 2
