"""Class lists as they come: titles above the header, names in parts, extra columns, a worksheet for each group."""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pytest

from variantgen.errors import InputError
from variantgen.exam.roster import Student, read_class, read_roster


def write(folder: Path, text: str) -> Path:
    (folder / "class.csv").write_text(text, "utf-8")
    return folder / "class.csv"


def workbook(folder: Path, sheets: dict[str, list[list[object]]], hidden: str = "") -> Path:
    book = openpyxl.Workbook()
    for title, rows in sheets.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
        if title == hidden:
            sheet.sheet_state = "hidden"
    del book["Sheet"]
    book.save(folder / "class.xlsx")
    return folder / "class.xlsx"


def test_a_title_above_the_header(tmp_path: Path) -> None:
    title = "Список группы, осень 2026;;\nКафедра механики, корпус 2, ауд. 5;;\n;;\n"
    found = read_class(write(tmp_path, title + "Зачётка;ФИО;Группа\n7;Анна;А\n9;Глеб;Б\n"))
    assert found.students == (Student("7", "Анна", "А"), Student("9", "Глеб", "Б"))
    assert found.notes == ("above the header, left out: row 1, 2",)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("id;Фамилия;Имя;Отчество\n7;Ёлкина;Анна;Львовна\n", "Ёлкина Анна Львовна"),
        ("id;Имя;Отчество;Фамилия\n7;Анна;;Ёлкина\n", "Ёлкина Анна"),
        ("id,First name,Last name\n7,Ann,Lee\n", "Lee Ann"),
        ("id,Name,Surname\n7,Ann,Lee\n", "Lee Ann"),
        ("id,Name,First name\n7,Lee,Ann\n", "Lee Ann"),
        ("id,Full name,First name\n7,Lee Ann,Ann\n", "Lee Ann"),
        ("id,First name,Surname,Full name\n7,Ann,Lee,Ann Lee\n", "Ann Lee"),
        ("id,First name\n7,Ann\n", "Ann"),
        ("№ п/п;Фамилия;Имя Отчество;№ зач. кн.\n1;Ёлкина;Анна Львовна;7\n", "Ёлкина Анна Львовна"),
        ("No,Matr. no.,Name\n1,7,Lee Ann\n", "Lee Ann"),
    ],
)
def test_a_name_in_parts(text: str, name: str, tmp_path: Path) -> None:
    assert read_roster(write(tmp_path, text)) == [Student("7", name)]


def test_extra_columns_are_told(tmp_path: Path) -> None:
    found = read_class(write(tmp_path, "id,name,E-mail,gruop,mark\n7,Ann,a@x,A,5\n"))
    assert found.students == (Student("7", "Ann"),)
    assert found.notes == ("columns that are not used: E-mail, gruop (did you mean group?), mark",)


def test_cells_of_titles_do_not_choose_the_delimiter(tmp_path: Path) -> None:
    text = "Group list, term 1, room 5, Mon, Wed\nid;name\n7;Lee, Ann, B., C.\n"
    assert read_roster(write(tmp_path, text)) == [Student("7", "Lee, Ann, B., C.")]


def test_a_worksheet_for_each_group(tmp_path: Path) -> None:
    book = workbook(
        tmp_path,
        {
            "М-21": [["Группа М-21"], ["№", "Фамилия", "Имя"], [1, "Ким", "Вера"], [2, "Юн", "Ян"]],
            "М-22": [["№", "Фамилия", "Имя", "Балл"], [1, "Ким", "Вера", 5]],
            "Заметки": [["не забыть журнал"]],
            "Архив": [["№", "Фамилия"], [1, "Старый"]],
        },
        hidden="Архив",
    )
    found = read_class(book)
    assert [(s.id, s.name, s.group) for s in found.students] == [
        ("Ким Вера (М-21)", "Ким Вера", "М-21"),
        ("Юн Ян (М-21)", "Юн Ян", "М-21"),
        ("Ким Вера (М-22)", "Ким Вера", "М-22"),
    ]
    output = "\n".join(found.notes)
    for part in ("Заметки is left out", "М-22, columns that are not used: Балл", "М-21, above the header"):
        assert part in output


def test_a_worksheet_without_the_ids_of_the_others(tmp_path: Path) -> None:
    book = workbook(tmp_path, {"A": [["id", "name"], [7, "Ann"]], "B": [["name"], ["Bob"]]})
    with pytest.raises(InputError, match="worksheet B, row 2: the id is empty"):
        read_roster(book)


def test_one_student_in_two_worksheets(tmp_path: Path) -> None:
    book = workbook(tmp_path, {"A": [["id", "name"], [7, "Ann"]], "All": [["id", "name"], [7, "Ann"]]})
    with pytest.raises(InputError, match=r"worksheet All, row 2: the id stands twice \(got 7\)\n.*worksheet A, row 2"):
        read_roster(book)


def test_numbers_that_go_on_over_worksheets(tmp_path: Path) -> None:
    book = workbook(tmp_path, {"A": [["№", "name"], [1, "Ann"], [2, "Bob"]], "B": [["№", "name"], [3, "Cyd"]]})
    assert [s.id for s in read_roster(book)] == ["Ann (A)", "Bob (A)", "Cyd (B)"]


def test_one_worksheet_gives_no_group(tmp_path: Path) -> None:
    assert read_roster(workbook(tmp_path, {"Sheet7": [["id", "name"], ["7", "Ann"]]})) == [Student("7", "Ann")]
