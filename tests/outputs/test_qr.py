"""The QR codes of sheets: readers find their text, how large they may grow, a changed manifest gives a message."""

from __future__ import annotations

import json
import random
from pathlib import Path

import numpy as np
import pytest
import segno
import zxingcpp

from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.outputs.qr import qr_rows
from variantgen.outputs.qr_modules import LETTERS, modules

EXAM = '[page]\nduplex = false\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "spool"\nask = ["v_O"]\n'


@pytest.mark.parametrize(("text", "modules"), [("VARIANTGEN:1:0123ABCD:7Q4-K2M", 25), ("A" * 64, 33)])
def test_size(text: str, modules: int) -> None:
    """By the standard: version 2 has 38 capitals at level M, version 3 has 61, version 4 has 90."""
    rows = qr_rows(text)
    assert (len(rows), {len(row) for row in rows}) == (modules, {modules})


def texts(length: int) -> list[str]:
    """Texts of a length, one with every letter in turn and some by chance; none of digits alone."""
    chance = random.Random(length)
    found = ["".join(LETTERS[place % len(LETTERS)] for place in range(10, 10 + length))]
    return found + ["V" + "".join(chance.choices(LETTERS, k=length - 1)) for _ in range(4)]


@pytest.mark.parametrize("length", range(1, 91))
def test_codes_are_read(length: int) -> None:
    for text in texts(length):
        dark = np.array([list(row) for row in modules(text)], dtype=np.uint8)
        picture = np.kron(np.pad(255 * (1 - dark), 4, constant_values=255), np.ones((4, 4))).astype(np.uint8)
        (found,) = zxingcpp.read_barcodes(picture)
        assert found.text == text
        assert found.ec_level == "M"


@pytest.mark.parametrize("length", range(1, 91))
def test_codes_are_those_of_segno(length: int) -> None:
    """Mode, letters, filling, correction, patterns, mask and format, module by module.

    Where letters and the four zeros that end them fill whole codewords, segno fills in another codeword of zeros.
    """
    ends_a_codeword = (4 + 9 + 11 * (length // 2) + 6 * (length % 2) + 4) % 8 == 0
    for text in texts(length) if not ends_a_codeword else ():
        made = segno.make(text, error="m", mask=3, mode="alphanumeric", micro=False, boost_error=False)
        assert modules(text) == tuple(map(bytes, made.matrix))


def test_format_is_that_of_the_table_of_the_standard() -> None:
    """Level M with mask 3 is 101101101001011; twice, to the right below the finder pattern and from below."""
    rows = modules("V")
    size, expected = len(rows), [1, 0, 1, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1]
    assert [*(rows[8][x] for x in (0, 1, 2, 3, 4, 5, 7, 8)), *(rows[y][8] for y in (7, 5, 4, 3, 2, 1, 0))] == expected
    assert [*(rows[size - 1 - i][8] for i in range(7)), *(rows[8][size - 8 + i] for i in range(8))] == expected


@pytest.mark.parametrize("text", ["variantgen", "ВАРИАНТ", "A_B", "A\n"])
def test_letters_that_no_sheet_has(text: str) -> None:
    with pytest.raises(InputError, match="other letters"):
        qr_rows(text)


@pytest.mark.parametrize("text", ["A" * 65, "A" * 100_000, "VARIANTGEN:1:" + "學" * 3000])
def test_a_text_that_is_too_long(text: str) -> None:
    with pytest.raises(InputError) as error:
        qr_rows(text)
    assert "the text of a QR code has more than 64 characters" in str(error.value)
    assert len(str(error.value)) < 300


def test_long_titles_are_no_part_of_it(tmp_path: Path) -> None:
    long = json.dumps("Теоретическая механика " * 200)
    (tmp_path / "exam.toml").write_text(f'title = {long}\ncourse = {long}\nlanguage = "ru"\n' + EXAM, "utf-8")
    out = tmp_path / "out"
    assert main(["build", str(tmp_path / "exam.toml"), "--variants", "1", "--seed", "s" * 5000, "--out", str(out)]) == 0


def test_a_code_that_somebody_wrote_into_the_manifest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "exam.toml").write_text('title = "T"\nlanguage = "en"\n' + EXAM, "utf-8")
    out = tmp_path / "out"
    assert main(["build", str(tmp_path / "exam.toml"), "--variants", "1", "--out", str(out)]) == 0
    manifest = json.loads((out / "manifest.json").read_text("utf-8"))
    manifest["students"][0]["code"] = "ABC-" * 2000 + "ABC"
    (out / "manifest.json").write_text(json.dumps(manifest), "utf-8")
    capsys.readouterr()
    sheet = tmp_path / "sheet.pdf"
    assert main(["remake", str(out), "--student", "1", "--out", str(sheet), "--anyway"]) == 2
    assert "code" in capsys.readouterr().err
    assert not sheet.exists()
