"""Plural categories, by rules and samples of Unicode CLDR 44 (rules are copied from its table of plural rules)."""

from __future__ import annotations

import pytest

from variantgen.errors import InputError
from variantgen.wording.plurals import plural_category

POLISH = {
    "one": "i = 1 and v = 0",
    "few": "v = 0 and i % 10 = 2..4 and i % 100 != 12..14",
    "many": "v = 0 and i != 1 and i % 10 = 0..1 or v = 0 and i % 10 = 5..9 or v = 0 and i % 100 = 12..14",
}
FRENCH = {"one": "i = 0,1", "many": "e = 0 and i != 0 and i % 1000000 = 0 and v = 0 or e != 0..5"}
LATVIAN = {
    "zero": "n % 10 = 0 or n % 100 = 11..19 or v = 2 and f % 100 = 11..19",
    "one": "n % 10 = 1 and n % 100 != 11",
}


@pytest.mark.parametrize(
    ("rules", "category", "numbers"),
    [
        (POLISH, "one", (1,)), (POLISH, "few", (2, 3, 4, 22, 24, 32, 102, 1002)),
        (POLISH, "many", (0, 5, 11, 12, 14, 19, 21, 100, 101, 112, 1000)),
        (FRENCH, "one", (0, 1)), (FRENCH, "many", (1000000, 2000000)), (FRENCH, "other", (2, 17, 100, 1000, 100000)),
        (LATVIAN, "zero", (0, 10, 20, 11, 15, 111)), (LATVIAN, "one", (1, 21, 101)),
        (LATVIAN, "other", (2, 9, 22, 102)),
        ({}, "other", (0, 1, 2)),
    ],
)  # fmt: skip
def test_samples(rules: dict[str, str], category: str, numbers: tuple[int, ...]) -> None:
    assert {number: plural_category(rules, number) for number in numbers} == dict.fromkeys(numbers, category)


@pytest.mark.parametrize("rule", ["n is 1", "i % 0 = 1", "n == 1", "", "n = 1 and", "n = 1,"])
def test_what_is_no_rule(rule: str) -> None:
    with pytest.raises(InputError, match=r"plural_rules\.few: is not a plural rule"):
        plural_category({"few": rule}, 1)
