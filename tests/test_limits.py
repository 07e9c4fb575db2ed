"""Small files that would cost minutes or gigabytes are refused at once, with the bound and a remedy."""

from __future__ import annotations

import os
import shutil
import tracemalloc
from pathlib import Path

import pytest
from msgspec.structs import replace

from tests.exam.test_blueprint import at_most
from variantgen.builder.build_spec import BuildSpec
from variantgen.cli import main
from variantgen.families.reading.files import family_files, family_hash
from variantgen.families.reading.load import load_family
from variantgen.outputs.formats import read_exam
from variantgen.resources import catalog_dir

EXAM = 'title = "Quiz"\nlanguage = "en"\n'
PROBLEM = '[[problem]]\nfamily = "four_bar"\n'
FAMILY = """title = {{ en = "A" }}
length_unit = "cm"
[parameters]
OA = {{ unit = "cm", from = 10, to = 20, step = 1 }}
{parameters}
[derived]
{derived}
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ polar = {{ origin = "O", distance = "OA", angle = "1" }} }}
{points}
[bodies]
OA = ["O", "A"]
[[joints]]
pivot = {{ point = "O" }}
[[drivers]]
rotation = {{ body = "OA", omega = 1, epsilon = 0 }}
[figure]
angles = [{angles}]
lengths = [{lengths}]
"""


def family(folder: Path, **parts: str) -> str:
    """The path of a family with these lines in its sections."""
    path = folder / "mine" / "family.toml"
    path.parent.mkdir()
    empty = dict.fromkeys(("parameters", "derived", "points", "angles", "lengths"), "")
    path.write_text(FAMILY.format(**{**empty, **parts}), "utf-8")
    return str(path)


def refused(command: list[str], capsys: pytest.CaptureFixture[str], seconds: float = 5) -> str:
    """The message of a command that ends soon, with exit code 2 and little memory."""
    tracemalloc.start()
    try:
        with at_most(seconds):
            assert main(command) == 2
        assert tracemalloc.get_traced_memory()[1] < 200e6
    finally:
        tracemalloc.stop()
    return capsys.readouterr().err


@pytest.mark.parametrize(
    "key", ["title" + ".a" * 60_000, 'title."a"' + ".'b'. c" * 20_000, "[[x" + ".y" * 60_000 + "]]"]
)
def test_a_key_of_very_many_parts(key: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(EXAM + key + (" = 1\n" if not key.startswith("[") else "\n") + PROBLEM, "utf-8")
    output = refused(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")], capsys)
    assert "exam.toml: a key of more than 50 parts in line 3 (got " in output
    assert [path.name for path in tmp_path.iterdir()] == ["exam.toml"]


@pytest.mark.parametrize("text", ["..." * 200, "1.2.3.4.5", "a. b. c. d. " * 5 + "e", '"."."' * 4])
def test_points_in_texts_are_no_keys(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(f"title = '{text}'\nlanguage = \"en\"\ncolour = 1\n{PROBLEM}", "utf-8")
    output = refused(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")], capsys)
    assert "colour: unknown key" in output
    assert "parts" not in output


def test_problems_without_number(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(EXAM + PROBLEM * 3700, "utf-8")
    output = refused(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")], capsys)
    assert "exam.toml: problem: expected at most 100 entries (got 3700)\n    leave some out" in output
    assert "at least one problem" not in output


@pytest.mark.parametrize(("key", "value"), [("families", "four_bar"), ("ask", "v_B"), ("form", "crank")])
def test_lists_of_a_problem(key: str, value: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam, family = tmp_path / "exam.toml", "" if key == "families" else 'family = "four_bar"'
    exam.write_text(f"{EXAM}[[problem]]\n{family}\n{key} = {[value] * 9000}\n", "utf-8")
    output = refused(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")], capsys)
    assert f"exam.toml: problem[1].{key}: expected at most 100 entries (got 9000)" in output
    assert "missing" not in output


@pytest.mark.parametrize(
    ("section", "lines", "key", "bound"),
    [
        ("derived", [f"x{i} = 'x{i + 1} + OA'" for i in range(3999)] + ["x3999 = 'OA'"], "derived", "200"),
        ("parameters", [f"p{i} = {{ unit = 'cm', values = [1] }}" for i in range(700)], "parameters", "40"),
        ("angles", ["{ name = 'OA', at = 'O', from = '+x', to = 'A' }," * 1500], "figure.angles", "60"),
        ("lengths", ["{ name = 'OA', from = 'O', to = 'A' }," * 1500], "figure.lengths", "60"),
        ("points", [f"P{i} = {{ foot = {{ point = 'O' }} }}" for i in range(999)], "points", "200"),
    ],
)  # fmt: skip
def test_sections_of_a_family_without_end(
    section: str, lines: list[str], key: str, bound: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = refused(["check", family(tmp_path, **{section: "\n".join(lines)})], capsys)
    assert f"family.toml: {key}: expected at most {bound} entries (got " in output
    assert "unknown" not in output


def test_derived_quantities_may_stand_in_any_order(tmp_path: Path) -> None:
    lines = [f"x{i} = 'x{i + 1} + OA'" for i in range(199)] + ["x199 = 'OA'"]
    with at_most(5):
        form = load_family(family(tmp_path, derived="\n".join(lines))).forms[""]
    assert list(form.derived) == [f"x{i}" for i in reversed(range(200))]
    assert float(form.values({"OA": 0.1})["x0"]) == pytest.approx(200 * 0.1)


@pytest.mark.parametrize("name", ["family.toml", "cases.toml", "statement.en.j2", "statement.ru.j2"])
@pytest.mark.parametrize("kind", ["link", "folder link", "dangling", "pipe"])
def test_files_of_a_family_are_no_links(
    name: str, kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = own_family(tmp_path)
    secret = tmp_path / "secret"
    secret.write_bytes((folder / name).read_bytes())
    (folder / name).unlink()
    if kind == "pipe":
        os.mkfifo(folder / name)
    else:
        (folder / name).symlink_to({"link": secret, "folder link": tmp_path, "dangling": tmp_path / "none"}[kind])
    output = refused(["build", str(tmp_path / "exam.toml"), "--variants", "1", "--out", str(tmp_path / "out")], capsys)
    if name == "family.toml" and kind != "link":
        assert "unknown family (got own)" in output
    else:
        expected = "expected a file" if kind == "pipe" else "a file of a family may not be a link"
        assert f"own/{name}: {expected}" in output
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["family.toml", "cases.toml", "statement.ru.j2"])
def test_files_of_a_family_are_small(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = own_family(tmp_path)
    os.truncate(folder / name, 3_000_000_000)
    output = refused(["build", str(tmp_path / "exam.toml"), "--variants", "1", "--out", str(tmp_path / "out")], capsys)
    assert f"own/{name}: the file is larger than 200 kB" in output


def test_other_files_in_the_folder_of_a_family_are_not_read(tmp_path: Path) -> None:
    folder = own_family(tmp_path)
    known = family_hash(folder)
    (folder / "video.mp4").touch()
    os.truncate(folder / "video.mp4", 3_000_000_000)
    (folder / "passwd").symlink_to("/etc/passwd")
    (folder / "deeper").mkdir()
    (folder / "deeper" / "cases.toml").write_text("x")
    assert family_hash(folder) == known
    assert family_files(folder).keys() == {"cases.toml", "family.toml", "statement.en.j2", "statement.ru.j2"}
    carried = BuildSpec.of(replace(read_exam(tmp_path / "exam.toml"), seed="1"))
    assert {name: files.keys() for name, files in carried.families.items()} == {"own": family_files(folder).keys()}
    (folder / "cases.toml").write_bytes((folder / "cases.toml").read_bytes() + b"\n")
    assert family_hash(folder) != known


def test_no_family_has_hundreds_of_statements(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = own_family(tmp_path)
    for number in range(60):
        (folder / f"statement.{number}.j2").touch()
    output = refused(["build", str(tmp_path / "exam.toml"), "--variants", "1", "--out", str(tmp_path / "out")], capsys)
    assert "own: expected at most 50 files of a family (got 64)" in output


def own_family(folder: Path) -> Path:
    """A family ``own``, and an exam of it."""
    shutil.copytree(catalog_dir() / "spool", folder / "own")
    (folder / "exam.toml").write_text(EXAM + '[[problem]]\nfamily = "own"\n', "utf-8")
    return folder / "own"


def test_no_family_of_the_catalogue_is_near_a_bound() -> None:
    for path in catalog_dir().glob("*/family.toml"):
        for form in load_family(str(path)).forms.values():
            assert len(form.parameters) <= 20
            assert len(form.derived) <= 20
            assert len(form.points) <= 20
            assert len(form.figure.angles) + len(form.figure.lengths) <= 20
