"""No two sheets have the same problem as it stands on paper: text, data and answers, read as a student reads them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from variantgen.errors import InputError
from variantgen.exam.exam_file import parse_exam
from variantgen.exam.roster import Student, numbered
from variantgen.exam.sheets import Item
from variantgen.wording.language import load_language
from variantgen.wording.plain import plain_problem

EN = load_language("en")
TWO_SUNS = """
family = "planetary_train"
form = "two_suns"
set = { r_1 = 20, r_2 = 15, r_3 = 9 }
ask = ["omega_gear2", "v_A"]
"""


def items(problem: str, students: Sequence[Student]) -> list[Item]:
    text = f'title = "T"\nlanguage = "en"\n[[problem]]\n{problem}'
    return [
        sheet.items[0] for sheet in drawn_sheets(replace(parse_exam(text, Path("exam.toml"), ()), seed="3"), students)
    ]


def on_paper(item: Item) -> str:
    """What is printed of a problem: the words and data of the sheet, the answers of the key with their signs."""
    return plain_problem(item.variant, item.asked, [(a.value, a.unit, None) for a in item.answers], EN)


def repeated(found: Sequence[Item]) -> list[str]:
    return [paper for paper, count in Counter(map(on_paper, found)).items() if count > 1]


def test_the_mirror_image_with_the_other_sense_is_the_same_problem() -> None:
    # 12 angular velocities, each in two senses on paper: 24 problems, and all are found.
    found = items(TWO_SUNS, numbered(24))
    assert repeated(found) == []
    assert len({(item.variant.printed["omega_OA"], item.answers[0].value > 0) for item in found}) == 24


@pytest.mark.parametrize(("ask", "count"), [("omega_gear2", 4), ("omega_gear2.abs", 2)])
def test_too_few_are_counted_as_they_stand_on_paper(ask: str, count: int) -> None:
    # 1 and 1.5 rad/s; magnitudes have no sign.
    few = TWO_SUNS.replace("omega_gear2", ask) + "range = { omega_OA = [1, 1.5] }\n"
    assert repeated(items(few, numbered(count))) == []
    with pytest.raises(InputError) as caught:
        items(few, numbered(count + 1))
    assert f"{count + 1} sheets need as many, at most {count} were found" in str(caught.value)


@pytest.mark.parametrize(
    ("family", "form"),
    [
        ("parallelogram_with_disc", "fixed_point"),
        ("parallelogram_with_disc", "moving_point"),
        ("planetary_train", "two_planets"),
        ("rolling_wheel", ""),
        ("winch_with_pulley", "single"),
        ("sliding_block_on_rotating_rod", "central"),
    ],
)
def test_three_hundred_students(family: str, form: str) -> None:
    chosen = f'family = "{family}"\n' + (f'form = "{form}"\n' if form else "")
    students = [Student(f"s{i}", "", f"G{i % 12}") for i in range(300)]
    found = items(chosen, students)
    assert len(found) == 300
    assert repeated(found) == []


def test_a_group_has_no_two_with_nearly_the_same_words_and_numbers() -> None:
    # One group of 24: whose data differ by at most 3 % and two degrees can copy, whatever the figure's mirror image is.
    chosen = 'family = "planetary_pair"\nform = "outside"\nask = ["omega_gear1", "v_B"]\n'
    found = items(chosen, [Student(f"s{i}", "", "G") for i in range(24)])
    printed = [
        {
            name: (abs(float(value)), item.variant.form.parameters[name].unit.name)
            for name, value in item.variant.printed.items()
            if name in {"r_1", "r_2", "alpha", "omega_OA"}
        }
        for item in found
    ]
    answers = [[abs(answer.value) for answer in item.answers] for item in found]
    for i, one in enumerate(printed):
        for k in range(i):
            near = all(
                abs(value - printed[k][name][0]) <= (2.0 if unit == "deg" else 0.029 * value)
                for name, (value, unit) in one.items()
            )
            alike = all(max(a, b) < 1.9 * min(a, b) for a, b in zip(answers[i], answers[k], strict=True))
            assert not (near and alike), (i, k)
