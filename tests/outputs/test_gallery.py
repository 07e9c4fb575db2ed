"""The gallery: complete or absent, the same bytes every time, sound markup, figures that the commands show."""

from __future__ import annotations

import shlex
import xml.etree.ElementTree as ET
from pathlib import Path

import html5lib
import pikepdf
import pytest
from msgspec.structs import replace

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.families.reading.load import load_family
from variantgen.outputs.gallery import GalleryRequest, write_gallery

FAMILIES = ["four_bar", "rolling_wheel"]
XHTML, SVG = "{http://www.w3.org/1999/xhtml}", "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module", params=["en", "ru"])
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    out = tmp_path_factory.mktemp(request.param) / "gallery"
    assert main(["gallery", *FAMILIES, "--out", str(out), "--lang", request.param, "--each", "2"]) == 0
    return request.param, out


def page(folder: Path) -> ET.Element:
    """The page, read by a parser that takes no mistake."""
    tree: ET.Element = html5lib.HTMLParser(strict=True).parse((folder / "index.html").read_text("utf-8"))
    return tree


def files(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_folder_holds_page_document_and_figures(made: tuple[str, Path]) -> None:
    forms = [f"four_bar-{form}" for form in load_family("four_bar").forms] + ["rolling_wheel"]
    figures = {f"figures/{form}-{number}.svg" for form in forms for number in (1, 2)}
    assert set(files(made[1])) == {"index.html", "gallery.pdf"} | figures


def test_page_is_valid_and_complete(made: tuple[str, Path]) -> None:
    lang, folder = made
    tree = page(folder)
    assert tree.get("lang") == lang
    sections = tree.findall(f".//{XHTML}section")
    assert [section.get("id") for section in sections] == FAMILIES
    titles = [load_family(name).title(lang) for name in FAMILIES]
    assert [(section.find(f"{XHTML}h2").text or "").strip() for section in sections] == titles
    links = [link.get("href") for link in tree.findall(f".//{XHTML}nav//{XHTML}a")]
    assert links == [f"#{name}" for name in FAMILIES]
    ids = [node.get("id") for node in tree.iter() if node.get("id")]
    assert len(ids) == len(set(ids))
    figures = tree.findall(f".//{XHTML}figure")
    assert len(figures) == 8
    for figure in figures:
        drawn = figure.find(f"{SVG}svg")
        assert drawn is not None
        assert set((drawn.get("aria-labelledby") or "").split()) <= set(ids)
        assert len(drawn.find(f"{SVG}desc").text or "") > 100
        assert len("".join(figure.find(f".//{XHTML}details").itertext())) > 100


def test_page_needs_nothing_from_elsewhere(made: tuple[str, Path]) -> None:
    tree = page(made[1])
    assert not [node for node in tree.iter() if node.tag in {f"{XHTML}script", f"{XHTML}link", f"{XHTML}img"}]
    assert not [node for node in tree.iter() if node.get("src") or (node.get("href") or "#")[0] != "#"]
    style = tree.find(f".//{XHTML}style").text or ""
    assert "url(" not in style
    assert "@import" not in style
    assert "prefers-color-scheme: dark" in style
    assert "@media print" in style


def test_commands_show_the_same_figures(made: tuple[str, Path], tmp_path: Path) -> None:
    commands = [node.text or "" for node in page(made[1]).findall(f".//{XHTML}figure//{XHTML}code")]
    names = sorted(path for path in files(made[1]) if path.endswith(".svg"))
    assert len(commands) == len(set(commands)) == len(names)
    shown = set()
    for i, command in enumerate(commands):
        program, *arguments = shlex.split(command)
        assert program == "variantgen"
        assert main([*arguments, "--figure", str(tmp_path / f"{i}.svg")]) == 0
        shown.add((tmp_path / f"{i}.svg").read_bytes())
    assert shown == {files(made[1])[name] for name in names}


def test_figures_are_xml(made: tuple[str, Path]) -> None:
    for name, content in files(made[1]).items():
        if name.endswith(".svg"):
            assert ET.fromstring(content).tag == f"{SVG}svg"


def test_document_has_bookmarks_and_texts(made: tuple[str, Path]) -> None:
    lang, folder = made
    with pikepdf.open(folder / "gallery.pdf") as pdf, pdf.open_outline() as outline:
        assert [item.title for item in outline.root] == [load_family(name).title(lang) for name in FAMILIES]
        assert len(outline.root[0].children) == len(load_family("four_bar").forms)
        assert str(pdf.docinfo["/Title"])
    text = " ".join(page_texts(folder / "gallery.pdf"))
    assert "variantgen show rolling_wheel" in text
    assert "--seed 2" in text


def test_same_input_same_bytes(made: tuple[str, Path], tmp_path: Path) -> None:
    again = tmp_path / "again"
    assert main(["gallery", *FAMILIES, "--out", str(again), "--lang", made[0], "--each", "2"]) == 0
    assert files(again) == files(made[1])


def test_another_seed_gives_other_figures(tmp_path: Path) -> None:
    write_gallery(GalleryRequest([load_family("spool")], each=2), tmp_path / "first")
    write_gallery(GalleryRequest([load_family("spool")], each=1, seed=2), tmp_path / "second")
    first, second = files(tmp_path / "first"), files(tmp_path / "second")
    assert second["figures/spool-1.svg"] == first["figures/spool-2.svg"] != first["figures/spool-1.svg"]


def test_titles_are_text_and_never_markup(tmp_path: Path) -> None:
    title = '<script>alert(1)</script> & #panic("x") $x$ "quoted"'
    family = replace(load_family("spool"), titles={"en": title})
    assert write_gallery(GalleryRequest([family], each=1), tmp_path / "out") == 1
    tree = page(tmp_path / "out")
    assert not tree.findall(f".//{XHTML}script")
    assert (tree.find(f".//{XHTML}section/{XHTML}h2").text or "").strip() == title
    with pikepdf.open(tmp_path / "out" / "gallery.pdf") as pdf, pdf.open_outline() as outline:
        assert [item.title for item in outline.root] == [title]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["four_bra"], "four_bar"),
        (["four_bar", "--lang", "xx"], "unknown language"),
        (["four_bar", "--each", "0"], "at least 1"),
    ],
)
def test_wrong_input_is_told_and_nothing_is_made(
    arguments: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["gallery", *arguments, "--out", str(tmp_path / "out")]) == 2
    assert message in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_an_existing_folder_is_replaced_only_by_force_and_only_a_gallery(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    command = ["gallery", "spool", "--out", str(out), "--each", "1"]
    assert main(command) == 0
    before = files(out)
    assert main([*command, "--lang", "ru"]) == 2
    assert "exists" in capsys.readouterr().err
    assert files(out) == before
    assert main([*command, "--lang", "ru", "--force"]) == 0
    assert files(out)["index.html"] != before["index.html"]
    for name in ("notes.txt", "figures/mine.png", "more/figure.svg"):
        (out / name).parent.mkdir(exist_ok=True)
        (out / name).write_text("keep")
        assert main([*command, "--force"]) == 2
        assert name.split("/")[0 if name.startswith("more") else -1] in capsys.readouterr().err
        (out / name).unlink()
    (out / "more").rmdir()
    assert main([*command, "--force"]) == 0
    assert files(out) == before


def test_a_gallery_does_not_replace_an_exam(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out"
    out.mkdir()
    (out / "sheets.pdf").write_bytes(b"%PDF")
    assert main(["gallery", "spool", "--out", str(out), "--force"]) == 2
    assert "sheets.pdf" in capsys.readouterr().err
