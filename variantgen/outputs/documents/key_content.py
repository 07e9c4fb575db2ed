"""What a key says, free of any format: answers with their tolerances and marks, and the tables by problem."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

from msgspec import Struct

from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Answer, Item, Sheet
from variantgen.wording.formula import Equation, Formula, Measured, UnitText
from variantgen.wording.language import Language

UNNOTICED = "*"
Place = tuple[int, str, str]  # number of a problem, names of the family and of its form


class KeyTable(Struct, frozen=True):
    """The problems of one form that stand under one number: a table of the key. ``heads`` are symbols with units.

    ``form`` is the name of the form as words, where the family has several.
    """

    title: str
    form: str
    heads: tuple[tuple[Formula, UnitText], ...]


def place(item: Item) -> Place:
    """The group that a problem belongs to; groups are sorted by it."""
    return item.task.number, item.variant.family.name, item.variant.form.name


def key_table(item: Item, exam: Exam, language: Language) -> KeyTable:
    """The table that a problem belongs to."""
    symbols = item.variant.form.symbols
    title = f"{language.words('key')['problem']} {item.task.number}. {item.variant.family.title(exam.language)}"
    heads = ((language.quantity(a.quantity, symbols), language.unit(a.unit)) for a in item.answers)
    form = item.variant.form.name.replace("_", " ") if len(item.variant.family.forms) > 1 else ""
    return KeyTable(title, form, tuple(heads))


def key_tables(sheets: Sequence[Sheet], exam: Exam, language: Language) -> dict[Place, KeyTable]:
    """All tables in their order."""
    first = {place(item): item for sheet in reversed(sheets) for item in sheet.items}
    return {where: key_table(first[where], exam, language) for where in sorted(first)}


def equation(answer: Answer, language: Language, symbols: Mapping[str, str]) -> Equation:
    """``v_B = 12.3 cm/s``."""
    value = Measured(language.answer(answer.quantity, answer.value), language.unit(answer.unit))
    return Equation(language.quantity(answer.quantity, symbols), value)


def tolerance_note(answer: Answer, exam: Exam, language: Language) -> str:
    """The relative tolerance of an answer, where it is not the usual one; a sense has none."""
    return (
        _percent(answer.relative_tolerance, language)
        if answer.relative_tolerance not in (0.0, exam.tolerance.floor)
        else ""
    )


def mark(answer: Answer) -> str:
    """The sign of an answer that some mistakes change by less than its tolerance."""
    return UNNOTICED if answer.unnoticed else ""


def remarks(exam: Exam, language: Language) -> tuple[str, str]:
    """The usual tolerance, and what the mark means."""
    words = language.words("key")
    usual = f"{words['tolerance']}: {_percent(exam.tolerance.floor, language)}, {words['otherwise']}"
    return usual, f"{UNNOTICED} {words['unnoticed']}"


def _percent(part: float, language: Language) -> str:
    """``±1.5 %``, of an angle the like part of a radian."""
    return f"±{language.decimal(Decimal(f'{100 * part:.3g}')).text}\N{NO-BREAK SPACE}%"
