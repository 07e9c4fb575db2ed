"""PDFs of a build: which files there are, bookmarks, QR codes."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pikepdf
import pypdfium2
import pytest
import zxingcpp

from tests.pdf_text import page_texts
from variantgen.cli import main

ROSTER = "id;name;group\n17;Иванов Иван;A\n4;Öztürk Ann;A\n8;***;B\n99;De la Cruz, Ana;A\n"
HEAD = 'title = "Quiz"\nlanguage = "en"\nseed = "s"\n'
PROBLEM = '[[problem]]\nfamily = "spool"\n'


def build(folder: Path, options: str, *arguments: str) -> Path:
    """A build of a small class."""
    exam, roster, out = folder / "exam.toml", folder / "class.csv", folder / "out"
    exam.write_text(HEAD + options + PROBLEM * 3, "utf-8")
    roster.write_text(ROSTER, "utf-8")
    assert main(["build", str(exam), "--roster", str(roster), "--out", str(out), *arguments]) == 0
    return out


def students(out: Path) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads((out / "manifest.json").read_text("utf-8"))["students"]
    return found


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


FIXED = {"key.csv", "key.pdf", "manifest.json"}


@pytest.mark.parametrize(
    ("options", "joined", "folders"),
    [
        ("", {"sheets.pdf", "solutions.pdf"}, set()),
        ('[solutions]\nfiles = "students"\n', {"sheets.pdf", "solutions.pdf"}, {"solutions"}),
        ('[pdf]\nfiles = "both"\n', {"sheets.pdf", "solutions.pdf"}, {"sheets", "solutions"}),
        ('[pdf]\nfiles = "students"\n', set(), {"sheets", "solutions"}),
        ('[pdf]\nfiles = "students"\n[solutions]\ndepth = "none"\n', set(), {"sheets"}),
    ],
)
def test_files(options: str, joined: set[str], folders: set[str], tmp_path: Path) -> None:
    out = build(tmp_path, options)
    assert set(names(out)) == FIXED | joined | folders
    for folder in folders:
        assert names(out / folder) == sorted(f"{student['code']}.pdf" for student in students(out))
        for student in students(out):
            said = "".join(page_texts(out / folder / f"{student['code']}.pdf"))
            assert [other["code"] for other in students(out) if other["code"] in said] == [student["code"]]
    assert main(["build", "sample_en", "--variants", "1", "--no-solutions", "--out", str(out), "--force"]) == 0
    assert set(names(out)) == FIXED | {"sheets.pdf"}


def test_files_named_by_students(tmp_path: Path) -> None:
    out = build(tmp_path, '[pdf]\nfiles = "students"\nnames = "name"\n', "--no-solutions")
    codes = {student["id"]: student["code"] for student in students(out)}
    wanted = {"Иванов-Иван-" + codes["17"], "Öztürk-Ann-" + codes["4"], codes["8"], "De-la-Cruz-Ana-" + codes["99"]}
    assert set(names(out / "sheets")) == {f"{name}.pdf" for name in wanted}


Outline = list[tuple[str, int, Any]]


def outline(pdf: pikepdf.Pdf, item: Any = None) -> Outline:
    """Bookmarks with the index of their page and those inside."""
    pages = {page.obj.objgen: index for index, page in enumerate(pdf.pages)}
    found: Outline = []
    item = (pdf.Root.get("/Outlines", {}) if item is None else item).get("/First")
    previous = None
    while item is not None:
        assert (item.get("/Prev") is None) == (previous is None)
        found.append((str(item.Title), pages[item.Dest[0].objgen], outline(pdf, item)))
        previous, item = item, item.get("/Next")
    return found


@pytest.mark.parametrize("extra", ["", '[pdf]\nstandard = "ua-1"\n', '[pdf]\nfiles = "both"\n[page]\nduplex = false\n'])
def test_students_have_bookmarks_under_their_groups(extra: str, tmp_path: Path) -> None:
    out = build(tmp_path, 'sort = "roster"\n' + extra)
    codes = [student["code"] for student in students(out)]
    for file in ("sheets", "solutions"):
        texts = page_texts(out / f"{file}.pdf")
        first = [next(i for i, text in enumerate(texts) if code in text) for code in codes]
        with pikepdf.open(out / f"{file}.pdf") as pdf:
            found = outline(pdf)
            assert pdf.Root.Outlines.Count == 3
        shown = [(title, page, [(name, at) for name, at, _ in inside]) for title, page, inside in found]
        assert shown == [
            ("Group A", first[0], [("Иванов Иван", first[0]), ("Öztürk Ann", first[1])]),
            ("Group B", first[2], [("***", first[2])]),
            ("Group A", first[3], [("De la Cruz, Ana", first[3])]),
        ]
        problems = [name for name, _, _ in found[0][2][0][2]]
        assert problems == ([f"Problem {n}. Spool pulled by a cord" for n in (1, 2, 3)] if file == "solutions" else [])
    with pikepdf.open(out / "key.pdf") as pdf:
        assert [title for title, _, _ in outline(pdf)] == ["By student", "By problem"]


def test_without_groups_students_are_beside_each_other(tmp_path: Path) -> None:
    assert main(["build", "sample_ru", "--variants", "18", "--no-solutions", "--out", str(tmp_path / "out")]) == 0
    with pikepdf.open(tmp_path / "out" / "sheets.pdf") as pdf:
        found = outline(pdf)
        assert pdf.Root.ViewerPreferences.DisplayDocTitle
        assert pdf.check_pdf_syntax() == []
    codes = [student["code"] for student in students(tmp_path / "out")]
    assert [title for title, _, _ in found] == [f"Вариант {i} · {code}" for i, code in enumerate(codes, start=1)]
    assert [page for _, page, _ in found] == sorted(page for _, page, _ in found)


def codes_of(path: Path, dots_per_inch: float) -> list[list[str]]:
    """What the codes on each page say, read from its picture."""
    document = pypdfium2.PdfDocument(path)
    try:
        pictures = [page.render(scale=dots_per_inch / 72).to_pil() for page in document]
    finally:
        document.close()
    return [[found.text for found in zxingcpp.read_barcodes(picture)] for picture in pictures]


@pytest.mark.parametrize("extra", ["", '[pdf]\nstandard = ["a-2a", "ua-1"]\n'])
def test_every_page_of_a_sheet_has_its_code(extra: str, tmp_path: Path) -> None:
    out = build(tmp_path, extra, "--no-solutions")
    texts = page_texts(out / "sheets.pdf")
    said = codes_of(out / "sheets.pdf", 150)
    exams = set()
    for text, own in zip(texts, said, strict=True):
        assert len(own) == (1 if text else 0)
        for word in own:
            exam, code = re.fullmatch(r"VARIANTGEN:1:([0-9A-F]{8}):(.+)", word).groups()  # type: ignore[union-attr]
            assert code in text
            exams.add(exam)
    assert len(exams) == 1
    assert {word[-7:] for own in said for word in own} == {student["code"] for student in students(out)}
    assert not any(codes_of(out / "key.pdf", 150))


def test_codes_name_the_build_and_can_be_left_out(tmp_path: Path) -> None:
    found = set()
    for seed in ("1", "2", "1"):
        out = build(tmp_path, "", "--no-solutions", "--seed", seed, "--force")
        found.add(codes_of(out / "sheets.pdf", 100)[0][0])
    assert len(found) == 2
    out = build(tmp_path, "[page]\nqr = false\n", "--no-solutions", "--force")
    assert not any(codes_of(out / "sheets.pdf", 150))
