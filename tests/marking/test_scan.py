"""The way from a printed page for answers to marks: filled in here, scanned, read, looked at, marked again."""

from __future__ import annotations

import csv
import io
import struct
import sys
import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import permutations
from pathlib import Path

import numpy as np
import openpyxl
import pypdfium2
import pytest
from PIL import Image, ImageDraw

from benchmarks.filled_pages import Answered, fill, scanned, with_hidden_corner
from tests.marking.test_marks import EXAM as QUIZ
from tests.marking.test_marks import STUDENTS, acceleration, parameters
from variantgen.cli import main
from variantgen.exam import answer_page as page
from variantgen.exam.manifest import read_manifest
from variantgen.marking.scan.columns import Column, columns
from variantgen.marking.scan.confirming import Confirmed
from variantgen.marking.scan.copies import ScannedAnswer, decided
from variantgen.marking.scan.darkness import Darkness
from variantgen.marking.scan.numbers import number, reading
from variantgen.marking.scan.pages import read_page
from variantgen.marking.scan.pictures import ScanImage

Row = dict[str, str]
DPI = 150
_MM = DPI / 25.4
EXAM = QUIZ.replace('language = "en"\nformats = ["xlsx"]', 'language = "{language}"').replace(
    "[solutions]", "[answers]\nscan = true\n[solutions]"
)


@dataclass(frozen=True)
class Built:
    """A build, the pages for answers of its students as they are printed, and another build of the same exam."""

    folder: Path
    pages: list[Image.Image]
    language: str

    @property
    def key(self) -> list[list[tuple[str, float]]]:
        """``problem.quantity`` and value of each answer, by student, from ``key.csv``."""
        every = rows(self.folder / "key.csv")
        order = list(dict.fromkeys(row["id"] for row in every))
        assert order == [sheet.student.id for sheet in read_manifest(self.folder).sheets]
        return [
            [(f"{row['problem']}.{row['quantity']}", float(row["value"])) for row in every if row["id"] == student]
            for student in order
        ]

    def code(self, place: int) -> str:
        """The code of a sheet."""
        return read_manifest(self.folder).sheets[place].code


def rows(path: Path) -> list[Row]:
    text = path.read_text("utf-8-sig")
    return list(csv.DictReader(text.splitlines(), delimiter=";" if ";" in text.partition("\n")[0] else ","))


def build(folder: Path, language: str) -> Built:
    (folder / "exam.toml").write_text(EXAM.format(language=language), "utf-8")
    (folder / "class.csv").write_text(STUDENTS, "utf-8")
    out = folder / "out"
    assert main(["build", str(folder / "exam.toml"), "--roster", str(folder / "class.csv"), "--out", str(out)]) == 0
    document = pypdfium2.PdfDocument(out / "sheets.pdf")
    words = {"en": "Example", "ru": "Образец"}[language]
    pages = [
        sheet.render(scale=DPI / 72, grayscale=True).to_pil().convert("L")
        for sheet in document
        if words in sheet.get_textpage().get_text_bounded()
    ]
    assert len(pages) == 3
    return Built(out, pages, language)


@pytest.fixture(scope="module")
def exams(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Built]:
    """The exam in a language, built once."""
    return cache(lambda language: build(tmp_path_factory.mktemp(language), language))


@pytest.fixture(params=["en", "ru"])
def built(request: pytest.FixtureRequest, exams: Callable[[str], Built]) -> Built:
    return exams(request.param)


@pytest.fixture
def english(exams: Callable[[str], Built]) -> Built:
    return exams("en")


def written(value: float) -> str:
    """A number with four significant digits, as it goes into the boxes."""
    text = f"{value:.4g}"
    assert "e" not in text
    return text


def filled(empty: Image.Image, texts: Sequence[str], more: Sequence[tuple[int, int, int, int]] = ()) -> Image.Image:
    """A page with numbers filled in; ``more`` are bubbles (answer, column, value, grey level) besides."""
    image = empty.copy()
    draw = ImageDraw.Draw(image)
    for answer, text in enumerate(texts):
        if text:
            for column, value in enumerate(page.columns_of(text)):
                if value is not None:
                    bubble(draw, answer, column, value, 40)
    for answer, column, value, grey in more:
        bubble(draw, answer, column, value, grey)
    return image


def bubble(draw: ImageDraw.ImageDraw, answer: int, column: int, value: int, grey: int) -> None:
    left, top = page.block_corner(answer)
    own = next(b for b in page.BUBBLES if (b.column, b.value) == (column, value))
    x, y = (left + own.x) * _MM, (top + own.y) * _MM
    draw.ellipse((x - 1.6 * _MM, y - 1.3 * _MM, x + 1.6 * _MM, y + 1.3 * _MM), fill=grey)


def mark(built: Built, out: Path, *files: Path, force: bool = False) -> tuple[int, dict[tuple[str, str], Row]]:
    """Exit code, and the marks by code and ``problem.quantity``."""
    code = main(["mark", str(built.folder), *map(str, files), "--out", str(out), *(["--force"] if force else [])])
    marks = rows(out / "marks.csv") if (out / "marks.csv").exists() else []
    return code, {(row["code"], f"{row['problem']}.{row['quantity']}"): row for row in marks}


def left(out: Path) -> list[str]:
    return [f"{row['where']}: {row['text']}: {row['why']}" for row in rows(out / "not_matched.csv")]


def test_the_whole_way(built: Built, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One page upside down, one photographed, one with a faint mark that costs points until somebody looks."""
    right = [[written(value) for _, value in own] for own in built.key]
    upside_down = filled(built.pages[0], right[0]).rotate(180)
    doubtful = [*right[1][:-1], "77"]
    faint = filled(built.pages[1], doubtful, [(4, 3, 5, 200)])  # 77 and, faintly, a third digit
    upside_down.save(tmp_path / "scan.pdf", save_all=True, append_images=[faint], resolution=DPI)
    rng = np.random.default_rng(3)
    photo = scanned(filled(built.pages[2], ["", *right[2][1:]]).resize((2480, 3508)), "phone", rng)
    (tmp_path / "photo.jpg").write_bytes(photo)
    out = tmp_path / "marks"
    code, marks = mark(built, out, tmp_path / "scan.pdf", tmp_path / "photo.jpg")
    assert code == 0
    verdicts = {key: row["verdict"] for key, row in marks.items()}
    names = [name for name, _ in built.key[0]]
    assert [verdicts[built.code(0), name] for name in names] == ["right"] * 5
    assert [verdicts[built.code(1), name] for name in names] == ["right"] * 4 + ["unreadable"]
    assert [verdicts[built.code(2), name] for name in names] == ["blank"] + ["right"] * 4
    assert "not final: 1 answer of 1 student" in capsys.readouterr().err
    review = rows(out / "review.csv")
    mark_ = "," if built.language == "ru" else "."
    assert [(row["student"], row["quantity"], row["reading"]) for row in review] == [(built.code(1), "v_O", "")]
    assert review[0]["where"] == "scan.pdf, page 2"
    html = (out / "review.html").read_text("utf-8")
    assert html.count("data:image/png;base64,") == 1
    assert "<script" not in html
    note = {"en": "Not final", "ru": "Не окончательно"}[built.language]
    feedback = out / "feedback" / f"{built.code(1)}.html"
    assert note in feedback.read_text("utf-8")
    # Somebody looks: the number that was meant is the right one.
    text = (out / "review.csv").read_text("utf-8-sig")
    meant = right[1][-1].replace(".", mark_)
    separator = ";" if built.language == "ru" else ","
    changed = text.replace(f"v_O{separator}{separator}", f"v_O{separator}{meant}{separator}")
    assert changed != text
    (out / "review.csv").write_text(changed, "utf-8")
    files = [tmp_path / "scan.pdf", tmp_path / "photo.jpg"]
    assert mark(built, out, *files, force=True)[0] == 2  # what was typed would be lost
    assert "holds readings" in capsys.readouterr().err
    code, marks = mark(built, out, *files, out / "review.csv", force=True)
    assert code == 0
    assert marks[built.code(1), "2.v_O"]["verdict"] == "right"
    assert "not final" not in capsys.readouterr().err
    assert [row["reading"] for row in rows(out / "review.csv")] == [meant]
    assert note not in feedback.read_text("utf-8")


def test_pages_that_give_no_answers_are_named(english: Built, tmp_path: Path) -> None:
    right = [[written(value) for _, value in own] for own in english.key]
    first = filled(english.pages[0], right[0])
    other = filled(english.pages[0], ["1.5", *right[0][1:]])
    no_code = filled(english.pages[1], right[1])
    x, y = page.CODE
    ImageDraw.Draw(no_code).rectangle([v * _MM for v in (x - 1, y - 1, x + 15, y + 15)], fill=255)
    no_corners = filled(english.pages[2], right[2])
    for u, v in page.CORNERS[:2]:
        ImageDraw.Draw(no_corners).rectangle([w * _MM for w in (u - 4, v - 4, u + 4, v + 4)], fill=255)
    problems = pypdfium2.PdfDocument(english.folder / "sheets.pdf")[0].render(scale=DPI / 72).to_pil().convert("L")
    blank = Image.new("L", first.size, 250)
    first.save(
        tmp_path / "scan.pdf",
        save_all=True,
        append_images=[no_code, no_corners, problems, blank, other, blank, problems],
        resolution=DPI,
    )
    out = tmp_path / "marks"
    code, marks = mark(english, out, tmp_path / "scan.pdf")
    assert code == 0
    told = "\n".join(left(out))
    for text in (
        "page 2: : no code of a sheet is seen",
        f"page 3: {english.code(2)}, page 1: not all four black squares in the corners are seen",
        "without answers to read, left out: pages of problems, 2: page 4, 8",
        "without answers to read, left out: blank pages, 2: page 5, 7",
        f"page 6: {english.code(0)}, page 1: the page has been scanned before, scan.pdf, page 1: other answers, for",
        f"scans: {english.code(1)}: no page for answers of 1 of 3 sheets",
    ):
        assert text in told
    names = [name for name, _ in english.key[0]]
    # The first answer is another one on the second scan: neither is taken.
    assert [marks[english.code(0), name]["verdict"] for name in names] == ["unreadable"] + ["right"] * 4
    # Whose page could not be read has no mark yet.
    assert {marks[english.code(2), name]["verdict"] for name in names} == {"unreadable"}
    assert [row["open"] for row in rows(out / "totals.csv")] == ["1", "0", "5"]
    assert [row["Quiz"] for row in rows(out / "gradebook_moodle.csv")] == ["-", "-", "-"]
    book = openpyxl.load_workbook(out / "marks.xlsx").worksheets[0]
    assert [row[-1].value for row in book.iter_rows(min_row=3, max_row=6)] == ["Open", 1, None, 5]
    assert (out / "review.html").read_text("utf-8").count("data:image/png;base64,") == 3


def test_what_is_typed_of_a_lost_page_is_final(english: Built, tmp_path: Path) -> None:
    """What was typed: a number, a dash, what is no number, and what a spreadsheet would run."""
    lost = english.pages[2].copy()
    x, y = page.CORNERS[3]
    ImageDraw.Draw(lost).rectangle([v * _MM for v in (x - 4, y - 4, x + 4, y + 4)], fill=255)
    (tmp_path / "cy_young").mkdir()
    scan = tmp_path / "cy_young" / "cy_young.png"
    lost.save(scan)
    out = tmp_path / "marks"
    mark(english, out, scan)
    asked = [(row["problem"], row["quantity"]) for row in rows(out / "review.csv")]
    assert [f"{number}.{name}" for number, name in asked] == [name for name, _ in english.key[2]]
    assert {row["why"] for row in rows(out / "review.csv")} == {"page not read"}
    readings = [written(english.key[2][0][1]), "/", "?", "=1+1", "-7"]
    typed = [",".join((english.code(2), *own, text)) for own, text in zip(asked, readings, strict=True)]
    (out / "review.csv").write_text("\n".join(["student,problem,quantity,reading", *typed]), "utf-8")
    for _ in range(2):  # the second time with what was written again
        _, marks = mark(english, out, scan, out / "review.csv", force=True)
        verdicts = [marks[english.code(2), name]["verdict"] for name, _ in english.key[2]]
        assert verdicts == ["right", "blank", "unreadable", "unreadable", "wrong"]
        assert [row["reading"] for row in rows(out / "review.csv")] == [*readings[:1], "/", "?", "'=1+1", "-7"]
        assert [row["open"] for row in rows(out / "totals.csv")] == ["0", "0", "0"]
    # Nothing of who it is, in the pictures or in the names of files.
    code = main(["mark", str(english.folder), str(scan), "--anonymous", "--out", str(tmp_path / "anonymous")])
    assert code == 0
    assert "data:image" in (out / "review.html").read_text("utf-8")
    for name in ("review.html", "review.csv", "not_matched.csv"):
        text = (tmp_path / "anonymous" / name).read_text("utf-8")
        assert "young" not in text
        assert "data:image" not in text
        assert "file 1" in text


def test_the_answers_of_a_missing_page_wait(
    english: Built, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As if the five answers stood on two pages, and the second one was not scanned."""
    monkeypatch.setattr(page, "PER_PAGE", 3)
    right = [written(value) for _, value in english.key[0]]
    filled(english.pages[0], right).save(tmp_path / "page.png")
    out = tmp_path / "marks"
    _, marks = mark(english, out, tmp_path / "page.png")
    names = [name for name, _ in english.key[0]]
    assert [marks[english.code(0), name]["verdict"] for name in names] == ["right"] * 3 + ["unreadable"] * 2
    assert "not final: 2 answers of 1 student" in capsys.readouterr().err
    assert [row["why"] for row in rows(out / "review.csv")] == ["page missing"] * 2
    assert f"{english.code(0)}, page 2" in (out / "review.html").read_text("utf-8")


CLEAR, OTHER, BLANK = (ScannedAnswer("a page", Confirmed(text)) for text in ("12", "15", ""))
DOUBTFUL = ScannedAnswer("a page", Confirmed("17", ("several",)), others=("12",))


@pytest.mark.parametrize(
    ("readings", "text"),
    [
        ([CLEAR, CLEAR], "12"),
        ([DOUBTFUL, CLEAR], "12"),
        ([DOUBTFUL, CLEAR, CLEAR], "12"),
        ([DOUBTFUL, OTHER], None),  # not what the doubtful one allows
        ([DOUBTFUL, BLANK], None),
        ([CLEAR, BLANK], None),
        ([CLEAR, OTHER, CLEAR], None),
        ([CLEAR, OTHER, DOUBTFUL], None),
    ],
)
def test_pages_scanned_more_than_once(readings: list[ScannedAnswer], text: str | None) -> None:
    for order in permutations(readings):
        read = decided(order).read
        assert (read.text if not read.why else None) == text
        assert text is not None or "pages differ" in read.why


def test_a_page_of_another_build_is_told(english: Built, tmp_path: Path) -> None:
    other = tmp_path / "other"
    other.mkdir()
    (other / "exam.toml").write_text(EXAM.format(language="en").replace("seed = 4", "seed = 5"), "utf-8")
    out = other / "out"
    assert main(["build", str(other / "exam.toml"), "--variants", "1", "--out", str(out)]) == 0
    code, _ = mark(english, tmp_path / "marks", out / "sheets.pdf")
    assert code == 0
    assert any("a page of another exam or build" in text for text in left(tmp_path / "marks"))


def test_two_marks_in_a_column_never_confirm_themselves(english: Built, tmp_path: Path) -> None:
    """Whoever fills in the right digit and another one beside it gains nothing."""
    right = [written(value) for _, value in english.key[0]]
    digit = page.columns_of(right[0])[1]
    assert digit is not None
    filled(english.pages[0], right, [(0, 1, (digit + 1) % 10, 50)]).save(tmp_path / "page.png")
    _, marks = mark(english, tmp_path / "marks", tmp_path / "page.png")
    names = [name for name, _ in english.key[0]]
    assert [marks[english.code(0), name]["verdict"] for name in names] == ["unreadable"] + ["right"] * 4


def test_a_strong_mark_is_a_rival_of_a_stronger_one() -> None:
    """Beside the darkest bubble of a page one as dark as the usual mark is a mark, however dark the other one is."""
    shades = np.zeros((1, len(page.BUBBLES)))
    for column in range(1, page.DIGITS + 1):
        own = [k for k, one in enumerate(page.BUBBLES) if one.column == column]
        shades[0, own[3]] = 0.3
    first = [k for k, one in enumerate(page.BUBBLES) if one.column == 1]
    shades[0, first[3]], shades[0, first[7]] = 0.7, 0.2
    strokes = np.zeros((1, len(page.BUBBLES), 4))
    measured = Darkness(shades, strokes, np.ones((1, page.DIGITS + 1)), noise=0.002, outlines=np.full(1, 30.0))
    read = columns(measured)[0]
    assert (read[1].doubt, read[1].open) == ("several", True)
    assert [column.doubt for column in read[2:-1]] == [""] * 4


@pytest.mark.parametrize(("corners", "doubt"), [(4, ""), (3, "crossed out")])
def test_what_is_plainly_crossed_out_raises_no_doubt(corners: int, doubt: str) -> None:
    """Strokes beyond all four corners of a bubble are what the page asks for; it may still be what was meant."""
    shades = np.zeros((2, len(page.BUBBLES)))
    strokes = np.zeros((2, len(page.BUBBLES), 4))
    own = {
        column: [k for k, one in enumerate(page.BUBBLES) if one.column == column]
        for column in range(1, page.DIGITS + 1)
    }
    for places in own.values():
        shades[:, places[3]] = 0.5
    shades[0, own[2][7]] = 0.6
    strokes[0, own[2][7], :corners] = 0.5
    measured = Darkness(shades, strokes, np.ones((2, page.DIGITS + 1)), noise=0.002, outlines=np.full(2, 30.0))
    read = columns(measured)[0][2]
    assert (read.value, read.doubt, read.open) == (3, doubt, False)
    assert 7 in read.others


@pytest.mark.parametrize("corner", range(4))
def test_a_page_with_three_corner_marks_is_not_read(corner: int, english: Built) -> None:
    done = filled(english.pages[0], ["12", "3.4", "5", "6", "7"])
    assert read_page(ScanImage("page", np.asarray(done)), lambda _: 5).answers
    covered = with_hidden_corner(done.resize((2480, 3508)), corner, np.random.default_rng(corner))
    found = read_page(ScanImage("page", np.asarray(covered)), lambda _: 5)
    assert found.why == "not all four black squares in the corners are seen"
    assert not found.answers


def test_what_is_transparent_is_paper(english: Built, tmp_path: Path) -> None:
    right = [written(value) for _, value in english.key[0]]
    drawn = filled(english.pages[0], right)
    ink = Image.new("LA", drawn.size, 0)
    ink.putalpha(drawn.point(lambda level: 255 - level))
    ink.save(tmp_path / "page.png")
    _, marks = mark(english, tmp_path / "marks", tmp_path / "page.png")
    assert [marks[english.code(0), name]["verdict"] for name, _ in english.key[0]] == ["right"] * 5


def test_a_doubtful_reading_that_follows_confirms_itself(english: Built, tmp_path: Path) -> None:
    """What a rubber left beside a digit costs nothing where the number is right given the student's own omega_AB."""
    values = dict(english.key[0])
    follows = written(acceleration(parameters(english.folder, 0), rod=1.3))
    texts = ["", written(1.3 * values["1.omega_AB"]), follows, "", ""]
    digit = page.columns_of(follows)[1]
    assert digit is not None
    filled(english.pages[0], texts, [(2, 1, (digit + 2) % 10, 205)]).save(tmp_path / "page.png")
    _, marks = mark(english, tmp_path / "marks", tmp_path / "page.png")
    assert marks[english.code(0), "1.omega_AB"]["verdict"] == "wrong"
    assert marks[english.code(0), "1.a_B"]["verdict"] == "follow_through"
    assert not rows(tmp_path / "marks" / "review.csv")
    other = written(1.11 * acceleration(parameters(english.folder, 0), rod=1.3))
    digit = page.columns_of(other)[1]
    assert digit is not None
    filled(english.pages[0], [*texts[:2], other], [(2, 1, (digit + 2) % 10, 205)]).save(tmp_path / "page.png")
    _, marks = mark(english, tmp_path / "marks", tmp_path / "page.png", force=True)
    assert marks[english.code(0), "1.a_B"]["verdict"] == "unreadable"
    assert [row["why"] for row in rows(tmp_path / "marks" / "review.csv")] == ["several"]


def test_two_doubtful_readings_do_not_confirm_each_other(english: Built, tmp_path: Path) -> None:
    """Where the rate is doubtful that an acceleration would follow from, both are looked at."""
    values = dict(english.key[0])
    texts = [
        "",
        written(1.3 * values["1.omega_AB"]),
        written(acceleration(parameters(english.folder, 0), rod=1.3)),
        "",
        "",
    ]
    rest = []
    for answer, column in ((1, 2), (2, 1)):
        digit = page.columns_of(texts[answer])[column]
        assert digit is not None
        rest.append((answer, column, (digit + 2) % 10, 205))
    filled(english.pages[0], texts, rest).save(tmp_path / "page.png")
    _, marks = mark(english, tmp_path / "marks", tmp_path / "page.png")
    asked = "1.omega_AB", "1.a_B"
    assert [marks[english.code(0), name]["verdict"] for name in asked] == ["unreadable", "unreadable"]
    assert [row["quantity"] for row in rows(tmp_path / "marks" / "review.csv")] == ["omega_AB", "a_B"]


@pytest.mark.parametrize("seed", [1, 3, 4, 7])
def test_simulated_pages(seed: int, english: Built) -> None:
    """Pens, pencils, crosses, scanners and phones: what is read without a doubt is what was meant."""
    texts = ["-12.5", "0.0512", "703", "", "98.76"]
    rng = np.random.default_rng([seed, 99])
    done = fill(english.pages[0].resize((2480, 3508)), [Answered(text) for text in texts], rng)
    grey = np.asarray(Image.open(io.BytesIO(done.jpeg)))
    found = read_page(ScanImage("page", grey), lambda code: 5 if code.number == 1 else 0)
    assert found.code is not None
    assert found.code.sheet == english.code(0)
    sure = [(own.text, text) for own, text in zip(found.answers, texts, strict=True) if not own.doubts]
    assert len(sure) >= 3
    assert all(read == text for read, text in sure)


def test_an_exam_without_pages_for_answers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "exam.toml").write_text(EXAM.format(language="en").replace("scan = true", "scan = false"), "utf-8")
    out = tmp_path / "out"
    words = ["build", str(tmp_path / "exam.toml"), "--variants", "1", "--format", "xlsx", "--out", str(out)]
    assert main(words) == 0
    (tmp_path / "page.png").write_bytes(b"")
    assert main(["mark", str(out), str(tmp_path / "page.png"), "--out", str(tmp_path / "marks")]) == 2
    assert "built without pages for answers" in capsys.readouterr().err


def test_a_missing_package_is_named(
    english: Built, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "zxingcpp", None)
    (tmp_path / "page.png").write_bytes(b"")
    assert mark(english, tmp_path / "marks", tmp_path / "page.png")[0] == 3
    assert "zxing-cpp; install it in the folder of variantgen" in capsys.readouterr().err


def png_header(width: int, height: int) -> bytes:
    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")
    )


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("scan.pdf", lambda: b"%PDF-1.7 and no more", "is not a readable PDF"),
        ("scan.pdf", lambda: b"", "is not a readable image"),
        ("photo.jpg", lambda: b"\xff\xd8\xff\xe0 broken", "is not a readable image"),
        ("photo.png", lambda: png_header(60_000, 60_000), "million pixels"),
        ("photo.png", lambda: png_header(2_000, 2_000), "the image is damaged"),
    ],
)
def test_files_that_are_no_scans(
    name: str,
    content: Callable[[], bytes],
    said: str,
    english: Built,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / name).write_bytes(content())
    assert mark(english, tmp_path / "marks", tmp_path / name)[0] == 2
    err = capsys.readouterr().err
    assert said in err
    assert name in err
    assert not (tmp_path / "marks").exists()


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ([None, 1, 2, 5, None, None, 2], "12.5"),
        ([0, 0, 0, 5, 1, 2, 1], "-0.0512"),
        ([None, None, 5, 1, 2, None, 1], "0.512"),
        ([None, None, None, 7, 0, 3, None], "703"),
        ([None, 4, 2, None, None, None, 2], "42"),
        ([None, None, None, None, None, None, None], ""),
        ([None, 1, None, 2, None, None, None], None),  # a gap
        ([None, 1, 2, None, None, None, 3], None),  # the mark stands beyond the digits
        ([0, None, None, None, None, None, None], None),  # a minus and nothing else
    ],
)
def test_numbers_of_columns(values: list[int | None], text: str | None) -> None:
    assert number(values) == text


def test_doubtful_columns_are_counted_and_reasons_named_once() -> None:
    own = [Column(None), Column(1, "faint"), Column(2, "faint"), Column(3, "several"), *[Column(None)] * 3]
    assert (reading(own).doubtful, reading(own).doubts) == (3, ("faint", "several"))
