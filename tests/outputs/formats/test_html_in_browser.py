"""Pages of HTML in a browser: on a telephone, on paper, in the dark, and with text that would like to be a program."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import html5lib
import pypdfium2
import pytest

from tests.browser import Browser, find_browser, unprotected
from tests.outputs.formats.html_pages import NAMES, TITLES, XHTML, build, exam, pages, read, sound, text
from tests.pdf_text import page_texts
from variantgen.cli import main

LONGEST = """
[[problem]]
family = "three_rod_plate"
[[problem]]
family = "two_loop_mechanism"
[[problem]]
family = "guided_plate"
method = "coordinates"
"""


@pytest.fixture(scope="module", params=["en", "ru"])
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """An exam in one page per document."""
    return request.param, build(exam(tmp_path_factory.mktemp(request.param), request.param, formats='["html"]'))


@pytest.fixture
def browser(tmp_path: Path) -> Browser:
    return Browser(find_browser(), tmp_path)


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
    headed = [" ".join(page.split()).startswith(f"Mechanics {TITLES[made[0]]}") for page in texts]
    assert headed == [bool(own) for own in starts]
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
    output = [float(width) for width in re.findall(r'<svg xmlns="[^"]*" width="([\d.]+)mm"', page.read_text("utf-8"))]
    script = "return [...document.querySelectorAll('svg')].map(node => node.getBoundingClientRect().width)"
    (seen,) = browser.measured([(page, round(181 / 25.4 * 96))], script, paper=True)
    assert [width / 96 * 25.4 for width in seen] == pytest.approx(output, abs=0.1)


HOSTILE = [
    "<script>document.title = 'pwned'; document.body.className = 'pwned'</script>",
    '"><img src=x onerror="document.body.className=\'pwned\'">',
    "'><svg onload=\"document.body.className='pwned'\">",
    "&amp; &lt;b&gt; &#x41; ]]> --> <!-- {{ 7*7 }} {% raw %} {# #}",
    "</style></title></textarea><h1>x</h1>",
    "evil שלום isolate",
    "x" * 5000,
]


@pytest.mark.parametrize("files", ["joined", "students"])
def test_hostile_text_is_shown_and_never_run(files: str, tmp_path: Path, browser: Browser) -> None:
    quoted = json.dumps(" ".join(HOSTILE[:6]), ensure_ascii=True)
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
