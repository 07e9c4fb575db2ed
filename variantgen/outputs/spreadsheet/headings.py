"""What is asked, as it heads the columns of a workbook."""

from __future__ import annotations

from msgspec import Struct, field

from variantgen.exam.sheets import Answer, Item
from variantgen.families.quantities import Quantity
from variantgen.wording.formula import to_plain
from variantgen.wording.language import Language


class Headings(Struct):
    """The symbols and units of answers as plain text; each is written once."""

    language: Language
    _symbols: dict[tuple[str, str, Quantity], str] = field(default_factory=dict)

    def symbol(self, item: Item, answer: Answer) -> str:
        """The symbol, ``v_B``."""
        variant = item.variant
        key = (variant.family.name, variant.form.name, answer.quantity)
        if key not in self._symbols:
            self._symbols[key] = to_plain(self.language.quantity(answer.quantity, variant.form.symbols))
        return self._symbols[key]

    def unit(self, answer: Answer) -> str:
        """The unit, ``cm/s``, or nothing."""
        return to_plain(self.language.unit(answer.unit))

    def heading(self, item: Item, answer: Answer) -> str:
        """Symbol and unit: ``v_B, cm/s``."""
        return ", ".join(part for part in (self.symbol(item, answer), self.unit(answer)) if part)
