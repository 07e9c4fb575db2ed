"""A manifest is read item by item, wherever the pieces end that it is read in."""

from __future__ import annotations

import io
import json
from decimal import Decimal

import pytest

from variantgen.exam.manifest import streamed_json
from variantgen.exam.manifest.streamed_json import entries

TEXT = '\n{"a": -12.50, "b" : [1, {"c": "}]"}] ,\n "items": [\n {"x": 10},\n 123,\n [] ], "e": {}, "long": 1234567}\n'


def read(text: str) -> tuple[dict[str, object], list[object]]:
    """All but the items, and these."""
    found = list(entries(io.StringIO(text), "items"))
    return {key: value for key, number, value in found if not number}, [value for _, number, value in found if number]


@pytest.mark.parametrize("chunk", [1, 2, 3, 7, 1000])
def test_the_same_as_json_wherever_a_piece_ends(chunk: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(streamed_json, "_CHUNK", chunk)
    whole = json.loads(TEXT, parse_float=Decimal)
    items = whole.pop("items")
    assert read(TEXT) == (whole, items)
    assert str(read(TEXT)[0]["a"]) == "-12.50"


@pytest.mark.parametrize("text", ['{"items": 5}', '{"items": []}', "{}", '{"items": {"a": [1]}}'])
def test_what_is_no_list_of_items(text: str) -> None:
    found, items = read(text)
    assert not items
    assert found == {key: value for key, value in json.loads(text).items() if value != []}


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{",
        '{"a" 1}',
        '{"a": 1,}',
        '{"a": 1} 2',
        '{"items": [1, 2}',
        '{"items": [1 2]}',
        '{"items": [1',
        "{1: 2}",
        '{"a": NaN}',
        '{"items": [{"x": -Infinity}]}',
        '{"a": 1e999}',
        '{"a": 1, "items": [2], "a": 1}',
        '{"items": [2], "items": []}',
    ],
)
def test_what_is_no_json(text: str) -> None:
    with pytest.raises(ValueError, match=r"\w"):
        read(text)
