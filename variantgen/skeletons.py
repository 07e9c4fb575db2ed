"""Working beginnings for an author: a family folder, an exam file."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

from variantgen.errors import InputError, Problem
from variantgen.families.reading.folders import family_names
from variantgen.outputs.files.file_names import WINDOWS_DEVICES
from variantgen.resources import templates_dir

_NAME = re.compile(r"[a-z][a-z0-9_]{0,40}")
_PLACE = "__NAME__"


def new_family(name: str, folder: Path) -> Path:
    """Write a family that passes its check into ``folder/name``; returns its path. Raises InputError."""
    _check_name(name)
    if name in family_names():
        raise InputError(
            Problem("the catalogue has a family of this name", key="NAME", value=name, remedy="choose another")
        )
    target = folder / name
    _check_free(target)
    sources = sorted((templates_dir() / "new" / "family").iterdir())
    folder.mkdir(parents=True, exist_ok=True)
    # Written beside the target and renamed, so that the folder is complete or not there.
    with tempfile.TemporaryDirectory(dir=folder, prefix=f".{name}-") as scratch:
        made = Path(scratch) / name
        made.mkdir()
        for source in sources:
            _write(made / source.name, source, name)
        made.rename(target)
    return target


def new_exam(name: str, folder: Path) -> Path:
    """Write an exam file ``folder/name.toml``; returns its path. Raises InputError."""
    _check_name(name)
    target = folder / f"{name}.toml"
    _check_free(target)
    folder.mkdir(parents=True, exist_ok=True)
    _write(target, templates_dir() / "new" / "exam.toml", name)
    return target


def _check_name(name: str) -> None:
    if not _NAME.fullmatch(name):
        raise InputError(
            Problem(
                "a name is a small letter followed by small letters, digits, underscores",
                key="NAME",
                value=name,
                remedy="for example crank_with_two_rods",
            )
        )
    if name in WINDOWS_DEVICES:
        raise InputError(
            Problem("Windows keeps this name for a device", key="NAME", value=name, remedy="choose another")
        )


def _check_free(target: Path) -> None:
    if target.exists():
        raise InputError(Problem("exists already", file=str(target), remedy="choose another name or folder"))


def _write(target: Path, source: Path, name: str) -> None:
    target.write_text(source.read_text("utf-8").replace(_PLACE, name), "utf-8")
