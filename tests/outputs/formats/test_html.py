"""Pages of HTML: sound, self-contained, the same in content as the PDFs and the key."""

from __future__ import annotations

import csv
import re
import unicodedata
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.outputs.formats.html_pages import (
    MATH,
    NAMES,
    SVG,
    XHTML,
    build,
    codes,
    exam,
    key_rows,
    pages,
    read,
    sound,
    text,
)
from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.figure.build import statement_figure
from variantgen.outputs.html.articles import page_writing
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.language import load_language


@pytest.fixture(scope="module", params=["en", "ru"])
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """An exam in one page per document."""
    return request.param, build(exam(tmp_path_factory.mktemp(request.param), request.param))


@pytest.fixture(scope="module")
def single(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam in a page per student."""
    more = '[html]\nfiles = "students"\n'
    return build(exam(tmp_path_factory.mktemp("single"), "ru", more, formats='["html"]'))


def said(node: ET.Element) -> str:
    """The text of a node without listings and what stands for figures."""
    if node.tag in {f"{SVG}svg", f"{XHTML}pre"}:
        return ""
    edge = " " if str(node.tag).startswith(MATH) else ""
    return edge + (node.text or "") + "".join(said(child) + (child.tail or "") for child in node) + edge


def squeezed(string: str) -> str:
    """Text without blanks and hyphens: lines of a PDF are broken anywhere."""
    return re.sub(r"[\s\x02\u00ad\ufffe-]", "", string)


def test_a_page_for_each_document(made: tuple[str, Path]) -> None:
    names = [page.relative_to(made[1]).as_posix() for page in pages(made[1])]
    assert names == ["html/key.html", "html/sheets.html", "html/solutions.html"]


def test_a_page_for_each_student(single: Path) -> None:
    names = [page.relative_to(single / "html").as_posix() for page in pages(single)]
    own = [f"{folder}/{code}.html" for folder in ("sheets", "solutions") for code in sorted(codes(single))]
    assert names == ["index.html", "key.html", *own]
    for code, name in zip(codes(single), NAMES, strict=True):
        for folder in ("sheets", "solutions"):
            page = text(read(single / "html" / folder / f"{code}.html"))
            assert name in page
            assert not [other for other in NAMES if other != name and other in page]


def test_the_list_of_students_leads_to_all_pages(single: Path) -> None:
    tree = read(single / "html" / "index.html")
    links = [node.get("href") for node in tree.iter(f"{XHTML}a")]
    expected = [f"{folder}/{code}.html" for code in codes(single) for folder in ("sheets", "solutions")]
    assert links == ["key.html", *expected]
    assert all((single / "html" / link).is_file() for link in links)
    rows = [text(row) for row in tree.iter(f"{XHTML}tr")][1:]
    assert all(name in row and code in row for row, name, code in zip(rows, NAMES, codes(single), strict=True))


def test_no_solutions_where_none_are_wanted(tmp_path: Path) -> None:
    more = '[html]\nfiles = "students"\n[solutions]\ndepth = "none"\n'
    out = build(exam(tmp_path, "en", more, '[[problem]]\nfamily = "spool"\n', '["html"]'))
    assert {page.parent.name for page in pages(out)} == {"html", "sheets"}
    links = [node.get("href") or "" for node in read(out / "html" / "index.html").iter(f"{XHTML}a")]
    assert not [link for link in links if "solutions" in link]


def test_pages_are_sound(made: tuple[str, Path]) -> None:
    for path in pages(made[1]):
        sound(path, made[0])


def test_pages_of_students_are_sound(single: Path) -> None:
    for path in pages(single):
        sound(path, "ru")


def test_the_same_figure_twice_has_different_ids() -> None:
    variant = one_variant("spool")
    drawing = statement_figure(variant, solve_variants([variant], 0), 0, asked_quantities(variant), load_language("en"))
    writing = page_writing("7Q4-K2M")
    first, again = (str(writing.figure(drawing)(0.8, 80.0)) for _ in range(2))
    ids = re.findall(r' id="([^"]*)"', first + again)
    assert len(ids) == len(set(ids)) == 2
    assert all(f'aria-labelledby="{name}"' in drawn for name, drawn in zip(ids, (first, again), strict=True))
    assert re.sub(r'="d-7Q4-K2M-\d"', "", first) == re.sub(r'="d-7Q4-K2M-\d"', "", again)


def test_articles_say_what_the_pdfs_say(made: tuple[str, Path]) -> None:
    """Long words and long numbers of each student's article, as they stand in the PDF; and the other way round."""
    for document in ("sheets", "solutions"):
        printed = squeezed(unicodedata.normalize("NFC", "".join(page_texts(made[1] / f"{document}.pdf")).lower()))
        articles = list(read(made[1] / "html" / f"{document}.html").iter(f"{XHTML}article"))
        assert [article.get("id") for article in articles] == codes(made[1])
        shown = " ".join(said(article) for article in articles)
        words = set(re.findall(r"[^\W\d_]{5,}|\d[\d.,]{3,}\d", shown.lower()))
        assert len(words) > 70
        missing = {word for word in words if word not in printed}
        assert len(missing) <= 0.03 * len(words), missing  # some are broken at the end of a line beside a figure
        numbers = set(re.findall(r"\d+[.,]\d{3,}", printed))
        every = "".join(text(article) for article in articles)
        assert len({number for number in numbers if number not in every}) <= 0.03 * len(numbers)
        if document == "sheets":
            given = r"=(\d+(?:[.,]\d+)?)"
            assert sorted(re.findall(given, printed)) == sorted(re.findall(given, re.sub(r"\s", "", shown)))


def test_sheets_have_a_field_for_each_answer(made: tuple[str, Path]) -> None:
    articles = list(read(made[1] / "html" / "sheets.html").iter(f"{XHTML}article"))
    fields = {article.get("id"): len(list(article.iter(f"{XHTML}input"))) for article in articles}
    rows = key_rows(made[1])
    assert fields == {code: sum(row["code"] == code for row in rows) for code in codes(made[1])}
    words = [text(node) for node in articles[0].iter(f"{XHTML}span") if node.get("class") == "points"]
    assert words == {"en": ["(3\xa0points)", "(11\xa0points)"], "ru": ["(3\xa0балла)", "(11\xa0баллов)"]}[made[0]]


def number(string: str) -> float:
    return float(string.replace(",", ".").replace("−", "-").split()[0].rstrip("*"))


def test_answers_are_those_of_the_key_table(made: tuple[str, Path]) -> None:
    tree = read(made[1] / "html" / "key.html")
    found: dict[str, list[float]] = {code: [] for code in codes(made[1])}
    for table in tree.iter(f"{XHTML}table"):
        heads = len(list(table.find(f"{XHTML}thead").iter(f"{XHTML}th")))
        for row in table.find(f"{XHTML}tbody"):
            assert len(row) == heads
            found[text(row[0])] += [number(text(cell)) for cell in row[2:]]
    by_student = {
        text(next(node.iter(f"{XHTML}span"))): node
        for node in tree.iter(f"{XHTML}section")
        if node.get("class") == "student"
    }
    assert list(by_student) == codes(made[1])
    for code, values in found.items():
        rows = [row for row in key_rows(made[1]) if row["code"] == code]
        own = [node for node in by_student[code].iter(f"{XHTML}span") if node.get("class") == "keyed"]
        assert len(values) == len(own) == len(rows)
        for value, node, row in zip(values, own, rows, strict=True):
            assert value == pytest.approx(float(row["value"]), rel=6e-4, abs=1e-9)
            numbers = [text(part) for part in node.iter(f"{MATH}mn")]
            assert any(number(part) == pytest.approx(abs(value)) for part in numbers)
            assert ("*" in text(node)) is bool(row["unnoticed"])


def test_many_students_have_a_list_of_contents(made: tuple[str, Path]) -> None:
    tree = read(made[1] / "html" / "sheets.html")
    links = [(node.get("href"), text(node)) for node in tree.find(f".//{XHTML}nav").iter(f"{XHTML}a")]
    assert links == [(f"#{code}", f"{name} {code}") for code, name in zip(codes(made[1]), NAMES, strict=True)]


def test_names_of_files_come_from_codes_only(tmp_path: Path) -> None:
    rows = [("../../x", "../y"), ("a/b\\c:d|e?f", "<>"), ("CON", "nul")]
    (tmp_path / "exam.toml").write_text(
        'title = "T"\nlanguage = "en"\nformats = ["html"]\n[html]\nfiles = "students"\n[[problem]]\nfamily = "spool"\n',
        encoding="utf-8",
    )
    with (tmp_path / "class.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([("id", "name"), *rows])
    out = build(tmp_path)
    names = [path.stem for path in pages(out) if path.parent.name != "html"]
    assert len(names) == 6
    assert all(re.fullmatch(r"[0-9A-Z]{3}(-[0-9A-Z]{3})+", name) for name in names)


def test_same_input_same_bytes(single: Path, tmp_path: Path) -> None:
    again = build(single.parent, "again", "--jobs", "2")
    assert [page.relative_to(again) for page in pages(again)] == [page.relative_to(single) for page in pages(single)]
    assert [page.read_bytes() for page in pages(again)] == [page.read_bytes() for page in pages(single)]


def test_an_earlier_output_is_replaced(tmp_path: Path) -> None:
    folder = exam(tmp_path, "en", '[html]\nfiles = "students"\n', '[[problem]]\nfamily = "spool"\n', '["html"]')
    assert len(pages(build(folder))) == 10
    exam(tmp_path, "en", "", '[[problem]]\nfamily = "spool"\n', '["html"]')
    assert len(pages(build(folder, "out", "--force"))) == 3


def test_a_wrong_option_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam(tmp_path, "en", '[html]\nfiles = "student"\npaper = "a4"\n', '[[problem]]\nfamily = "spool"\n')
    assert main(["build", str(tmp_path / "exam.toml"), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    output = capsys.readouterr().err
    assert "html.files" in output
    assert "students" in output
    assert "html.paper" in output


def luminance(colour: str) -> float:
    """Relative luminance as WCAG 2 defines it."""
    wide = colour[1:] if len(colour) == 7 else "".join(2 * digit for digit in colour[1:])
    parts = [int(wide[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def themes(style: str) -> Iterator[dict[str, str]]:
    """The colours of each theme by name: light, dark, paper."""
    colours: dict[str, str] = {}
    for rule in re.findall(r":root \{(.*?)\}", style, re.DOTALL):
        colours = {**colours, **dict(re.findall(r"--(\w+): (#[0-9a-f]{3,6})\b", rule))}
        yield colours


def test_colours_can_be_told_apart(single: Path) -> None:
    found = list(themes(text(read(single / "html" / "index.html").find(f".//{XHTML}style"))))
    assert len(found) == 3
    assert luminance(found[1]["paper"]) < 0.05 < luminance(found[0]["paper"])
    assert (found[2]["paper"], found[2]["ink"]) == ("#fff", "#000")
    for colours in found:
        for ground in ("paper", "shade", "code"):
            assert contrast(colours["ink"], colours[ground]) >= 7
        for letters in ("faint", "link"):
            for ground in ("paper", "code"):
                assert contrast(colours[letters], colours[ground]) >= 4.5
        assert contrast(colours["frame"], colours["paper"]) >= 3
