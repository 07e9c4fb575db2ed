"""The order of sheets: by group and name as people look for them, or that of the roster; it changes no sheet."""

from __future__ import annotations

import json
import random
from pathlib import Path

import pikepdf
import pytest

from variantgen.cli import main
from variantgen.exam.roster import Student
from variantgen.exam.student_order import in_order, natural

EXAM = 'title = "T"\nlanguage = "ru"\n{}[solutions]\ndepth = "none"\n[[problem]]\nfamily = "four_bar"\n'


@pytest.mark.parametrize(
    "names",
    [
        ["Егоров", "Ёлкин", "Еремин", "Жуков"],
        ["Ёлкина Ян", "Елкина Яна", "Ельцов"],
        ["Иванов Лев", "Йорк", "Козлов"],
        ["Ким", "Ким Анна", "Ким Вера", "Кима"],
        ["Adam", "Ångström", "Öztürk", "Ozzy", "Zola"],
        ["de la Cruz", "Dean", "Oak", "O'Brien", "Obrien Al"],
        ["Łuk", "Lynn", "Müller", "MULLER Ida", "Nagy"],
        ["Smith", "Smith-Jones", "Smithers"],
        ["Adam", "Zola", "Абрамов"],
    ],
)
def test_names(names: list[str]) -> None:
    mixed = [Student(str(i), name) for i, name in enumerate(names)]
    random.Random(3).shuffle(mixed)
    assert [s.name for s in in_order(mixed)] == names


@pytest.mark.parametrize(
    ("alphabet", "names"),
    [
        ("abcdefghijklmnopqrstuvwxyzåäö", ["Axel", "Édith", "Erik", "Zorn", "Åberg", "Ärlig", "Öberg", "Иванов"]),
        ("aąbcćdeęfghijklłmnńoópqrsśtuvwxyzźż", ["Adam", "Ąka", "Bo", "Lys", "Łuk", "Müller", "Muz", "Zyta", "Żak"]),
        ("абвгґдеєжзиіїйклмнопрстуфхцчшщьюя", ["Гук", "Ґава", "Еко", "Єва", "Ирин", "Іван", "Їжак", "Йова"]),
    ],
)
def test_names_in_the_alphabet_of_a_language(alphabet: str, names: list[str]) -> None:
    mixed = [Student(str(i), name) for i, name in enumerate(names)]
    random.Random(3).shuffle(mixed)
    assert [s.name for s in in_order(mixed, alphabet=alphabet)] == names


def test_groups_first_and_numbers_as_numbers() -> None:
    expected = [
        Student("7", "Яковлев"),
        Student("9", "Беляев", "М-9"),
        Student("8", "Абрамов", "М-10"),
        Student("2", "Ким", "М-10"),
        Student("10", "Ким", "М-10"),
        Student("1", "Аист", "М-10а"),
    ]
    assert in_order(list(reversed(expected))) == expected
    assert in_order(list(reversed(expected)), "roster") == list(reversed(expected))


def test_natural_order_of_ids() -> None:
    assert natural(["s10", "s9", "10", "9", "s1"]) == ["9", "10", "s1", "s9", "s10"]


ROSTER = [("5", "Ёлкин Ян", "М-2"), ("6", "Жуков", "М-10"), ("7", "Егоров", "М-2"), ("8", "Еремин", "М-2")]


def built(folder: Path, name: str, head: str = "") -> tuple[list[str], dict[str, object], bytes]:
    """Ids in the order of the manifest, what each got, and the bytes of the sheets."""
    exam, roster, out = folder / f"{name}.toml", folder / "class.csv", folder / name
    exam.write_text(EXAM.format(head), "utf-8")
    assert main(["build", str(exam), "--roster", str(roster), "--out", str(out), "--seed", "4"]) == 0
    students = json.loads((out / "manifest.json").read_text("utf-8"))["students"]
    found = {s["id"]: (s["code"], s["problems"]) for s in students}
    return [s["id"] for s in students], found, (out / "sheets.pdf").read_bytes()


def test_sheets_stand_in_order_and_do_not_depend_on_it(tmp_path: Path) -> None:
    roster = tmp_path / "class.csv"
    roster.write_text("id;name;group\n" + "\n".join(";".join(row) for row in ROSTER), "utf-8")
    ids, sheets, content = built(tmp_path, "sorted")
    assert ids == ["7", "5", "8", "6"]  # Егоров, Ёлкин, Еремин; group 10 after group 2
    as_listed, same, _ = built(tmp_path, "listed", 'sort = "roster"\n')
    assert as_listed == ["5", "6", "7", "8"]
    assert same == sheets
    roster.write_text("id;name;group\n" + "\n".join(";".join(row) for row in reversed(ROSTER)), "utf-8")
    assert built(tmp_path, "reversed") == (ids, sheets, content)
    with pikepdf.open(tmp_path / "sorted" / "sheets.pdf") as pdf, pdf.open_outline() as outline:
        found = [(str(item.title), [str(own.title) for own in item.children]) for item in outline.root]
    assert found == [("Группа М-2", ["Егоров", "Ёлкин Ян", "Еремин"]), ("Группа М-10", ["Жуков"])]


def test_a_mistyped_order(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(EXAM.format('sort = "rooster"\n'), "utf-8")
    assert main(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    said = capsys.readouterr().err
    assert 'sort: expected one of "name", "roster" (got rooster)' in said
    assert "did you mean roster?" in said
