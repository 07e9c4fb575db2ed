"""Pages of HTML: sound, self-contained, the same in content as the PDFs, laid out for telephones and for paper."""

from __future__ import annotations

import base64
import csv
import hashlib
import json
import re
import unicodedata
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from pathlib import Path

import html5lib
import pypdfium2
import pytest

from tests.browser import Browser, find_browser, unprotected
from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.figure.build import statement_figure
from variantgen.outputs.web.articles import page_style
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.language import load_language

XHTML, SVG, MATH = (
    "{http://www.w3.org/1999/xhtml}",
    "{http://www.w3.org/2000/svg}",
    "{http://www.w3.org/1998/Math/MathML}",
)
TITLES = {"en": "Test of June", "ru": "Зачётная работа"}
NAMES = ["Anna Berg", "Пётр Ёлкин", "Chiara Rossi", "Eva Lind"]
# A long solution, figures of plans, a listing, six answers in a row, families to choose from, points.
PROBLEMS = """
[[problem]]
family = "sleeve_on_crank"
points = 3
[[problem]]
families = ["planetary_train", "spool"]
points = 11
[[problem]]
family = "four_bar"
method = "graphical"
[[problem]]
family = "slider_crank"
method = "coordinates"
"""
LONGEST = """
[[problem]]
family = "three_rod_plate"
[[problem]]
family = "two_loop_mechanism"
[[problem]]
family = "guided_plate"
method = "coordinates"
"""


def exam(
    folder: Path, language: str, more: str = "", problems: str = PROBLEMS, formats: str = '["html", "pdf"]'
) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    head = f'title = "{TITLES[language]}"\ncourse = "Mechanics"\nlanguage = "{language}"\nformats = {formats}\n'
    (folder / "exam.toml").write_text(head + more + problems, encoding="utf-8")
    rows = "".join(f"{number},{name},G-{number % 2}\n" for number, name in enumerate(NAMES, start=1))
    (folder / "class.csv").write_text("id,name,group\n" + rows, encoding="utf-8")
    return folder


def build(folder: Path, out: str = "out", *options: str) -> Path:
    files = [str(folder / "exam.toml"), "--roster", str(folder / "class.csv")]
    assert main(["build", *files, "--out", str(folder / out), *options]) == 0
    return folder / out


@pytest.fixture(scope="module", params=["en", "ru"])
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """An exam in one page per document."""
    return request.param, build(exam(tmp_path_factory.mktemp(request.param), request.param))


@pytest.fixture(scope="module")
def single(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam in a page per student."""
    more = '[html]\nfiles = "students"\n'
    return build(exam(tmp_path_factory.mktemp("single"), "ru", more, formats='["html"]'))


@pytest.fixture
def browser(tmp_path: Path) -> Browser:
    return Browser(find_browser(), tmp_path)


def pages(out: Path) -> list[Path]:
    return sorted((out / "html").rglob("*.html"))


@cache
def read(path: Path) -> ET.Element:
    """A page, read by a parser that takes no mistake."""
    tree: ET.Element = html5lib.HTMLParser(strict=True).parse(path.read_text("utf-8"))
    return tree


def text(node: ET.Element) -> str:
    return "".join(node.itertext())


def said(node: ET.Element) -> str:
    """The text of a node without listings and what stands for figures."""
    if node.tag in {f"{SVG}svg", f"{XHTML}pre"}:
        return ""
    edge = " " if str(node.tag).startswith(MATH) else ""
    return edge + (node.text or "") + "".join(said(child) + (child.tail or "") for child in node) + edge


def squeezed(string: str) -> str:
    """Text without blanks and hyphens: lines of a PDF are broken anywhere."""
    return re.sub(r"[\s\x02\u00ad\ufffe-]", "", string)


def key_rows(out: Path) -> list[dict[str, str]]:
    with (out / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


def codes(out: Path) -> list[str]:
    return list(dict.fromkeys(row["code"] for row in key_rows(out)))


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


def sound(path: Path, language: str) -> None:
    """Check what every page has to fulfil."""
    source, tree = path.read_text("utf-8"), read(path)
    assert tree.get("lang") == language
    ids = [node.get("id") for node in tree.iter() if node.get("id")]
    assert len(ids) == len(set(ids))
    for name in ("aria-labelledby", "aria-describedby"):
        assert {part for node in tree.iter() for part in (node.get(name) or "").split()} <= set(ids)
    local = {(node.get("href") or "")[1:] for node in tree.iter(f"{XHTML}a") if (node.get("href") or "")[0] == "#"}
    assert local <= set(ids)
    assert len(list(tree.iter(f"{XHTML}main"))) == len(list(tree.iter(f"{XHTML}title"))) == 1
    levels = [int(node.tag[-1]) for node in tree.iter() if re.fullmatch(rf"{XHTML}h\d", str(node.tag))]
    assert levels.count(1) == 1
    assert levels[0] == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))
    for head in tree.iter(f"{XHTML}th"):
        assert head.get("scope") in {"col", "row"}
    for drawn in tree.iter(f"{SVG}svg"):
        assert drawn.get("role") == "img"
        assert drawn.get("aria-labelledby")
        assert all(len(text(node)) > 8 for node in drawn if node.tag in {f"{SVG}title", f"{SVG}desc"})
    for label in tree.iter(f"{XHTML}label"):
        assert len(list(label.iter(f"{XHTML}input"))) == 1
        assert text(label).strip()
    needs_nothing(source, tree)


def needs_nothing(source: str, tree: ET.Element) -> None:
    """Check that a page loads nothing and runs nothing, and that it says so to the browser."""
    assert not {f"{XHTML}{name}" for name in ("script", "link", "img", "iframe", "object", "embed", "form")} & {
        node.tag for node in tree.iter()
    }
    for node in tree.iter():
        assert not [name for name in node.attrib if name.startswith("on") or name in {"src", "style"}]
        assert not re.match(r"[a-z]+:|//", node.get("href") or "")
    (style,) = [node.text or "" for node in tree.iter(f"{XHTML}style")]
    assert "url(" not in style
    assert "@import" not in style
    told = {node.get("http-equiv") or node.get("name"): node.get("content") or "" for node in tree.iter(f"{XHTML}meta")}
    digest = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
    policy = f"default-src 'none'; style-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'"
    assert told["Content-Security-Policy"] == policy
    assert told["viewport"] == "width=device-width, initial-scale=1"
    assert source.startswith("<!doctype html>\n")


def test_pages_are_sound(made: tuple[str, Path]) -> None:
    for path in pages(made[1]):
        sound(path, made[0])


def test_pages_of_students_are_sound(single: Path) -> None:
    for path in pages(single):
        sound(path, "ru")


def test_the_same_figure_twice_has_different_ids() -> None:
    variant = one_variant("spool")
    drawing = statement_figure(variant, solve_variants([variant], 0), 0, asked_quantities(variant), load_language("en"))
    style = page_style("7Q4-K2M")
    first, again = (style.figure(drawing, 80.0) for _ in range(2))
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


# What is not laid out as it should be: pages wider than the window, formulas without a size, boxes that stick out.
LAYOUT = """
const all = names => [...document.querySelectorAll(names)], box = node => node.getBoundingClientRect();
const within = node => box(node.closest("p, .wide, pre, .answers") ?? node);
const maths = all("math"), page = document.documentElement;
return {
  window: innerWidth,
  width: Math.max(page.scrollWidth, document.body.scrollWidth),
  maths: maths.length,
  empty: maths.filter(node => box(node).width < 2 || box(node).height < 2).length,
  tall: maths.filter(node => box(node).height > 120).length,
  out: all("math, svg, input, h1, h2, h3, h4, p, figcaption").filter(
    node => within(node).left < -0.5 || within(node).right > innerWidth + 0.5).length,
  scrolling: all("p").filter(node => node.scrollWidth > node.clientWidth + 1).length,
  rows: all("p.formulas").length,
};
"""


def test_pages_fit_the_window(made: tuple[str, Path], browser: Browser) -> None:
    views = [*((path, 360) for path in pages(made[1])), (made[1] / "html" / "solutions.html", 1200)]
    for (_, width), seen in zip(views, browser.measured(views, LAYOUT), strict=True):
        assert seen["window"] == width
        assert seen["width"] <= width
        assert seen["maths"] > 100
        assert (seen["empty"], seen["out"], seen["tall"]) == (0, 0, 0)
        assert seen["scrolling"] <= (0.1 if width == 360 else 0) * seen["rows"]


@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_longest_solutions_fit_a_telephone(language: str, tmp_path: Path, browser: Browser) -> None:
    folder = exam(tmp_path, language, problems=LONGEST, formats='["html"]')
    assert main(["build", str(folder / "exam.toml"), "--variants", "1", "--out", str(tmp_path / "out")]) == 0
    (seen,) = browser.measured([(tmp_path / "out" / "html" / "solutions.html", 360)], LAYOUT)
    assert (seen["window"], seen["width"], seen["empty"], seen["out"]) == (360, 360, 0, 0)
    assert seen["scrolling"] <= 0.1 * seen["rows"]


def test_each_student_starts_on_a_new_page_of_paper(made: tuple[str, Path], tmp_path: Path) -> None:
    browser = Browser(find_browser(), tmp_path, dark=True)
    printed = browser.printed(made[1] / "html" / "sheets.html")
    texts = page_texts(printed)
    starts = [[name for name in NAMES if name in page] for page in texts]
    assert [name for own in starts for name in own] == NAMES
    assert all(len(own) <= 1 for own in starts)
    assert all(TITLES[made[0]] in page for page, own in zip(texts, starts, strict=True) if own)
    assert all(page.strip() for page in texts)
    document = pypdfium2.PdfDocument(printed)
    try:
        for page in document:
            assert page.get_size() == pytest.approx((595, 842), abs=1.5)
        image = document[0].render(scale=1, grayscale=True).to_pil()
    finally:
        document.close()
    assert image.getpixel((3, 3)) == 255
    assert image.getextrema()[0] < 60
    assert sum(image.histogram()[128:]) > 0.9 * image.width * image.height


def test_figures_are_printed_in_their_size(made: tuple[str, Path], browser: Browser) -> None:
    """Lengths of plans are told in millimetres."""
    page = made[1] / "html" / "solutions.html"
    told = [float(width) for width in re.findall(r'<svg xmlns="[^"]*" width="([\d.]+)mm"', page.read_text("utf-8"))]
    script = "return [...document.querySelectorAll('svg')].map(node => node.getBoundingClientRect().width)"
    (seen,) = browser.measured([(page, round(181 / 25.4 * 96))], script, paper=True)
    assert [width / 96 * 25.4 for width in seen] == pytest.approx(told, abs=0.1)


HOSTILE = [
    "<script>document.title = 'pwned'; document.body.className = 'pwned'</script>",
    '"><img src=x onerror="document.body.className=\'pwned\'">',
    "'><svg onload=\"document.body.className='pwned'\">",
    "&amp; &lt;b&gt; &#x41; ]]> --> <!-- {{ 7*7 }} {% raw %} {# #}",
    "</style></title></textarea><h1>x</h1>",
    "\u202eevil\u202c שלום \u2066isolate",
    "x" * 5000,
]


@pytest.mark.parametrize("files", ["joined", "students"])
def test_hostile_text_is_shown_and_never_run(files: str, tmp_path: Path, browser: Browser) -> None:
    quoted = json.dumps(" ".join(HOSTILE[:6]) + "\u0001\uffff", ensure_ascii=True)
    head = f'title = {quoted}\ncourse = {quoted}\nlanguage = "en"\nformats = ["html"]\n[html]\nfiles = "{files}"\n'
    (tmp_path / "exam.toml").write_text(head + '[[problem]]\nfamily = "spool"\n', encoding="utf-8")
    with (tmp_path / "class.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([("id", "name", "group"), *((f"I{t}", f"N{t}", f"G{t}") for t in HOSTILE)])
    out = build(tmp_path)
    bare = " ".join(" ".join(HOSTILE[:6]).split())
    for path in pages(out):
        sound(path, "en")
        tree = read(path)
        assert bare in " ".join(text(tree.find(f".//{XHTML}h1")).split())
    shown = "".join(text(read(path)) for path in pages(out))
    for string in HOSTILE:
        assert f"N{string}" in shown
        assert f"G{string}" in shown.replace("Group G", "G")
    opened = [page for page in pages(out) if page.name != "solutions.html"][:3]
    for path in opened:
        (tmp_path / "open.html").write_text(unprotected(path.read_text("utf-8")), encoding="utf-8")
        dom = html5lib.parse(browser.dom(tmp_path / "open.html"))
        assert not dom.find(f"{XHTML}body").get("class")
        assert not list(dom.iter(f"{XHTML}script")) + list(dom.iter(f"{XHTML}img"))
        assert text(dom.find(f".//{XHTML}title")) == text(read(path).find(f".//{XHTML}title"))
    script = "return document.documentElement.scrollWidth"
    assert browser.measured([(path, 360) for path in opened], script) == [360] * len(opened)


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
    told = capsys.readouterr().err
    assert "html.files" in told
    assert "students" in told
    assert "html.paper" in told


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
