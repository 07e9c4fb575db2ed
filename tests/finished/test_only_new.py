"""Students who come after an exam was built: who is new is said, and they get sheets that nobody else has."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.exam.roster import Student
from variantgen.exam.sheets import variant_codes

EXAM = 'title = "Quiz"\nlanguage = "en"\nseed = 7\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "four_bar"\n'
# A sheet tells the speed (21 values) and above or below the axle the thread runs.
NARROW = (
    'title = "Quiz"\nlanguage = "en"\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "spool"\n'
    'ask = ["v_O"]\nset = { R = 40, r = 20 }\n'
)
FIRST = [("a", "Ann"), ("b", "Bob"), ("c", "Cyd"), ("d", "Dan")]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("exam.toml").write_text(EXAM, "utf-8")


def roster(students: list[tuple[str, str]]) -> None:
    Path("class.csv").write_text("id,name\n" + "\n".join(",".join(who) for who in students), "utf-8")


def build(*options: str, code: int = 0) -> None:
    assert main(["build", "exam.toml", "--roster", "class.csv", "--out", "out", *options]) == code


def sheets(name: str = "out") -> dict[str, Any]:
    students = json.loads(Path(name, "manifest.json").read_text("utf-8"))["students"]
    return {s["id"]: (s["code"], s["problems"]) for s in students}


def test_who_is_new_gone_and_changed_is_said_before_anything(capsys: pytest.CaptureFixture[str]) -> None:
    roster(FIRST)
    build()
    before = Path("out", "manifest.json").read_bytes()
    capsys.readouterr()
    roster([("a", "Ann"), ("b", "Beth"), ("c", "Cyd"), ("e", "Eve"), ("f", "Fay")])
    build(code=2)
    said = capsys.readouterr().err.splitlines()
    assert said[:4] == [
        "new: Eve, Fay",
        "gone: Dan",
        "changed: b was Bob, is Beth",
        "--only-new makes sheets for the new ones alone, in a folder of their own",
    ]
    assert "the output folder exists" in said[4]
    assert Path("out", "manifest.json").read_bytes() == before
    old = sheets()
    build("--force")
    assert "new: Eve, Fay" in capsys.readouterr().err
    assert {who: sheets()[who] for who in "abc"} == {who: old[who] for who in "abc"}


def test_another_exam_in_the_folder_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    roster(FIRST)
    build()
    for change in (("--seed", "8"), ()):
        if not change:
            Path("exam.toml").write_text(EXAM + "points = 3\n", "utf-8")
        capsys.readouterr()
        build(*change, code=2)
        assert "out holds another exam" in capsys.readouterr().err
        build(*change, "--only-new", code=2)
        assert f"built with another {'seed' if change else 'exam file'}" in capsys.readouterr().err
    assert sorted(path.name for path in Path().iterdir()) == ["class.csv", "exam.toml", "out"]


def test_only_new(capsys: pytest.CaptureFixture[str]) -> None:
    roster(FIRST)
    build()
    before = {path.name: path.read_bytes() for path in Path("out").iterdir()}
    late = [*FIRST[1:], ("e", "Eve"), ("f", "Fay")]
    roster(late)
    capsys.readouterr()
    build("--only-new")
    assert "tolerances" not in capsys.readouterr().err
    assert {path.name: path.read_bytes() for path in Path("out").iterdir()} == before
    assert sheets("out-new").keys() == {"e", "f"}
    text = "".join(page_texts(Path("out-new", "sheets.pdf")) + page_texts(Path("out-new", "key.pdf")))
    assert all(name in text for name in ("Eve", "Fay"))
    assert "Bob" not in text
    assert main(["verify", "out-new"]) == 0
    assert main(["remake", "out-new", "--student", "eve", "--out", "again.pdf"]) == 0
    capsys.readouterr()
    roster([*late, ("g", "Gil")])
    build("--only-new")
    assert "new: Gil" in capsys.readouterr().err
    assert sheets("out-new-2").keys() == {"g"}
    build("--only-new")
    assert "nobody is new: nothing was made" in capsys.readouterr().err
    assert not Path("out-new-3").exists()
    # They are the sheets that a build of everybody has.
    roster([*FIRST, *late[3:], ("g", "Gil")])
    assert main(["build", "exam.toml", "--roster", "class.csv", "--out", "whole"]) == 0
    assert sheets("whole") == {**sheets(), **sheets("out-new"), **sheets("out-new-2")}


def test_another_key_since_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    roster(FIRST)
    build()
    assert main(["rekey", "out", "--tolerance", "1=0.05"]) == 0
    roster([*FIRST, ("e", "Eve")])
    capsys.readouterr()
    build("--only-new")
    assert "out was given other tolerances since it was built" in capsys.readouterr().err
    assert main(["rekey", "out-new", "--tolerance", "1=0.05"]) == 0
    capsys.readouterr()
    roster([*FIRST, ("e", "Eve"), ("f", "Fay")])
    build("--only-new")
    assert "other tolerances" in capsys.readouterr().err


def test_wrong_options(capsys: pytest.CaptureFixture[str]) -> None:
    roster(FIRST)
    build("--only-new", code=2)
    assert "there is no finished build in the folder of --out" in capsys.readouterr().err
    build()
    build("--only-new", "--force", code=2)
    assert "--only-new replaces nothing" in capsys.readouterr().err


def test_codes_that_are_taken() -> None:
    students = [Student(str(i), "") for i in range(3)]
    first = variant_codes("s", students)
    again = variant_codes("s", students, first[1:])
    assert again[0] == first[0]
    assert all(len(code) == 11 and code.startswith(old) for code, old in zip(again[1:], first[1:], strict=True))


def output(name: str) -> list[tuple[str, str]]:
    """What is told of each sheet of an exam with few variants."""
    parameters = [problems[0]["parameters"] for _, problems in sheets(name).values()]
    return [(own["v_B"]["value"], own["thread"]["value"]) for own in parameters]


def test_late_sheets_are_not_those_of_others(capsys: pytest.CaptureFixture[str]) -> None:
    Path("exam.toml").write_text(NARROW, "utf-8")
    first, late = [(f"a{i}", f"N{i}") for i in range(16)], [(f"b{i}", f"M{i}") for i in range(12)]
    roster(first)
    build()
    roster(late)
    assert main(["build", "exam.toml", "--roster", "class.csv", "--out", "alone"]) == 0
    assert set(output("alone")) & set(output("out"))  # by themselves they would have some of them
    roster([*first, *late])
    build("--only-new")
    assert not set(output("out-new")) & set(output("out"))
    assert len(set(output("out-new"))) == 12
    assert "drawn again to keep variants distinct: b" in capsys.readouterr().err
    roster([*first, *late, *((f"c{i}", f"L{i}") for i in range(15))])
    build("--only-new", code=2)  # 43 sheets, 42 variants
    assert "too few distinct variants" in capsys.readouterr().err
    assert not Path("out-new-2").exists()
