"""``remake``: a student's sheet again, byte for byte, or what differs."""

from __future__ import annotations

import json
import shutil
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pikepdf
import pytest

from tests.exam.test_blueprint import at_most
from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.finished.pdf_comparison import is_used, page_digest

PROBLEMS = (
    '[[problem]]\nfamily = "four_bar"\nform = "crank"\n[[problem]]\nfamilies = ["spool", "rolling_wheel"]\npoints = 5\n'
)
STUDENTS = [
    "Иванов Иван;М-21",
    "Öztürk Ann;М-22",
    "De la Cruz, Ana;М-21",
    "Bob;",
    *(f"N{i};M-{i % 3}" for i in range(6)),
]


def built(folder: Path, head: str = "", language: str = "ru") -> Path:
    """An exam of ten students, with groups that do and do not follow each other."""
    exam, roster = folder / "exam.toml", folder / "class.csv"
    exam.write_text(f'title = "T"\nlanguage = "{language}"\nsort = "roster"\n{head}\n{PROBLEMS}', "utf-8")
    rows = (f"s{number};{row}" for number, row in enumerate(STUDENTS))
    roster.write_text("id;name;group\n" + "\n".join(rows), "utf-8")
    assert main(["build", str(exam), "--roster", str(roster), "--out", str(folder / "out")]) == 0
    return folder / "out"


@pytest.fixture(scope="module")
def joined(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("joined"))


@pytest.fixture
def out(joined: Path, tmp_path: Path) -> Path:
    shutil.copytree(joined, tmp_path / "out")
    return tmp_path / "out"


def change(out: Path, edit: Callable[[dict[str, Any]], None]) -> None:
    path = out / "manifest.json"
    manifest = json.loads(path.read_text("utf-8"))
    edit(manifest)
    path.write_text(json.dumps(manifest, ensure_ascii=False), "utf-8")


def remade(out: Path, student: str, *options: str, code: int = 0) -> bytes:
    target = out.parent / "again.pdf"
    assert main(["remake", str(out), "--student", student, "--out", str(target), *options]) == code
    assert target.is_file() == (code == 0)
    content = target.read_bytes() if code == 0 else b""
    target.unlink(missing_ok=True)
    return content


def test_a_file_whose_name_is_not_that_of_a_pdf(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["remake", str(tmp_path), "--student", "s1", "--out", str(tmp_path / "bob")]) == 2
    message = capsys.readouterr().err
    assert "--out: expected a file that ends in .pdf" in message
    assert str(tmp_path / "bob.pdf") in message
    assert not list(tmp_path.iterdir())


def text(content: bytes, folder: Path) -> list[str]:
    (folder / "text.pdf").write_bytes(content)
    return page_texts(folder / "text.pdf")


@pytest.mark.parametrize("options", [(), ("--solutions",)])
@pytest.mark.parametrize("place", [0, 3, 7, 8, 9])
def test_the_pages_of_the_file_of_the_class(
    place: int, options: tuple[str, ...], joined: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    content = remade(joined, f"s{place}", *options)
    said = capsys.readouterr().err
    name = "solutions.pdf" if options else "sheets.pdf"
    assert f"of {name}" in said
    code = json.loads((joined / "manifest.json").read_text("utf-8"))["students"][place]["code"]
    # An independent look: the pages that have the code of the student.
    there = [page for page in page_texts(joined / name) if code in page]
    assert text(content, tmp_path) == there
    assert there
    assert remade(joined, f"s{place}", *options) == content


@pytest.mark.parametrize("language", ["ru", "en"])
def test_the_files_of_students_byte_for_byte(language: str, tmp_path: Path) -> None:
    head = '[pdf]\nfiles = "students"\nnames = "name"\nstandard = "ua-1"\n'
    out = built(tmp_path, head, language)
    files = {path.stem: path for path in (out / "sheets").iterdir()}
    assert len(files) == len(STUDENTS)
    for place, options, folder in ((0, (), "sheets"), (9, (), "sheets"), (2, ("--solutions",), "solutions")):
        code = json.loads((out / "manifest.json").read_text("utf-8"))["students"][place]["code"]
        (name,) = [stem for stem in files if stem.endswith(code)]
        assert remade(out, f"s{place}", *options) == (out / folder / f"{name}.pdf").read_bytes()


def test_a_standard_is_kept(tmp_path: Path) -> None:
    out = built(tmp_path, '[pdf]\nstandard = "ua-1"\n[solutions]\ndepth = "none"\n')
    (tmp_path / "own.pdf").write_bytes(remade(out, "s4"))
    with pikepdf.open(tmp_path / "own.pdf") as pdf:
        assert pdf.Root.MarkInfo.Marked
        assert b"pdfuaid:part" in pdf.Root.Metadata.read_bytes()


def test_the_name_of_the_file_is_the_code(joined: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    code = json.loads((joined / "manifest.json").read_text("utf-8"))["students"][1]["code"]
    assert main(["remake", str(joined), "--student", "s1"]) == 0
    assert main(["remake", str(joined), "--student", "s1", "--solutions"]) == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"{code}-solutions.pdf", f"{code}.pdf"]


def test_another_variant_is_noticed(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def swap(manifest: dict[str, Any]) -> None:
        one, two = manifest["students"][:2]
        one["problems"][0]["parameters"], two["problems"][0]["parameters"] = (
            two["problems"][0]["parameters"], one["problems"][0]["parameters"],
        )  # fmt: skip

    change(out, swap)
    remade(out, "s0", code=1)
    said = capsys.readouterr().err
    assert "problem 1: the manifest has the answers" in said
    assert "page 1 of sheets.pdf is another one" in said
    assert "nothing was written" in said
    assert remade(out, "s0", "--anyway").startswith(b"%PDF")


def test_another_look_is_noticed(
    out: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Other templates: the manifest says so, and the pages show it."""
    from variantgen import resources
    from variantgen.exam.manifest import reading
    from variantgen.outputs.typst import typesetter

    shutil.copytree(resources.templates_dir(), tmp_path / "templates")
    sheets = tmp_path / "templates" / "typst" / "sheets.typ"
    sheets.write_text(sheets.read_text("utf-8").replace("stroke: (bottom: 0.5pt)", "stroke: (bottom: 1pt)"), "utf-8")
    for where in (reading, typesetter):
        monkeypatch.setattr(where, "templates_dir", lambda: tmp_path / "templates")
    remade(out, "s2", code=1)
    said = capsys.readouterr().err
    assert "the templates of the program: " in said
    assert "of sheets.pdf is another one" in said


def test_another_version_that_makes_the_same_is_told(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change(out, lambda manifest: manifest["made_with"].update(program="0.0.9"))
    remade(out, "s2")
    said = capsys.readouterr().err
    assert "the version of variantgen: 0.0.9 when the exam was made" in said
    assert "the same as page" in said
    (out / "sheets.pdf").unlink()
    remade(out, "s2", code=1)


def test_without_anything_to_compare_with(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with_file = remade(out, "s5")
    (out / "sheets.pdf").unlink()
    capsys.readouterr()
    assert remade(out, "s5") == with_file
    assert "the same as" not in capsys.readouterr().err


def test_wrong_input(joined: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    remade(joined, "s77", code=2)
    said = capsys.readouterr().err
    assert "--student" in said
    assert "s7" in said
    quiet = built(tmp_path, '[solutions]\ndepth = "none"')
    remade(quiet, "s0", "--solutions", code=2)
    assert "without solutions" in capsys.readouterr().err


def test_looks_differ_by_a_letter(joined: Path, tmp_path: Path) -> None:
    """What the comparison goes by is not the same for any two pages."""
    with pikepdf.open(joined / "sheets.pdf") as pdf:
        used = [page_digest(page) for page in pdf.pages if is_used(page)]
        assert len(set(used)) == len(used)
        page = pdf.pages[0]
        content = page.obj.Contents.read_bytes()
        page.obj.Contents = pdf.make_stream(content.replace(b"1", b"2", 1))
        assert page_digest(page) not in used


def packed(megabytes: int) -> bytes:
    """So many megabytes of blanks, packed to some thousandth."""
    packer, block = zlib.compressobj(9), b" " * 1_000_000
    return b"".join([*(packer.compress(block) for _ in range(megabytes)), packer.flush()])


def with_content(pdf: pikepdf.Pdf, kind: str) -> None:
    """Give the first page a content that is small in the file and large in memory."""
    page, flate = pdf.pages[0].obj, pikepdf.Name.FlateDecode
    stream = pikepdf.Stream(pdf, b"")
    page.Contents = stream
    if kind == "packed twice":
        stream.write(zlib.compress(packed(2000), 9), filter=pikepdf.Array([flate, flate]))
    elif kind == "packed once":
        stream.write(packed(1000), filter=flate)
    else:
        stream.write(packed(20), filter=flate)
        page.Contents = pikepdf.Array([pdf.make_indirect(stream)] * 1000)


@pytest.mark.parametrize("kind", ["packed twice", "packed once", "in a thousand streams"])
def test_a_page_that_is_large_in_memory_is_not_read(
    kind: str, out: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pikepdf.open(out / "sheets.pdf", allow_overwriting_input=True) as pdf:
        with_content(pdf, kind)
        pdf.save(stream_decode_level=pikepdf.StreamDecodeLevel.none, compress_streams=False)
    assert (out / "sheets.pdf").stat().st_size < 3_000_000
    capsys.readouterr()
    with at_most(20):
        remade(out, "s0", code=1)
    output = capsys.readouterr().err
    assert "not the same: sheets.pdf cannot be read (" in output
    assert "read (:" not in output
    assert "restore it from a copy" in output
    assert len(text(remade(out, "s0", "--anyway"), tmp_path)) >= 1


@pytest.mark.parametrize("damage", [b"", b"%PDF-1.7\n", b"\0" * 5000, "half", "no bookmarks", "no pages", "no place"])
def test_a_damaged_file_of_the_class_is_told(
    damage: str | bytes, out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = out / "sheets.pdf"
    if isinstance(damage, bytes):
        path.write_bytes(damage)
    elif damage == "half":
        path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    else:
        with pikepdf.open(path, allow_overwriting_input=True) as pdf:
            if damage == "no bookmarks":
                del pdf.Root["/Outlines"]
            elif damage == "no pages":
                del pdf.pages[:]
            else:
                with pdf.open_outline() as outline:
                    outline.root[0].children[0].destination = pikepdf.Array([pikepdf.Dictionary(), pikepdf.Name.Fit])
            pdf.save()
    capsys.readouterr()
    remade(out, "s0", code=1)
    output = capsys.readouterr().err
    assert "not the same: sheets.pdf" in output
    assert "Traceback" not in output


@pytest.mark.parametrize(
    "code", ["../victim/report", "/{0}/victim/report", "", "7Q4", "7Q4-K2M/../x", "con", "7q4-k2m\n"]
)
@pytest.mark.parametrize("options", [(), ("--anyway",)])
def test_a_code_of_the_manifest_names_no_other_file(
    code: str, options: tuple[str, ...], out: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    victim = out.parent / "victim"
    victim.mkdir()
    (victim / "report.pdf").write_bytes(b"mine")
    here = out.parent / "here"
    here.mkdir()
    monkeypatch.chdir(here)
    change(out, lambda manifest: manifest["students"][0].update(code=code.format(out.parent)))
    capsys.readouterr()
    assert main(["remake", str(out), "--student", "s0", *options]) == 2
    said = capsys.readouterr().err
    assert "manifest.json" in said
    assert "students[1].code" in said
    assert "like 7Q4-K2M" in said
    assert (victim / "report.pdf").read_bytes() == b"mine"
    assert list(here.iterdir()) == []


@pytest.mark.parametrize("key", ["id", "name", "group"])
def test_names_of_the_manifest_are_as_in_class_lists(key: str, out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change(out, lambda manifest: manifest["students"][3].update({key: "Bob\x1b[2J"}))
    capsys.readouterr()
    remade(out, "s0", code=2)
    said = capsys.readouterr().err
    assert f"students[4].{key}" in said
    assert "\x1b" not in said
