"""Workbooks that lie about their size or unpack to gigabytes: nobody is lost, and a bound is told in seconds."""

from __future__ import annotations

import resource
import subprocess
import sys
import time
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import openpyxl
import pytest

from variantgen.exam.roster import read_roster

MEMORY = 1_500_000_000
SHEET = "xl/worksheets/sheet1.xml"
ROW = '<row r="{}"><c r="A{}" t="inlineStr"><is><t>x{}</t></is></c></row>'


def workbook(folder: Path, rows: list[list[object]]) -> Path:
    book = openpyxl.Workbook()
    assert book.active is not None
    for row in rows:
        book.active.append(row)
    book.save(folder / "whole.xlsx")
    return folder / "whole.xlsx"


def changed(folder: Path, name: str, edit: Callable[[str], Iterator[str]], rows: int = 10) -> Path:
    """A workbook of some students with one part changed, which may be large when it is unpacked."""
    source = workbook(folder, [["id", "name", "group"], *([f"s{i}", f"N{i}", "A"] for i in range(rows))])
    target = folder / "class.xlsx"
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as new:
        for item in old.namelist():
            with new.open(item, "w", force_zip64=True) as part:
                content = old.read(item)
                for piece in edit(content.decode()) if item == name else [content.decode()]:
                    part.write(piece.encode())
    return target


def repeated(piece: str, times: int) -> Iterator[str]:
    block, (whole, rest) = piece * 1000, divmod(times, 1000)
    for _ in range(whole):
        yield block
    yield piece * rest


@pytest.mark.parametrize("output", ["A1:C6", "A1:B11", "A1", "C3:C4", "A1:C2000"])
def test_a_wrong_dimension_loses_nobody(output: str, tmp_path: Path) -> None:
    path = changed(tmp_path, SHEET, lambda text: iter([text.replace('ref="A1:C11"', f'ref="{output}"')]))
    with zipfile.ZipFile(path) as parts:
        assert f'<dimension ref="{output}"' in parts.read(SHEET).decode()
    assert [(s.id, s.name, s.group) for s in read_roster(path)] == [(f"s{i}", f"N{i}", "A") for i in range(10)]


def far_row(text: str) -> Iterator[str]:
    yield text.replace("</sheetData>", ROW.format(*["2000000000"] * 3) + "</sheetData>")


def far_column(text: str) -> Iterator[str]:
    yield text.replace("</sheetData>", '<row r="12"><c r="ZZZ12"><v>1</v></c></row>' * 5000 + "</sheetData>")


def many(what: str, count: int, end: str) -> Callable[[str], Iterator[str]]:
    """So many copies of something before the end of a table."""

    def filled(text: str) -> Iterator[str]:
        head, tail = text.split(end)
        yield head
        yield from repeated(what, count)
        yield end + tail

    return filled


empty_rows = many("<row/>", 12_000_000, "</sheetData>")
six_million_rows = many("<row/>", 6_000_000, "</sheetData>")
styles = many('<xf numFmtId="0"/>', 3_000_000, "</cellXfs>")
many_styles = many("<xf/>", 390_000, "</cellXfs>")


def run(path: Path) -> tuple[int, str, float]:
    """Build with this roster in a process of bounded memory: exit code, message, seconds."""
    exam = path.with_name("exam.toml")
    exam.write_text('title = "Q"\nlanguage = "en"\n[[problem]]\nfamily = "spool"\n', "utf-8")
    out = path.with_name("none") / "out"
    start = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-m", "variantgen", "build", str(exam), "--roster", str(path), "--out", str(out)],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)),
    )
    return done.returncode, done.stderr, time.perf_counter() - start


@pytest.mark.parametrize(
    ("name", "edit", "said"),
    [
        (SHEET, far_row, ["Sheet", "a row has a number above 1048576"]),
        (SHEET, empty_rows, ["the worksheets of the workbook unpack to 72 MB, more than 50 MB"]),
        (SHEET, six_million_rows, ["more than 200000 rows, empty ones counted"]),
        ("xl/styles.xml", styles, ["styles and other parts", "more than 2 MB"]),
        ("xl/styles.xml", many_styles, ["styles and other parts", "too many entries"]),
    ],
)
def test_a_workbook_beyond_all_bounds(
    name: str, edit: Callable[[str], Iterator[str]], said: list[str], tmp_path: Path
) -> None:
    path = changed(tmp_path, name, edit)
    assert path.stat().st_size < 400_000
    code, message, seconds = run(path)
    assert code == 2, message
    assert "Traceback" not in message
    for part in (*said, str(path), "CSV"):
        assert part in message
    assert seconds < 30


def test_a_far_column_is_no_trouble(tmp_path: Path) -> None:
    assert len(read_roster(changed(tmp_path, SHEET, far_column))) == 10


def test_many_rows_below_the_bounds(tmp_path: Path) -> None:
    """A row at the end of a worksheet, as some programs write, makes no rows between."""
    path = changed(tmp_path, SHEET, lambda text: iter([text.replace("</sheetData>", '<row r="1048576"/></sheetData>')]))
    assert len(read_roster(path)) == 10
