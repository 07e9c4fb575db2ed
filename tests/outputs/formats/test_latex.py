"""LaTeX sources of an exam: what they say, that they compile, and that nothing from outside is a command in them."""

from __future__ import annotations

import contextlib
import csv
import json
import re
import subprocess
import sys
import unicodedata
from collections.abc import Callable
from decimal import Decimal
from pathlib import Path

import pikepdf
import pypdfium2
import pytest

from tests.letter_boxes import page_letters
from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.samples import samples_dir
from variantgen.outputs.formats import latex, read_exam
from variantgen.outputs.latex.characters import CYRILLIC, LATIN, MATH, SIGNS
from variantgen.outputs.latex.compiling import LatexError

ROSTER = "id,name,group\n17,Иванов Иван,М-21\n4,Öztürk-Łódź Ann,М-22\n"


def built(folder: Path, exam: str, roster: str, *options: str, code: int = 0) -> Path:
    """The folder ``latex`` of a build of an exam (a sample, or the text of a file) for a class."""
    folder.mkdir(exist_ok=True)
    (folder / "class.csv").write_text(roster, "utf-8")
    if "\n" in exam:
        (folder / "exam.toml").write_text(exam, "utf-8")
        exam = str(folder / "exam.toml")
    choice = ["--roster", str(folder / "class.csv"), "--format", "latex", "--out", str(folder / "out")]
    assert main(["build", exam, *choice, *options]) == code
    return folder / "out" / "latex"


def exam_text(language: str = "en", options: str = "", title: str = "T", family: str = "spool") -> str:
    head = f'title = {json.dumps(title, ensure_ascii=False)}\nlanguage = "{language}"\n[latex]\n{options}\n'
    return f'{head}[[problem]]\nfamily = "{family}"\n'


def squeezed(text: str) -> str:
    """Text without blanks: a line may be broken anywhere. Apostrophes are curly on paper."""
    return "".join(text.split()).replace("’", "'")


def printed(pdf: Path) -> str:
    return squeezed("".join(page_texts(pdf)))


def key_rows(folder: Path) -> list[dict[str, str]]:
    with (folder.parent / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


def four_digits(value: str, mark: str) -> str:
    """A number as a key prints it: four significant digits, or fewer where they are all, a true minus."""
    number = Decimal(value)
    rounded = number.quantize(Decimal(1).scaleb(number.adjusted() - 3))
    rounded = rounded.quantize(Decimal(1).scaleb(rounded.adjusted() - 3)) if rounded else rounded
    rounded = rounded.normalize() if rounded == number else rounded
    return f"{rounded:f}".replace(".", mark).replace("-", "−")


@pytest.fixture(scope="module")
def samples(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """The sample exams with solutions for two students, built once each."""
    made: dict[str, Path] = {}

    def sample(name: str) -> Path:
        if name not in made:
            made[name] = built(tmp_path_factory.mktemp("latex") / name, name, ROSTER)
        return made[name]

    return sample


@pytest.mark.usefixtures("latexmk")
@pytest.mark.parametrize(("exam", "mark"), [("sample_en", "."), ("sample_ru", ",")])
def test_documents_are_made_and_say_what_the_key_says(samples: Callable[[str], Path], exam: str, mark: str) -> None:
    folder = samples(exam)
    names = {f"{name}.{ending}" for name in ("sheets", "key", "solutions") for ending in ("tex", "pdf")}
    assert {path.name for path in folder.iterdir()} == names
    rows = key_rows(folder)
    pages = page_texts(folder / "key.pdf")
    text = squeezed("".join(pages))
    codes = list(dict.fromkeys(row["code"] for row in rows))
    by_student = text[: text.rindex(squeezed("By problem" if mark == "." else "По задачам"))]
    starts = [*(by_student.index(code) for code in codes), len(by_student)]
    for code, start, end in zip(codes, starts[:-1], starts[1:], strict=True):
        block, place = by_student[start:end], 0
        for row in rows:
            if row["code"] == code:  # the values of a student stand in this order
                value = four_digits(row["value"], mark)
                found = re.compile(rf"[=≈]{re.escape(value)}(?![\d{mark}])").search(block, place)
                assert found, (row, block[place:])
                place = found.end()
    for name in ("sheets", "solutions", "key"):
        found_text = printed(folder / f"{name}.pdf")
        for word in ("ИвановИван", "Öztürk-ŁódźAnn", "М-22", *codes):
            assert word in found_text, (name, word)


@pytest.mark.usefixtures("latexmk")
@pytest.mark.parametrize("exam", ["sample_en", "sample_ru"])
def test_every_student_begins_on_an_odd_page_with_number_one(samples: Callable[[str], Path], exam: str) -> None:
    folder = samples(exam)
    codes = list(dict.fromkeys(row["code"] for row in key_rows(folder)))
    for name in ("sheets", "solutions"):
        pages = page_texts(folder / f"{name}.pdf")
        for code in codes:
            own = [number for number, text in enumerate(pages, start=1) if code in text]
            assert own[0] % 2 == 1
            assert own == list(range(own[0], own[-1] + 1))
            feet = [pages[number - 1].split()[-1] for number in own]
            assert feet == [str(k) for k in range(1, len(own) + 1)]
        with pikepdf.open(folder / f"{name}.pdf") as pdf:
            assert str(pdf.Root.Lang) == exam[-2:]
            assert str(pdf.docinfo["/Title"]) == read_exam(samples_dir() / f"{exam}.toml").title


@pytest.mark.usefixtures("latexmk")
@pytest.mark.parametrize("length", [104, 112])
def test_a_long_course_leaves_the_group_alone(length: int, tmp_path: Path) -> None:
    """The words of the course end well before the word Group, in whatever line they are."""
    course = ("Theoretical mechanics of plane mechanisms, " * 5)[:length].strip(", ")
    text = exam_text().replace("[latex]", f"course = {json.dumps(course)}\n[latex]")
    folder = built(tmp_path, text, "id,name,group\na7,Ann Bell,ME-21\n")
    for name in ("sheets", "solutions"):
        assert squeezed(course) in printed(folder / f"{name}.pdf")
        assert gap_before(folder / f"{name}.pdf", "Group ME-21") > 8


def gap_before(pdf: Path, text: str) -> float:
    """The points between a text of the first page and what stands in its line at its left."""
    with contextlib.closing(pypdfium2.PdfDocument(pdf)) as document:
        page = document[0].get_textpage()
        found = page.search(text).get_next()
        assert found
        start, low, _, high = page.get_charbox(found[0])
        letters = (index for index in range(page.count_chars()) if page.get_text_range(index, 1).strip())
        boxes = [page.get_charbox(index) for index in letters]
    return start - max(right for left, bottom, right, top in boxes if left < start and bottom < high and top > low)


# The foot of a page of solutions, and the lowest letters above it (17 mm and their descenders), in points from below.
BODY, LOWEST = 14 * 72 / 25.4, 15.5 * 72 / 25.4


@pytest.mark.usefixtures("latexmk")
def test_nothing_sticks_out_and_nothing_is_missing(tmp_path: Path) -> None:
    """Long solutions of all kinds, both languages: program listings, plans, long sums and fractions."""
    for language, family in (("en", "three_rod_plate"), ("ru", "two_loop_mechanism")):
        problems = exam_text(language, "compile = false", family=family)
        problems += '[[problem]]\nfamily = "four_bar"\nmethod = "coordinates"\n'
        problems += '[[problem]]\nfamily = "slider_crank"\nmethod = "graphical"\n'
        problems += '[[problem]]\nfamily = "sleeve_on_crank"\nask = ["v_B.angle", "omega_BD.sense", "a_cor_C"]\n'
        folder = built(tmp_path / language, problems, "id,name\n1,Ann\n")
        for name in ("sheets", "key", "solutions"):
            command = ["pdflatex", "-no-shell-escape", "-interaction=nonstopmode", "-halt-on-error", f"{name}.tex"]
            subprocess.run(command, cwd=folder, check=True, capture_output=True)
            log = (folder / f"{name}.log").read_text("latin-1")
            wide = [float(points) for points in re.findall(r"Overfull \\hbox \(([\d.]+)pt too wide", log)]
            assert max(wide, default=0.0) < 5, name
            assert "Missing character" not in log
            if (
                name != "solutions"
            ):  # where columns are tried that are too high, and not taken: their pages are looked at
                assert not re.findall(r"Overfull \\vbox \((?:\d{2,}|[5-9])\.", log), name
        for page in page_letters(folder / "solutions.pdf"):
            assert list(page.overlaps()) == []
            above_foot = page.boxes[page.boxes[:, 1] > BODY]
            assert above_foot[:, 1].min() > LOWEST, "a column runs into the foot"
        assert "np.linalg.solve" in "".join(page_texts(folder / "solutions.pdf"))


def test_a_document_loads_what_it_needs(tmp_path: Path) -> None:
    english = built(tmp_path / "en", exam_text("en", "compile = false"), "id,name\n1,Ann\n")
    for name in ("sheets", "key", "solutions"):
        source = (english / f"{name}.tex").read_text("utf-8")
        assert not re.search(r"T2A|russian|cyrillic|cmap", source)
        assert not re.search("[а-яА-Я]", source)
        assert r"\usepackage[T1]{fontenc}" in source
    assert "tikz" not in (english / "key.tex").read_text()
    assert "fancyvrb" not in (english / "solutions.tex").read_text().split(r"\begin{document}")[0].split("% ----")[0]
    russian = (built(tmp_path / "ru", exam_text("ru", "compile = false"), "id,name\n1,Ann\n") / "sheets.tex").read_text(
        "utf-8"
    )
    assert r"\usepackage[T2A]{fontenc}" in russian
    assert r"\usepackage[russian]{babel}" in russian
    mixed = built(tmp_path / "mixed", exam_text("ru", "compile = false"), "id,name\n1,Łódź\n") / "sheets.tex"
    assert r"\usepackage[T1,T2A]{fontenc}" in mixed.read_text("utf-8")
    assert not list((tmp_path / "ru" / "out" / "latex").glob("*.pdf"))


NAMES = [
    '#read("/etc/passwd")',
    r"\input{|" + '"ls"}',
    r"\write18{touch pwned} \immediate\openout",
    r"$x$ \ # * _ < > & { } ' @ [ ]",
    "% no comment",
    "a--b ---c <<d>> ,,e'' ``f`` ?` !`",
    '"=hyphen "a "o ""',
    r"[x] \\[3cm] ^^41 ~ ^ |",
    "O'Brien 'q' d’Arc Д'Артаньян",
    "office ffi flow",
    r"{{ 7*7 }} \VAR{7*7} %% endfor \BLOCK{if}",
    r"\end{document} \fi \else",
    "Ёлкин-Ђорђевић Ñandú Łódź Ğüneş Šťastný Ґалаґан",
    "№ 5 — «проба» “q” „r‟ – ± × ° §".replace("‟", "“"),
    "{[}]",
    "*",
    "\\",
]


LETTERS = sorted(LATIN | CYRILLIC | MATH.keys() | {sign for sign in SIGNS if not sign.isspace()})
ALIKE = dict(zip("ІЈіјĐ", "IJijÐ", strict=True))  # one character of the font for both


@pytest.mark.usefixtures("latexmk")
@pytest.mark.parametrize("language", ["en", "ru"])
def test_text_appears_as_it_stands(tmp_path: Path, language: str) -> None:
    rows = [["id", "name", "group"]]
    rows += [[f"I{k} {name}", f"N{k} {name}", f"G{k} {name}"] for k, name in enumerate(NAMES)]
    rows += [["long", "x" * 5000, "y" * 300], ["words", "name " * 1000, ""]]
    rows += [[f"L{k}", " ".join(LETTERS[k : k + 40]), ""] for k in range(0, len(LETTERS), 40)]
    with (tmp_path / "rows.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows(rows)
    title = " ".join(NAMES)
    roster = (tmp_path / "rows.csv").read_text("utf-8")
    folder = built(tmp_path / "work", exam_text(language, title=title), roster, "--no-solutions")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["rows.csv", "work"]
    assert sorted(path.name for path in folder.iterdir()) == ["key.pdf", "key.tex", "sheets.pdf", "sheets.tex"]
    sheets, key = printed(folder / "sheets.pdf"), printed(folder / "key.pdf")
    for k, name in enumerate(NAMES):
        assert squeezed(f"N{k} {name}") in sheets
        assert squeezed(f"N{k} {name}") in key
        assert squeezed(f"G{k} {name}") in sheets
    assert squeezed(title) in sheets
    assert "root:x:" not in sheets + key
    assert sheets.count("x") >= 5000
    assert sheets.count("name") >= 1000
    # A letter with an accent may be put together of two characters of a font, but its letter is there.
    found = {unicodedata.normalize("NFD", letter)[0] for letter in sheets}
    wanted = {unicodedata.normalize("NFD", letter)[0] for letter in LATIN | CYRILLIC if letter.isalpha()}
    assert {ALIKE.get(letter, letter) for letter in wanted - found} <= found


@pytest.mark.parametrize(
    ("name", "engine", "output"),
    [
        ("学生 Ann", "pdflatex", ["student 7", "学 (U+5B66), 生 (U+751F)", 'engine = "lualatex"', "font"]),
        ("שלום", "pdflatex", ["student 7", "U+05E9", "latex out of the formats"]),
        ("שלום", "lualatex", ["student 7", "U+05E9", "latex out of the formats"]),
        ("a\u0301\u0302\u0303", "pdflatex", ["U+0302"]),
        ("\N{PILE OF POO}", "pdflatex", ["U+1F4A9"]),
    ],
)
def test_letters_that_no_font_has_are_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str, engine: str, output: list[str]
) -> None:
    options = f'compile = false\nengine = "{engine}"'
    roster = f"id,name\n1,Bob\n7,{name}\n"
    built(tmp_path, exam_text(options=options), roster, "--no-solutions", "--jobs", "2", code=2)
    message = capsys.readouterr().err
    for part in output:
        assert part in message
    assert "student 1" not in message
    assert sorted(path.name for path in tmp_path.iterdir()) == ["class.csv", "exam.toml"]


def test_a_title_is_checked_before_anything_is_made(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    built(tmp_path, exam_text(title="試験", options="compile = false"), "id,name\n1,Ann\n", code=2)
    assert "title: pdflatex cannot print 試 (U+8A66)" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "output"),
    [
        ('engine = "xelatex"', "latex.engine: unknown engine"),
        ('compile = "yes"', "latex.compile: expected true or false"),
        ('font = "CMU Serif"', "latex.font: pdflatex has fonts of its own"),
        ('engine = "lualatex"\nfont = "x}\\\\input{y"', "latex.font: expected the name of a font"),
        ("compil = true", "did you mean compile?"),
    ],
)
def test_mistakes_in_the_options_are_told(tmp_path: Path, options: str, output: str) -> None:
    (tmp_path / "exam.toml").write_text(exam_text(options=options), "utf-8")
    with pytest.raises(InputError) as error:
        read_exam(tmp_path / "exam.toml")
    assert output in str(error.value)


@pytest.fixture
def without_latex(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A machine that has no LaTeX."""
    (tmp_path / "bin").mkdir()
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))


@pytest.mark.usefixtures("without_latex")
def test_without_latex_there_are_sources_and_a_note(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = built(tmp_path / "work", exam_text(), "id,name\n1,Ann\n", "--no-solutions")
    assert sorted(path.name for path in folder.iterdir()) == ["key.tex", "sheets.tex"]
    message = capsys.readouterr().err
    assert "latexmk" in message
    assert re.search(r"apt-get install .*\btexlive-latex-recommended\b.*\blmodern\b", message)
    built(tmp_path / "silent", exam_text(options="compile = false"), "id,name\n1,Ann\n", "--no-solutions")
    assert "latexmk" not in capsys.readouterr().err
    built(tmp_path / "wanted", exam_text(options="compile = true"), "id,name\n1,Ann\n", "--no-solutions", code=3)
    assert "compile = true" in capsys.readouterr().err
    assert not (tmp_path / "wanted" / "out").exists()


def test_without_pylatex_the_package_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pylatex", None)
    built(tmp_path, exam_text(), "id,name\n1,Ann\n", code=3)
    assert 'pip install ".[latex]"' in capsys.readouterr().err


@pytest.mark.usefixtures("latexmk")
def test_same_bytes_in_another_folder_and_by_two_processes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    roster = "id,name\n" + "".join(f"{k},Имя {k}\n" for k in range(10))
    one = built(tmp_path / "one", exam_text("ru"), roster, "--no-solutions")
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    two = built(
        tmp_path / "a longer name",
        exam_text("ru"),
        roster,
        "--no-solutions",
        "--jobs",
        "2",
    )
    for name in ("sheets.tex", "sheets.pdf", "key.tex", "key.pdf"):
        assert (one / name).read_bytes() == (two / name).read_bytes(), name


def test_a_problem_can_be_pasted_into_another_document(
    samples: Callable[[str], Path], tmp_path: Path, pdflatex: Callable[[str], Path]
) -> None:
    source = (samples("sample_en") / "sheets.tex").read_text("utf-8")
    _, definitions, rest = source.split("% ----", 2)
    (problem, *_) = re.findall(r"\\begin\{problem\}\{\d\}.*?\\end\{problem\}", rest, re.DOTALL)
    own = [
        r"\documentclass[12pt]{report}\usepackage{amsmath,array,tikz}\usepackage[margin=20mm]{geometry}",
        "% ----" + definitions,
        r"\begin{document}\chapter{Exercises}",
        problem,
        r"\end{document}",
    ]
    (tmp_path / "own.tex").write_text("\n".join(own), "utf-8")
    text = squeezed("".join(page_texts(pdflatex("own.tex"))))
    assert "Problem1(15points)" in text
    assert "Determine:" in text


def test_nothing_is_left_of_a_build_that_cannot_be_compiled(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(source: Path, *_: object) -> None:
        raise LatexError(f"pdflatex cannot compile {source.name}: line 7: Undefined control sequence.")

    monkeypatch.setattr(latex, "compile_document", refused)
    monkeypatch.setattr(latex, "missing", lambda engine: ())
    built(tmp_path, exam_text(), "id,name\n1,Ann\n", code=1)
    assert "cannot compile sheets.tex: line 7" in capsys.readouterr().err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["class.csv", "exam.toml"]


@pytest.mark.usefixtures("lualatex")
def test_lualatex_prints_letters_of_any_font(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    options = 'engine = "lualatex"'
    roster = 'id,name,group\n1,Ђорђевић Łódź Ħal Νίκος,a--b <<c>> "d"\n'
    folder = built(tmp_path / "work", exam_text("ru", options), roster, "--no-solutions")
    text = printed(folder / "sheets.pdf")
    assert "ЂорђевићŁódźĦalΝίκος" in text
    assert 'a--b<<c>>"d"' in text
    assert "рад/с" in text
    built(tmp_path / "more", exam_text("en", options), "id,name\n7,学生\n", "--no-solutions", code=2)
    message = capsys.readouterr().err
    assert "student 7: lualatex cannot print 学 (U+5B66), 生 (U+751F)" in message
    assert 'font = "..."' in message
