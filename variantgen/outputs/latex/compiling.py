"""PDF from LaTeX sources, by latexmk in a folder of its own; the same source gives the same bytes."""

from __future__ import annotations

import contextlib
import errno
import os
import re
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from variantgen.errors import VariantgenError
from variantgen.outputs.join import join_pdfs
from variantgen.outputs.latex.characters import Engine

_COMMON = "latexmk texlive-latex-recommended texlive-pictures texlive-lang-cyrillic lmodern"
INSTALL = {"pdflatex": f"{_COMMON} cm-super", "lualatex": f"{_COMMON} texlive-luatex fonts-cmu"}
_STYLES = ("babel", "geometry", "fancyhdr", "amsmath", "array", "xcolor", "longtable", "tikz", "graphicx", "fancyvrb")
_FILES = {
    "pdflatex": ("t2aenc.def", "cmap.sty", "fix-cm.sty", "lmodern.sty"),
    "lualatex": ("fontspec.sty", "luaotfload.sty"),
}
_MODES: dict[Engine, str] = {"pdflatex": "-pdf", "lualatex": "-pdflua"}
# What is noted for a next run (pages, languages, widths of tables, which are fixed) changes nothing: no second run.
_ONCE = "$hash_calc_ignore_pattern{'aux'} = '.@abspage@last|.babel@aux|.@nameuse.bbl@|LT@|^ *[{]1[}][{]';"
_DOCUMENT = "document"
_EPOCH = "946684800"  # the first second of the year 2000
_SECONDS, _SECONDS_PER_STUDENT = 180, 60  # before a run is given up
_ERROR = re.compile(r"^(?:\./)?(?P<file>[^\s:]+\.\w+):(?P<line>\d+): (?P<said>.*)$|^! (?P<plain>.*)$", re.MULTILINE)
_MISSING = re.compile(r"^Missing character: There is no (?P<what>.*?) in font", re.MULTILINE)
_CODE = re.compile(r"U\+([0-9A-F]{4,6})")
_NO_ROOM = re.compile(
    r"^(?:!.*: |.*\(file io\): )?(?:fwrite|fflush|fclose)(?:\(\) failed|:)(?: \(?(?P<why>[^)\n]+))?", re.MULTILINE
)


class LatexError(VariantgenError):
    """LaTeX could not compile a source."""


class MissingGlyphsError(LatexError):
    """The font has not all letters of a document: ``letters``."""

    def __init__(self, letters: Sequence[str]) -> None:
        super().__init__(f"the font has no {' '.join(letters)}")
        self.letters = tuple(letters)


def missing(engine: Engine) -> tuple[str, ...]:
    """Programs and packages of LaTeX that are needed and not installed."""
    programs = [name for name in ("latexmk", engine, "kpsewhich") if shutil.which(name) is None]
    if programs:
        return tuple(programs)
    files = ["article.cls", *(f"{name}.sty" for name in _STYLES), *_FILES[engine]]
    run = subprocess.run(  # noqa: S603  (a list of names of this module, no shell)
        [str(shutil.which("kpsewhich")), *files], capture_output=True, text=True, check=False, timeout=60
    )
    found = {Path(line).name for line in run.stdout.splitlines()}
    return tuple(name for name in files if name not in found)


def how_to_install(engine: Engine) -> str:
    """What to do where something is missing."""
    return (
        f"found no {', '.join(missing(engine)[:4])}; install TeX Live or MiKTeX"
        f" (Debian, Ubuntu: apt-get install {INSTALL[engine]})"
    )


def compile_document(source: Path, target: Path, engine: Engine, title: str, language: str, students: int) -> None:
    """Write the PDF of a source.

    Raises LatexError, MissingGlyphsError where the font lacks letters, OSError where LaTeX cannot write its files.
    """
    with tempfile.TemporaryDirectory(prefix="variantgen-latex-") as name:
        folder, document = Path(name), f"{_DOCUMENT}.tex"  # not every engine takes every name of a file
        shutil.copyfile(source, folder / document)
        command = [
            *("latexmk", "-norc", _MODES[engine], "-no-shell-escape", "-e", _ONCE),
            *("-interaction=nonstopmode", "-halt-on-error", "-file-line-error", document),
        ]
        limit = _SECONDS + _SECONDS_PER_STUDENT * students
        code, said = _run(command, folder, limit)
        log = _read(folder / f"{_DOCUMENT}.log")
        made = folder / f"{_DOCUMENT}.pdf"
        if code is None:
            raise LatexError(f"{engine} did not finish {source.name} in {limit} s")
        if room := _NO_ROOM.search(said):
            # Of the log there may be nothing left.
            reason = f": {room['why']}" if room["why"] else ""
            raise OSError(errno.ENOSPC, f"{engine} cannot write its files in {folder.parent}{reason}")
        if code or not made.exists():
            raise LatexError(f"{engine} cannot compile {source.name}: {_first_error(log)}")
        _check_glyphs(log, source.name)
        # Written anew: identifier and dates do not depend on the folder and the time of the run.
        join_pdfs([made], target, title, language, even=False)


def _run(command: Sequence[str], folder: Path, limit: float) -> tuple[int | None, str]:
    """The exit code and output of a program that sees its folder alone; no code if it was stopped after ``limit`` s."""
    with subprocess.Popen(  # noqa: S603  (a list, no shell)
        command,
        cwd=folder,
        env=_environment(),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
        restore_signals=False,  # a file above a limit of the system is an error that LaTeX reports, and no sudden end
    ) as process:
        try:
            said, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            return None, ""
        finally:
            _end(process)
        return process.returncode, said.decode("utf-8", errors="replace")


def _end(process: subprocess.Popen[bytes]) -> None:
    """End a program and what it has started, if it is still running."""
    if process.poll() is None:
        if os.name == "posix":
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()
        process.wait()


def _environment() -> dict[str, str]:
    """The environment of a run: nothing outside its folder and the installation is read or written."""
    kept = {name: value for name, value in os.environ.items() if name not in {"TEXINPUTS", "TEXMFOUTPUT", "BIBINPUTS"}}
    return {
        **kept,
        "openin_any": "p",
        "openout_any": "p",
        "shell_escape": "f",
        "SOURCE_DATE_EPOCH": _EPOCH,
        "FORCE_SOURCE_DATE": "1",
        "max_print_line": "10000",  # no line of the log is broken
    }


def _read(path: Path) -> str:
    return path.read_text("utf-8", errors="replace") if path.exists() else ""


def _first_error(log: str) -> str:
    """The first error that a log tells, with its line."""
    found = _ERROR.search(log)
    if found is None:
        return "it gave no reason"
    return f"line {found['line']}: {found['said']}" if found["file"] else str(found["plain"])


def _check_glyphs(log: str, name: str) -> None:
    """Raise an error if letters are missing in the PDF."""
    missing = [match["what"] for match in _MISSING.finditer(log)]
    if not missing:
        return
    codes = dict.fromkeys(int(code[1], 16) for what in missing if (code := _CODE.search(what)))
    if not codes:
        raise LatexError(f"letters are missing in the PDF of {name}: {', '.join(dict.fromkeys(missing))}")
    raise MissingGlyphsError([chr(code) for code in codes])
