"""Plural categories (one, few, many, other) of whole numbers, by the rules of Unicode CLDR.

The rules are data of the language, written as in the table of CLDR (Unicode Technical Standard 35, part 3, "Language
Plural Rules"): ``v = 0 and i % 10 = 2..4 and i % 100 != 12..14``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from variantgen.errors import InputError, Problem

OTHER = "other"  # the category of a number that no rule holds for
_RELATION = re.compile(r"([nivwftce])(?: % ([1-9]\d*))? (!?=) (\d+(?:\.\.\d+)?(?:,\d+(?:\.\.\d+)?)*)")


def plural_category(rules: Mapping[str, str], number: int) -> str:
    """The category of the first rule that holds. Raises InputError for a rule that is none."""
    for name, rule in rules.items():
        try:
            if any(all(_holds(part, number) for part in either.split(" and ")) for either in rule.split(" or ")):
                return name
        except ValueError:
            remedy = "write it as in the table of Unicode CLDR, for example  v = 0 and i % 10 = 1 and i % 100 != 11"
            raise InputError(
                Problem("is not a plural rule", key=f"plural_rules.{name}", value=rule, remedy=remedy)
            ) from None
    return OTHER


def _holds(relation: str, number: int) -> bool:
    """Whether ``i % 10 = 2..4`` holds. Raises ValueError for anything else."""
    found = _RELATION.fullmatch(relation.strip())
    if not found:
        raise ValueError(relation)
    operand, divisor, sign, ranges = found.groups()
    value = abs(number) if operand in "ni" else 0  # the others count decimals and exponents: a whole number has none
    value = value % int(divisor) if divisor else value
    ends = (part.partition("..") for part in ranges.split(","))
    return any(int(low) <= value <= int(high or low) for low, _, high in ends) == (sign == "=")
