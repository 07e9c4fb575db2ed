"""What an exam file asks in a problem: names, a word for all of a kind, or either of them form by form."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.errors import nearest
from variantgen.families.asking import WORDS, Ask, ByForm
from variantgen.families.family import Family
from variantgen.tables import Table

_EXPECTED = f'a list of quantities like ["v_B"], or one of {", ".join(f"{chr(34)}{word}{chr(34)}" for word in WORDS)}'


def read_asked(table: Table) -> Ask:
    """The key ``ask`` of a problem; mistakes are noted in the table."""
    table.expect("ask")
    value = table.data.get("ask")
    if value is None:
        return None
    if not isinstance(value, dict):
        return _names(table, "ask", value)
    forms = table.table("ask")
    if not value:
        forms.problem("names no form", "", value, 'write  ask = ["v_B"]  or  ask = { crank = ["v_B"] }')
    found = forms.each(lambda name, own: _names(forms, name, own))
    return ByForm(tuple(found.items()))


def check_forms(table: Table, ask: Ask, families: Sequence[Family]) -> None:
    """Note forms that none of the families has."""
    if isinstance(ask, ByForm):
        known = [name for family in families for name in family.forms if name]
        for name, _ in ask.forms:
            if name not in known:
                remedy = nearest(name, known) if known else 'no family here has forms: write  ask = ["v_B"]'
                table.table("ask").problem("unknown form", name, remedy=remedy)


def _names(table: Table, key: str, value: Any) -> tuple[str, ...] | None:
    """A list of names, one word, or None (and a mistake noted)."""
    if isinstance(value, str):
        return (value,)
    if isinstance(value, list) and all(isinstance(name, str) for name in value):
        return tuple(value)
    table.problem(f"expected {_EXPECTED}", key, value)
    return None
