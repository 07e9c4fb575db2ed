"""Where ids come from: a column that counts the rows is none, names and groups are; nobody loses a sheet by them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.roster import read_class, read_roster

EXAM = 'title = "Quiz"\nlanguage = "ru"\nseed = 5\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "four_bar"\n'
NAMES = ["Ёлкина Анна", "Борисов Глеб", "Журавлёв Егор", "Ким Вера", "Петров Ян"]


def write(folder: Path, text: str, name: str = "class.csv") -> Path:
    (folder / name).write_text(text, "utf-8")
    return folder / name


def counted(names: list[str], head: str = "№") -> str:
    rows = (f"{number};{name};М-21" for number, name in enumerate(names, start=1))
    return f"{head};ФИО;Группа\n" + "\n".join(rows)


def sheets(folder: Path, roster: str, name: str, *options: str) -> dict[str, object]:
    """What the key has for each name."""
    exam, out = write(folder, EXAM, "exam.toml"), folder / name
    path = write(folder, roster, f"{name}.csv")
    assert main(["build", str(exam), "--roster", str(path), "--out", str(out), *options]) == 0
    students = json.loads((out / "manifest.json").read_text("utf-8"))["students"]
    return {s["name"]: [s["code"], s["problems"][0]["parameters"], s["problems"][0]["answers"]] for s in students}


def test_two_more_students_change_no_other_sheet(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = sheets(tmp_path, counted(NAMES), "before")
    said = capsys.readouterr().err
    assert '"№" only counts the rows' in said
    assert "the name with the group" in said
    after = sheets(tmp_path, counted(["Авдеев Пётр", *NAMES[:3], "Иванов Лев", *NAMES[3:]]), "after")
    assert {name: after[name] for name in NAMES} == before
    assert len({sheet[0] for sheet in after.values()}) == 7


@pytest.mark.parametrize("head", ["№", "No", "N", "п/п", "Номер", "#"])
def test_heads_of_columns_that_count(head: str, tmp_path: Path) -> None:
    found = read_class(write(tmp_path, counted(NAMES, head)))
    assert [s.id for s in found.students] == [f"{name} (М-21)" for name in NAMES]
    asked = read_class(write(tmp_path, counted(NAMES, head)), id_column=head.lower())
    assert [s.id for s in asked.students] == ["1", "2", "3", "4", "5"]
    assert "counted anew" in " ".join(asked.notes)


def test_numbers_that_do_not_count_are_ids(tmp_path: Path) -> None:
    found = read_class(write(tmp_path, "№;ФИО\n21;Анна\n17;Глеб\n"))
    assert [s.id for s in found.students] == ["21", "17"]
    assert found.notes == ()


def test_an_id_that_counts_is_used_and_said(tmp_path: Path) -> None:
    found = read_class(write(tmp_path, "id,name\n1,Ann\n2,Bob\n"))
    assert [s.id for s in found.students] == ["1", "2"]
    assert "only count the rows" in found.notes[0]


def test_a_counting_column_beside_ids(tmp_path: Path) -> None:
    found = read_class(write(tmp_path, "№,student id,name\n1,a7,Ann\n2,b3,Bob\n"))
    assert [s.id for s in found.students] == ["a7", "b3"]
    assert found.notes == ()


def test_any_column_can_be_asked_for(tmp_path: Path) -> None:
    roster = write(tmp_path, "№;E-mail;name\n1;ann@x;Ann\n2;bob@x;Bob\n")
    assert [s.id for s in read_class(roster, "e-mail").students] == ["ann@x", "bob@x"]
    with pytest.raises(InputError, match=r"--id-column: the roster has no such column \(got mail\)"):
        read_class(roster, "mail")


def test_namesakes_are_told_apart_and_reported(tmp_path: Path) -> None:
    roster = "name,group\nAnn Lee,A\nAnn Lee,B\nBob,A\nAnn  Lee,A\nAnn Lee (A),\nAnn Lee,A\n"
    found = read_class(write(tmp_path, roster))
    ids = [s.id for s in found.students]
    assert ids[:3] == ["Ann Lee (A)", "Ann Lee (B)", "Bob (A)"]
    assert len(set(ids)) == 6
    (output,) = [note for note in found.notes if "namesakes" in note]
    assert "row 2, row 5, row 6, row 7" in output
    assert "take the sheet of another" in output


def test_a_template_with_more_numbers_than_names(tmp_path: Path) -> None:
    found = read_class(write(tmp_path, "№;ФИО;Группа\n1;Анна;А\n2;Глеб;А\n3;;\n4;;\n"))
    assert [s.name for s in found.students] == ["Анна", "Глеб"]
    assert [s.id for s in found.students] == ["Анна (А)", "Глеб (А)"]
    assert "row 4 has no name and is left out" in found.notes


def test_a_group_without_a_name_is_wrong(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="row 3: the name is empty"):
        read_roster(write(tmp_path, "№;ФИО;Группа\n1;Анна;А\n2;;А\n"))


def test_id_column_without_a_roster(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = ["build", "sample_en", "--variants", "2", "--id-column", "id", "--out", str(tmp_path / "out")]
    assert main(command) == 2
    assert "--id-column" in capsys.readouterr().err


def test_many_redrawn_students_are_counted(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    from variantgen.builder import Built
    from variantgen.cli.commands import build

    ids = tuple(str(number) for number in range(1200))
    build._report(Built(tmp_path / "out", 20_000, ids), 1.0)
    line = capsys.readouterr().err.splitlines()[0]
    assert len(line) < 250
    assert "1200 students" in line
    assert str(tmp_path / "out" / "manifest.json") in line
