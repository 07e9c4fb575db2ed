"""Packed problems: everything comes back to the last bit, and no bytes can do anything but be refused."""

from __future__ import annotations

import copy
import json
import math
import os
import pickle
import random
from decimal import Decimal
from pathlib import Path

import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from tests.builder.small_exams import exam
from variantgen.exam.exam import Exam
from variantgen.exam.packing import PackingError, pack, unpack
from variantgen.exam.roster import numbered
from variantgen.exam.sheets import Answer, Item
from variantgen.families.quantities import Quantity
from variantgen.methods.hand.work import Work
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Surd

# Choices and numbers, senses and directions, pools, one family under two numbers with other ranges, closed forms.
TEXT = """
title = "T"
language = "en"
[[problem]]
families = ["spool", "planetary_train"]
[[problem]]
family = "slider_crank"
range = { phi = [30, 150] }
[[problem]]
family = "slider_crank"
ask = ["v_B.angle", "omega_AB.sense", "P_AB.A"]
[[problem]]
family = "four_bar"
nice = true
"""
Packed = tuple[Exam, list[Item], bytes]


@pytest.fixture(scope="module")
def packed(tmp_path_factory: pytest.TempPathFactory) -> Packed:
    found = exam(tmp_path_factory.mktemp("exam"), TEXT)
    items = [item for sheet in drawn_sheets(replace(found, seed="1"), numbered(6)) for item in sheet.items]
    return found, items, pack(found, items)


def test_everything_comes_back(packed: Packed) -> None:
    found, items, content = packed
    again = unpack(found, content)
    assert again == tuple(items)
    for one, other in zip(items, again, strict=True):
        assert one.task is other.task
        assert one.variant.family is other.variant.family
        assert one.variant.form is other.variant.form
        assert list(one.variant.printed) == list(other.variant.printed), "in their order"
        for value, same in zip(one.variant.printed.values(), other.variant.printed.values(), strict=True):
            assert value.as_tuple() == same.as_tuple(), "with their zeros"
        for answer, read in zip(one.answers, other.answers, strict=True):
            assert [type(getattr(answer, name)) for name in Answer.__struct_fields__] == [
                type(getattr(read, name)) for name in Answer.__struct_fields__
            ]
    assert any(a.surd for item in items for a in item.answers), "closed forms are there to be tested"
    assert pack(found, again) == content


@pytest.mark.parametrize("number", [1 / 3, 5e-324, 1.7976931348623157e308, -0.0, 0.1 + 0.2, 123456789.12345679])
def test_numbers_to_the_last_bit(number: float, packed: Packed) -> None:
    found, items, _ = packed
    answers = (
        replace(
            items[0].answers[0],
            value=number,
            tolerance=number,
            relative_tolerance=number,
            surd=Surd(-40, 3, 2),
            unnoticed=("я",),
        ),
    )
    (again,) = unpack(found, pack(found, [replace(items[0], answers=answers)]))
    assert again.answers == answers
    assert [math.copysign(1, x) for x in (again.answers[0].value,)] == [math.copysign(1, number)]
    assert again.answers[0].value.hex() == number.hex()


def test_no_field_is_forgotten() -> None:
    """A new field needs a place in the packed form (and here)."""
    assert list(Item.__struct_fields__) == ["task", "variant", "answers", "work"]
    assert list(Work.__struct_fields__) == [
        "lines",
        "operations",
        "functions",
        "systems",
        "negatives",
        "obtuse",
        "coriolis",
    ]
    assert list(Variant.__struct_fields__) == ["family", "form", "printed", "sense", "turns", "attempt"]
    assert list(Answer.__struct_fields__) == [
        "quantity",
        "unit",
        "value",
        "tolerance",
        "relative_tolerance",
        "surd",
        "unnoticed",
    ]
    assert list(Quantity.__struct_fields__) == ["kind", "target", "component", "wanted"]
    assert list(Surd.__struct_fields__) == ["numerator", "denominator", "radicand"]


class Harmful:
    """Does something when it is unpickled."""

    def __init__(self, where: Path) -> None:
        self.where = where

    def __reduce__(self) -> tuple[object, tuple[str]]:
        return os.mkdir, (str(self.where),)


class Changing:
    """Changes an object that it finds when it is unpickled."""

    def __reduce__(self) -> tuple[object, tuple[()], dict[str, object]]:
        return Decimal, (), {"points": 99}


def test_pickles_are_not_read(packed: Packed, tmp_path: Path) -> None:
    found, _, _ = packed
    for bad in (Harmful(tmp_path / "made"), Changing(), (1, 2)):
        with pytest.raises(PackingError):
            unpack(found, pickle.dumps(bad))
    assert not (tmp_path / "made").exists()


@pytest.mark.parametrize(
    "bad", [b"", b"{}x", b"5", b"{}", b"[5]", b"[[]]", b'[["a"]]', b"[" * 100_000, b"\xff", b"[1e999]"]
)
def test_other_bytes_are_refused(bad: bytes, packed: Packed) -> None:
    with pytest.raises(PackingError):
        unpack(packed[0], bad)


def places(node: object, path: tuple[object, ...] = ()) -> list[tuple[object, ...]]:
    """Paths to all that a document holds."""
    inner = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    return [path, *(found for key, value in inner for found in places(value, (*path, key)))]


def test_changed_data_are_refused_or_problems_of_the_exam(packed: Packed) -> None:
    """Whatever stands in the data, what is read are whole problems of this very exam, which stays as it is."""
    found, items, _ = packed
    document = json.loads(pack(found, items[:3]))
    output = [(task.points, task.number, task.ask) for task in found.tasks]
    dice, refused = random.Random(5), 0
    every = places(document)[1:]
    other = [None, True, -1, 7, 10**30, 1.5, "NaN", "points", "../x", [], [1, 2, 3], {}, {"points": 99}, float("inf")]
    for _ in range(1500):
        changed = copy.deepcopy(document)
        *way, last = dice.choice(every)
        node = changed
        for key in way:
            node = node[key]
        if dice.random() < 0.2:
            del node[last]
        else:
            node[last] = dice.choice(other)
        try:
            again = unpack(found, json.dumps(changed).encode())
        except PackingError:
            refused += 1
            continue
        for item in again:
            assert item.task in found.tasks
            assert item.variant.form is item.variant.family.forms[item.variant.form.name]
            assert item.variant.printed.keys() == item.variant.form.parameters.keys()
            assert all(value.is_finite() for value in item.variant.printed.values())
            assert all(math.isfinite(answer.value) for answer in item.answers)
    assert refused > 1000
    assert [(task.points, task.number, task.ask) for task in found.tasks] == output
