"""Compilation of LaTeX sources: errors are told, and a run reads and writes nothing outside its folder."""

from __future__ import annotations

import os
import resource
import time
from pathlib import Path

import pikepdf
import pytest

from tests.pdf_text import page_texts
from variantgen.outputs.latex import compiling
from variantgen.outputs.latex.compiling import LatexError, MissingGlyphsError, compile_document

SOURCE = r"\documentclass{article}\begin{document}%s\end{document}"


def compiled(tmp_path: Path, body: str, engine: compiling.Engine = "pdflatex") -> Path:
    (tmp_path / "one.tex").write_text(SOURCE % body, "utf-8")
    compile_document(tmp_path / "one.tex", tmp_path / "one.pdf", engine, "T", "en", 1)
    return tmp_path / "one.pdf"


@pytest.mark.usefixtures("latexmk")
def test_the_first_error_of_a_source_is_told(tmp_path: Path) -> None:
    with pytest.raises(LatexError, match=r"pdflatex cannot compile one\.tex: line 2: Undefined control sequence"):
        compiled(tmp_path, "a\n\\nonsense b")
    assert [path.name for path in tmp_path.iterdir()] == ["one.tex"]


@pytest.mark.usefixtures("latexmk")
def test_a_run_sees_its_folder_alone(tmp_path: Path) -> None:
    (tmp_path / "secret.tex").write_text("secret words")
    for path in ("../secret.tex", str(tmp_path / "secret.tex")):
        with pytest.raises(LatexError, match="secret"):
            compiled(tmp_path, rf"\input{{{path}}}")
    target = tmp_path / "written.txt"
    with pytest.raises(LatexError):
        compiled(tmp_path, rf"\newwrite\w\immediate\openout\w={target} \immediate\write\w{{x}}")
    compiled(tmp_path, rf"x\immediate\write18{{touch {target}}}")
    assert not target.exists()


@pytest.mark.skipif(os.name != "posix", reason="processes are told apart by their groups")
@pytest.mark.usefixtures("latexmk")
def test_a_run_without_end_is_stopped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiling, "_SECONDS", 2)
    monkeypatch.setattr(compiling, "_SECONDS_PER_STUDENT", 0)
    start = time.monotonic()
    with pytest.raises(LatexError, match=r"did not finish one\.tex in 2 s"):
        compiled(tmp_path, r"\loop\iftrue\repeat")
    assert time.monotonic() - start < 30
    assert not (tmp_path / "one.pdf").exists()


@pytest.mark.usefixtures("latexmk")
@pytest.mark.parametrize("limit", [500, 15_000])
def test_a_disk_that_fills_up_is_no_fault_of_the_source(limit: int, tmp_path: Path) -> None:
    """Up to the first limit not even the log is written; the PDF, with its font, is larger than the second."""
    least, most = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, most))
    try:
        with pytest.raises(OSError, match="pdflatex cannot write its files in"):
            compiled(tmp_path, r"some text: fclose: \textbf{more} \emph{more}")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (least, most))
    assert len(compiled(tmp_path, r"some text: fclose: \textbf{more} \emph{more}").read_bytes()) > limit


@pytest.mark.usefixtures("latexmk")
def test_a_pdf_says_its_title_and_language(tmp_path: Path) -> None:
    with pikepdf.open(compiled(tmp_path, "one page")) as pdf:
        assert (str(pdf.docinfo["/Title"]), str(pdf.Root.Lang)) == ("T", "en")
    assert page_texts(tmp_path / "one.pdf")[0].startswith("one page")


@pytest.mark.usefixtures("lualatex")
def test_letters_that_the_font_has_not_are_told(tmp_path: Path) -> None:
    with pytest.raises(MissingGlyphsError) as error:
        compiled(tmp_path, "Ж и Ж", "lualatex")
    assert error.value.letters == ("Ж", "и")
