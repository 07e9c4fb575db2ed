"""The QR codes of sheets: how large they may grow, and that a changed manifest gives a message."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.outputs.qr import qr_rows

EXAM = '[page]\nduplex = false\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "spool"\nask = ["v_O"]\n'


@pytest.mark.parametrize(("text", "modules"), [("VARIANTGEN:1:0123ABCD:7Q4-K2M", 25), ("A" * 64, 33)])
def test_size(text: str, modules: int) -> None:
    """By the standard: version 2 has 38 capitals at level M, version 3 has 61, version 4 has 90."""
    rows = qr_rows(text)
    assert (len(rows), {len(row) for row in rows}) == (modules, {modules})


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
