"""Hypothesis profiles (the default for every run, a longer one for the night), options of the tests, LaTeX."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from tests.tools import need

# Where no compiled modules may lie beside the sources, they are kept elsewhere: every process that a test starts would
# compile the program anew, which takes longer than most of what it then does.
if os.environ.pop("PYTHONDONTWRITEBYTECODE", "") and "PYTHONPYCACHEPREFIX" not in os.environ:
    sys.pycache_prefix = str(Path(__file__).resolve().parents[1] / ".pytest_cache" / "compiled")
    os.environ["PYTHONPYCACHEPREFIX"] = sys.pycache_prefix
    sys.dont_write_bytecode = False

# A shell starts what it puts into the background with Ctrl-C ignored, and so would be the builds that tests stop by it.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

settings.register_profile("default", deadline=None, max_examples=60, derandomize=True)
settings.register_profile("nightly", deadline=None, max_examples=2000, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "default"))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--renew", action="store_true", help="write the reference drawings anew")


def _need_latex(programs: list[str], styles: list[str], packages: str) -> None:
    """Skip a test where there is no LaTeX; where CI runs, there has to be one."""
    found = all(shutil.which(name) for name in ("kpsewhich", *programs))
    found = found and not subprocess.run(["kpsewhich", *styles], check=False, capture_output=True).returncode
    need(found, "LaTeX", packages)


_STYLES = ["tikz.sty", "amsmath.sty", "geometry.sty", "t2aenc.def", "lmodern.sty"]
_PACKAGES = (
    "texlive-latex-base texlive-latex-recommended texlive-pictures texlive-lang-cyrillic cm-super lmodern latexmk"
)


@pytest.fixture
def latexmk() -> None:
    """There is a pdfLaTeX that latexmk can run."""
    _need_latex(["latexmk", "pdflatex"], _STYLES, _PACKAGES)


@pytest.fixture
def lualatex() -> None:
    """There is a LuaLaTeX that latexmk can run, with a font for Cyrillic letters."""
    _need_latex(["latexmk", "lualatex"], [*_STYLES, "luaotfload.sty"], f"{_PACKAGES} texlive-luatex fonts-cmu")


@pytest.fixture
def pdflatex(tmp_path: Path) -> Callable[[str], Path]:
    """Compiles a file of the folder; where CI runs, there has to be a LaTeX."""
    _need_latex(["pdflatex"], _STYLES, _PACKAGES)

    def compiled(name: str) -> Path:
        command = ["pdflatex", "-no-shell-escape", "-interaction=nonstopmode", "-halt-on-error", name]
        run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, timeout=300)
        assert run.returncode == 0, run.stdout[-2000:]
        return (tmp_path / name).with_suffix(".pdf")

    return compiled
