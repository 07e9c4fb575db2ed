"""The command: wrong options have a message, and so has a missing package."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from variantgen.cli import main


@pytest.mark.parametrize("package", ["starlette", "uvicorn"])
def test_a_missing_package_is_named(package: str, tmp_path: Path) -> None:
    script = (
        f"import sys; sys.modules[{package!r}] = None; from variantgen.cli import main; sys.exit(main(sys.argv[1:]))"
    )
    command = [sys.executable, "-c", script, "studio", str(tmp_path), "--no-browser"]
    run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert run.returncode == 3 and package in run.stderr and ".[studio]" in run.stderr, run.stderr


@pytest.mark.parametrize(("words", "named"), [(["nowhere"], "nowhere"), ([".", "--port", "70000"], "--port")])
def test_wrong_options_have_a_message(words: list[str], named: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["studio", *words, "--no-browser"]) == 2
    assert named in capsys.readouterr().err
