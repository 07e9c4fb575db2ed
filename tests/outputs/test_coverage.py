"""Letters that no font has are refused before anything is made, by name; usual letters need no look at the fonts."""

from __future__ import annotations

import unicodedata
from pathlib import Path

import pytest

from variantgen.errors import InputError
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.outputs.typst.coverage import check_letters, missing
from variantgen.outputs.typst.typesetter import typesetter

CONTROL = {"Cc", "Cf", "Cn"}


def test_the_fonts_have_the_usual_letters() -> None:
    usual = [chr(i) for i in range(0x20, 0x500) if unicodedata.category(chr(i)) not in CONTROL]
    with typesetter() as engine:
        assert missing(engine, usual) == set()
        assert missing(engine, list("№«»„“”–—…−₽ẞ\u2009Ợשם")) == set()
        assert missing(engine, list("A学ก😀Б")) == set("学ก😀")


def test_the_message_names_every_text(tmp_path: Path) -> None:
    exam = Exam("Тест 学生", "DriverSweep", "en", (), path=tmp_path)
    students = [
        Student("1", "Ann"),
        Student("2", "李明", "三"),
        Student("3", "Пётр", "😀" + "".join(map(chr, range(0x4E00, 0x4E10)))),
    ]
    with pytest.raises(InputError) as error:
        check_letters(exam, students)
    output = str(error.value)
    assert [problem.message for problem in error.value.problems] == [
        "the fonts for PDF lack a letter of the title",
        "the fonts for PDF lack a letter of the name of student 2",
        "the fonts for PDF lack a letter of the group of student 2",
        "the fonts for PDF lack a letter of the group of student 3",
    ]
    assert "学 U+5B66, 生 U+751F" in output
    assert "😀 U+1F600" in output
    assert "and 12 more" in output
    assert "--format html" in output
