"""Names of files for students."""

from __future__ import annotations

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.files.file_names import NAMINGS, file_stem

CODE = "7Q4-K2M"


def stem(text: str, naming: str = "name") -> str:
    return file_stem(Sheet(Student(text, text, "A"), CODE, ()), naming)


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("Ivanov Ivan", "Ivanov-Ivan-7Q4-K2M"),
        ("Иванов  Иван П.", "Иванов-Иван-П-7Q4-K2M"),
        ("../../etc/passwd", "etc-passwd-7Q4-K2M"),
        (".hidden", "hidden-7Q4-K2M"),
        ("--force", "force-7Q4-K2M"),
        ("CON", "CON-7Q4-K2M"),
        ('a\\b:c*d?e"f<g>h|i\x00j', "a-b-c-d-e-f-g-h-i-j-7Q4-K2M"),
        ("O'Neill_2", "O-Neill_2-7Q4-K2M"),
        ("u\N{COMBINING DIAERESIS}ber", "\N{LATIN SMALL LETTER U WITH DIAERESIS}ber-7Q4-K2M"),
        ("学生 姓名", "学生-姓名-7Q4-K2M"),
        ("\N{PILE OF POO}", CODE),
        ("", CODE),
        ("Ж" * 100, "Ж" * 40 + "-7Q4-K2M"),
    ],
)
def test_names(name: str, wanted: str) -> None:
    assert stem(name) == wanted


def test_the_code_alone_is_the_usual_name() -> None:
    assert NAMINGS[0] == "code"
    assert (stem("Ivan", "code"), stem("17/4", "id")) == (CODE, "17-4-7Q4-K2M")


@given(st.text(max_size=200))
def test_any_text_gives_a_name_that_every_system_takes(text: str) -> None:
    found = stem(text)
    assert found.endswith(CODE)
    assert found == found.strip("-_. ")
    assert len(found.encode()) <= 100
    assert all(letter in "-_" or unicodedata.category(letter)[0] in "LN" for letter in found)
