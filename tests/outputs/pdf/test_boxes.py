"""Nothing on paper lies on anything else, leaves its cell or the page: read back from the PDFs, letter by letter.

By day every form is read in one of two languages, by turns; at night in both.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.letter_boxes import page_letters
from tests.tools import NIGHTLY
from variantgen.cli import main
from variantgen.families.reading.load import load_family
from variantgen.resources import catalog_dir

LANGUAGES = ("en", "ru")
MILLIMETRE = 72 / 25.4
WIDTH, HEIGHT = 210, 297
DASHES = "\N{EM DASH}\N{EN DASH}"
WORD_GAP = 1.8  # mm: between two words of a line
HANGING = 0.8  # mm: punctuation hangs out of the line
FOOT, BODY = 5, 15  # mm: from below, the words at the foot and what is above them
MARGINS = {"sheets": (18, 14), "key": (15, 13), "solutions": (15, 13)}  # mm: sides, top


@pytest.fixture(scope="module", params=LANGUAGES)
def everything(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All documents of an exam with every form of the catalogue that is read in the language."""
    folder = tmp_path_factory.mktemp("everything")
    lines = [f'title = "Plane motion of a rigid body"\nlanguage = "{request.param}"\nseed = 77\n']
    names = [path.parent.name for path in sorted(catalog_dir().glob("*/family.toml"))]
    forms = [(name, form) for name in names for form in load_family(name, ()).forms]
    own = forms if NIGHTLY else forms[LANGUAGES.index(request.param) :: len(LANGUAGES)]
    lines += [f'[[problem]]\nfamily = "{name}"\nform = "{form}"\n' for name, form in own]
    (folder / "exam.toml").write_text("".join(lines), "utf-8")
    assert main(["build", str(folder / "exam.toml"), "--variants", "2", "--out", str(folder / "out")]) == 0
    return folder / "out"


@pytest.mark.parametrize("document", MARGINS)
def test_letters_keep_apart(everything: Path, document: str) -> None:
    side, top = MARGINS[document]
    left, right = (side - HANGING) * MILLIMETRE, (WIDTH - side + HANGING) * MILLIMETRE
    seen = 0
    for number, page in enumerate(page_letters(everything / f"{document}.pdf"), start=1):
        assert list(page.overlaps()) == [], f"page {number}: letters on each other"
        assert page.crossed() == [], f"page {number}: rules through letters"
        outside = page.outside(left, FOOT * MILLIMETRE, right, (HEIGHT - top) * MILLIMETRE)
        assert outside == [], f"page {number}: letters beyond the margins"
        seen += len(page.text)
    assert seen > (10_000 if NIGHTLY else 5_000)


def test_no_column_of_solutions_reaches_into_the_foot(everything: Path) -> None:
    """The text ends 16 mm above the lower edge; the words of the foot lie below 11.6 mm.

    The stroke of an index as in v_A/B hangs lowest: 0.247 + 0.7 * 0.25 em of 9.5 pt, 1.41 mm, below the line.
    """
    for number, page in enumerate(page_letters(everything / "solutions.pdf"), start=1):
        low = (page.boxes[:, 3] > 11.6 * MILLIMETRE) & (page.boxes[:, 1] < 14.55 * MILLIMETRE)
        assert [page.around(int(one)) for one in low.nonzero()[0]] == [], f"page {number}: letters in the foot"


def test_no_formula_of_the_left_column_reaches_into_the_other(everything: Path) -> None:
    """The left column ends at 102 mm, the right one begins at 108 mm; what ends between them belongs to neither.

    The heads of the first page and of problems, and formulas over both columns, go on.
    """
    for number, page in enumerate(page_letters(everything / "solutions.pdf"), start=1):
        left, bottom, right, top = page.boxes.T / MILLIMETRE
        between = (right > 102 + HANGING) & (right < 108) & (bottom > BODY)
        for one in between.nonzero()[0]:
            row = np.minimum(top, top[one]) - np.maximum(bottom, bottom[one]) > 0
            goes_on = (row & (left > right[one] - 0.2) & (left < right[one] + WORD_GAP)).any()
            line = "".join(np.array(list(page.text))[row])
            # Before the first formula of a page nothing but the head of the first page is so wide.
            is_head = one < page.text.find("**") or any(word in line for word in ("Problem", "Задача"))
            assert goes_on or is_head, f"page {number}: {page.around(int(one))}"


def test_pages_of_solutions_are_filled(everything: Path) -> None:
    depths = []
    for page in page_letters(everything / "solutions.pdf"):
        body = page.boxes[page.boxes[:, 1] > BODY * MILLIMETRE]
        depths.append(HEIGHT - body[:, 1].min() / MILLIMETRE if len(body) else None)
    short = [number for number, depth in enumerate(depths, start=1) if depth is not None and depth < HEIGHT / 2]
    assert len(depths) > (100 if NIGHTLY else 50)
    # The last page of each of the two students may be as short as it is.
    blanks = depths.count(None)
    assert len(short) <= 2, f"pages {short} are less than half full"
    assert all(number == len(depths) or abs(number - len(depths) / 2) <= 2 + blanks for number in short)


@pytest.mark.parametrize("document", MARGINS)
def test_no_line_begins_with_a_dash(everything: Path, document: str) -> None:
    edge = (MARGINS[document][0] + 1) * MILLIMETRE
    for number, page in enumerate(page_letters(everything / f"{document}.pdf"), start=1):
        first = [one for one, letter in enumerate(page.text) if letter in DASHES and page.boxes[one, 0] < edge]
        assert [page.around(one) for one in first] == [], f"page {number}: a line begins with a dash"
