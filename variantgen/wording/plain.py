"""A problem as plain text for the terminal."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from variantgen.families.parameters.units import Unit
from variantgen.families.quantities import Quantity
from variantgen.variants.variant import Variant
from variantgen.wording.answer_notes import answer_notes
from variantgen.wording.formula import Equation, Measured, Surd, to_plain
from variantgen.wording.graph_words import read_off
from variantgen.wording.language import Language
from variantgen.wording.statement import statement
from variantgen.wording.surds import with_surd


def plain_problem(
    variant: Variant,
    asked: Sequence[Quantity],
    values: Sequence[tuple[float, Unit, Surd | None]],
    language: Language,
    with_notes: bool = True,
) -> str:
    """Statement, given data, asked quantities and answers in lines of at most 100 columns.

    ``values`` are the answers in printed units, with their closed form where they have one. The conventions of sign
    stand at the end, unless they are told elsewhere.
    """
    problem_text = statement(variant, asked, language)
    words, key = language.words("sheet"), language.words("key")
    text = "".join(part if isinstance(part, str) else to_plain(part) for part in problem_text.text)
    found = [
        to_plain(with_surd(Equation(symbol, Measured(language.answer(quantity, value), language.unit(unit))), exact))
        for quantity, symbol, (value, unit, exact) in zip(asked, problem_text.asked, values, strict=True)
    ]
    # A unit of its own is told with what is asked: v_B (ft/s).
    units = [language.unit(unit) for _, unit, _ in values]
    wanted = [f" ({to_plain(unit)})" if q.wanted else "" for q, unit in zip(asked, units, strict=True)]
    symbols = [to_plain(symbol) + shown_unit for symbol, shown_unit in zip(problem_text.asked, wanted, strict=True)]
    paragraphs = [
        variant.family.title(language.name),
        text,
        f"{words['given']} {', '.join(to_plain(equation) for equation in problem_text.given)}.",
        f"{words['find']} {', '.join(symbols)}.",
        f"{key['title']}: {'; '.join(found)}.",
    ]
    if with_notes:
        paragraphs.append(" ".join(answer_notes(read_off(variant.form, asked), language, variant.form.symbols)))
    return "\n\n".join(textwrap.fill(paragraph, 100) for paragraph in paragraphs)
