"""PDF/A and PDF/UA: what a build makes conforms by veraPDF, and the joined structure is consistent in itself."""

from __future__ import annotations

import itertools
import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pikepdf
import pytest

from tests.pdf_text import page_texts
from tests.verapdf import failures
from variantgen.cli import main
from variantgen.outputs.pdf_options import STANDARDS, PdfOptions, read_options
from variantgen.outputs.typst.typesetter import TypesettingError, typesetter
from variantgen.tables import Table

ROSTER = "id;name;group\n17;Иванов Иван;М-21\n4;Öztürk Ann;М-21\n99;De la Cruz, Ana;\n"
# Two problems with a table of vectors, a listing and a plan between them; solutions of an odd number of pages.
EXAM = """
title = "Кинематика <1> & «2»"
course = "Теоретическая механика"
language = "{language}"
[solutions]
depth = "{depth}"
[page]
qr = true
[answers]
scan = true
[pdf]
standard = {standard}
files = "{files}"
names = "name"
[[problem]]
family = "four_bar"
form = "crank"
ask = ["v_B", "a_B"]
method = "{method}"
"""
TABLE = """[[problem]]
family = "wheel_with_rod"
form = "driven_by_slider"
"""  # its solution has a table of vectors
BUILDS = {  # flavours of veraPDF, and what the exam says
    "accessible": (["2a", "ua1"], "full", '["a-2a", "ua-1"]', "both", "ru", "velocity_pole"),
    "listing": (["3a", "ua1"], "short", '["ua-1", "a-3a"]', "joined", "en", "coordinates"),
    "old": (["1a"], "short", '"a-1a"', "joined", "ru", "graphical"),
    "printed": (["2b"], "short", '"a-2b"', "students", "en", "velocity_pole"),
    "new": (["4"], "answers", '"a-4"', "joined", "ru", "velocity_pole"),
}


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the builds by their names."""
    folder = tmp_path_factory.mktemp("standards")
    (folder / "class.csv").write_text(ROSTER, "utf-8")
    for name, (_, depth, standard, files, language, method) in BUILDS.items():
        exam = folder / f"{name}.toml"
        text = EXAM.format(depth=depth, standard=standard, files=files, language=language, method=method)
        exam.write_text(text + TABLE if name == "accessible" else text, "utf-8")
        options = ["--roster", str(folder / "class.csv"), "--out", str(folder / name)]
        assert main(["build", str(exam), *options]) == 0
    return folder


def damaged(folder: Path, source: Path) -> Iterator[tuple[str, Path]]:
    """Copies of a PDF with a fault each, and the clause of PDF/UA-1 that it breaks."""
    for clause in ("7.3-1", "7.1-9", "7.1-10", "7.2-34", "7.1-3", "7.4.2-1"):
        path = folder / f"damaged-{clause}.pdf"
        with pikepdf.open(source) as pdf:
            if clause == "7.3-1":
                del next(e for e in elements(pdf) if e.S == "/Figure").Alt
            elif clause == "7.1-9":
                pdf.Root.Metadata.write(pdf.Root.Metadata.read_bytes().replace(b"dc:title", b"dc:source"))
            elif clause == "7.1-10":
                del pdf.Root.ViewerPreferences
            elif clause == "7.2-34":
                del pdf.Root.Lang
            elif clause == "7.1-3":
                pdf.pages[0].contents_add(b"BT ET 0 0 m 9 9 l S")
            else:
                next(e for e in elements(pdf) if e.S == "/H2").S = pikepdf.Name.H4
            pdf.save(path)
        yield clause, path


def test_every_pdf_conforms_by_verapdf(built: Path) -> None:
    checks = [
        (flavour, path)
        for name, (flavours, *_) in BUILDS.items()
        for flavour in flavours
        for path in sample(built / name)
    ]
    faulty = list(damaged(built, built / "accessible" / "sheets.pdf"))
    found = failures([*checks, *(("ua1", path) for _, path in faulty)])
    assert {check: found[check[0], str(check[1])] for check in checks if found[check[0], str(check[1])]} == {}
    for clause, path in faulty:
        assert clause in found["ua1", str(path)], path
    assert len(checks) > 15


def sample(folder: Path) -> list[Path]:
    """The joined files of a build, and one of a student of each kind."""
    return [
        *sorted(folder.glob("*.pdf")),
        *(sorted(inner.glob("*.pdf"))[0] for inner in folder.iterdir() if inner.is_dir()),
    ]


def pdfs(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.pdf"))


def children(node: Any) -> list[Any]:
    inside = node.get("/K", [])
    return list(inside) if isinstance(inside, pikepdf.Array) else [inside]


def elements(pdf: pikepdf.Pdf, node: Any = None) -> Iterator[Any]:
    """All elements of the structure in order, each checked to name the one it is in."""
    node = pdf.Root.StructTreeRoot if node is None else node
    for child in children(node):
        if isinstance(child, pikepdf.Dictionary) and "/S" in child:
            assert child.P.objgen == node.objgen
            yield child
            yield from elements(pdf, child)


def marked(page: Any) -> list[int]:
    """The numbers of the marked content of a page."""
    found = []
    for operands, operator in pikepdf.parse_content_stream(page):
        if str(operator) == "BDC" and "/MCID" in operands[1]:
            found.append(int(operands[1].MCID))
    return found


def leaves(tree: pikepdf.Object, key: str) -> list[tuple[pikepdf.Object, pikepdf.Object]]:
    """The keys and values of a number tree or a name tree; every node but the root tells its least and largest key."""
    found = [pair for kid in tree.get("/Kids", []) for pair in leaves(kid, key)]
    listed = list(tree.get(key, []))
    found += zip(listed[::2], listed[1::2], strict=True)
    if "/Limits" in tree:
        assert list(tree.Limits) == [found[0][0], found[-1][0]]
    assert all("/Limits" in kid for kid in tree.get("/Kids", []))
    return found


@pytest.mark.parametrize(
    ("name", "file"), list(itertools.product(["accessible", "old"], ["sheets", "key", "solutions"]))
)
def test_pages_and_structure_name_each_other(name: str, file: str, built: Path) -> None:
    with pikepdf.open(built / name / f"{file}.pdf") as pdf:
        by_key = {int(key): parents for key, parents in leaves(pdf.Root.StructTreeRoot.ParentTree, "/Nums")}
        assert list(by_key) == sorted(by_key)
        assert max(by_key) < pdf.Root.StructTreeRoot.ParentTreeNextKey
        used = {int(page.obj.StructParents): page.obj for page in pdf.pages if "/StructParents" in page.obj}
        assert used.keys() == by_key.keys()
        from_pages = set()
        for key, page in used.items():
            numbers = marked(page)
            assert sorted(numbers) == list(range(len(by_key[key])))
            from_pages |= {(page.objgen, number, by_key[key][number].objgen) for number in numbers}
        from_tree = {
            (element.Pg.objgen, int(child), element.objgen)
            for element in elements(pdf)
            for child in children(element)
            if isinstance(child, int)
        }
        assert from_pages == from_tree
        assert len(from_pages) > 10


def test_cells_name_the_headers_of_their_own_table(built: Path) -> None:
    seen: set[bytes] = set()
    with pikepdf.open(built / "accessible" / "solutions.pdf") as pdf:
        listed = [bytes(name) for name, _ in leaves(pdf.Root.StructTreeRoot.IDTree, "/Names")]
        assert listed == sorted(listed)
        for table in (element for element in elements(pdf) if element.S == "/Table"):
            cells = list(elements(pdf, table))
            own = {bytes(cell.ID) for cell in cells if cell.S == "/TH"}
            assert own
            assert not own & seen
            for cell in (cell for cell in cells if cell.S == "/TD"):
                assert {bytes(name) for one in cell.A for name in one.get("/Headers", [])} <= own
            seen |= own
    assert seen == set(listed)


def test_a_sheet_is_read_out_in_order(built: Path) -> None:
    with pikepdf.open(built / "accessible" / "sheets.pdf") as pdf:
        found = [str(e.S) for e in elements(pdf) if e.S in {"/H1", "/H2", "/Figure", "/Table"}]
        assert found == (["/H1"] + ["/H2", "/Figure", "/Table"] * 2 + ["/H2"]) * 3  # the last is the page for answers
        said = [str(e.Alt) for e in elements(pdf) if e.S == "/Formula"]
        record = json.loads((built / "accessible" / "manifest.json").read_text("utf-8"))
        for student in record["students"]:
            crank = student["problems"][0]["parameters"]["OA"]
            assert f"{crank['value']}".replace(".", ",") in "".join(page_texts(built / "accessible" / "sheets.pdf"))
        assert {"v_B", "OA", "ω_OA", "рад/с", "v_B, см/с"} <= set(said)
    with pikepdf.open(built / "accessible" / "solutions.pdf") as pdf:
        found = [str(e.S) for e in elements(pdf) if e.S in {"/H1", "/H2", "/H3"}]
        assert (found.count("/H1"), found.count("/H2")) == (3, 6)
        assert found.count("/H3") > 6
        assert all(str(e.Alt) for e in elements(pdf) if e.S in {"/Formula", "/Figure"})


def test_joined_files_tell_language_and_title(built: Path) -> None:
    for path in pdfs(built / "accessible"):
        with pikepdf.open(path) as pdf:
            assert str(pdf.Root.Lang) == "ru"
            assert pdf.Root.ViewerPreferences.DisplayDocTitle
            assert str(pdf.docinfo["/Title"]) == pdf.open_metadata()["dc:title"] == "Кинематика <1> & «2»"
            if path.parent.name == "accessible":
                assert pdf.open_metadata()["{http://ns.adobe.com/xap/1.0/t/pg/}NPages"] == str(len(pdf.pages))
            assert pdf.check_pdf_syntax() == []
    with pikepdf.open(built / "new" / "key.pdf") as pdf:
        assert "/Info" not in pdf.trailer
        assert pdf.pdf_version == "2.0"
    with pikepdf.open(built / "old" / "key.pdf") as pdf:
        assert pdf.pdf_version == "1.4"


def test_the_engine_and_the_exam_file_agree_on_what_goes_together() -> None:
    data = json.loads('{"lang": "en", "title": "T", "heading": "", "subheading": "", "section": "S", "footer": ""}')
    data |= {"words": {}, "students": [], "tables": []}
    with typesetter() as engine:
        for pair in [(one,) for one in STANDARDS] + list(itertools.combinations(STANDARDS, 2)):
            mistakes: list[Any] = []
            accepted = read_options(Table({"standard": list(pair)}, "pdf", mistakes)).standards == pair
            assert accepted != bool(mistakes)
            if accepted:
                assert engine.compile("key.typ", data, standards=pair)[0].startswith(b"%PDF")
            elif "a-1a" not in pair and "a-1b" not in pair:  # of these the engine takes some without annotations
                with pytest.raises(TypesettingError):
                    engine.compile("key.typ", data, standards=pair)


@pytest.mark.parametrize(
    ("table", "wanted"),
    [
        ({}, ()),
        ({"standard": "none"}, ()),
        ({"standard": "PDF/A-2b"}, "standard"),
        ({"standard": "A-2b"}, ("a-2b",)),
        ({"standard": ["ua-1", "a-2a", "ua-1"]}, ("ua-1", "a-2a")),
        ({"standard": ["none", "ua-1"]}, "standard"),
        ({"standard": ["ua-1", 3]}, "standard"),
        ({"standard": True}, "standard"),
        ({"files": "each"}, "files"),
        ({"names": "surname"}, "names"),
        ({"standart": "ua-1"}, "standart"),
    ],
)
def test_options(table: dict[str, Any], wanted: Any) -> None:
    mistakes: list[Any] = []
    found = read_options(Table(table, "pdf", mistakes))
    if isinstance(wanted, str):
        assert [problem.key for problem in mistakes] == [f"pdf.{wanted}"]
        assert found == PdfOptions()
    else:
        assert (found.standards, mistakes) == (wanted, [])


def program(*arguments: str) -> subprocess.CompletedProcess[str]:
    """The program in a process of its own: the engine's threads do not live in the children of this one."""
    command = [sys.executable, "-m", "variantgen", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)


def test_same_bytes_with_tags(built: Path, tmp_path: Path) -> None:
    options = ["--roster", str(built / "class.csv"), "--out", str(tmp_path / "again"), "--jobs", "2"]
    assert program("build", str(built / "accessible.toml"), *options).returncode == 0
    for path in pdfs(built / "accessible"):
        assert path.read_bytes() == (tmp_path / "again" / path.relative_to(built / "accessible")).read_bytes()
