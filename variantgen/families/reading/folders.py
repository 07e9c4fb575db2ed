"""Where families are looked for, and which there are. Nothing here reads what their files say."""

from __future__ import annotations

import os
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import TypeAlias

from variantgen.errors import InputError, Problem
from variantgen.families.reading.files import FAMILY
from variantgen.resources import catalog_dir

VARIABLE = "VARIANTGEN_FAMILIES"
Folders: TypeAlias = Sequence[str | PathLike[str]] | str | PathLike[str]  # with families, looked through in order


def family_folders(chosen: Sequence[Path] = (), beside: Path | None = None) -> tuple[Path, ...]:
    """Folders of an instructor's own families, nearest first.

    Those chosen on the command line, those of the environment variable ``VARIANTGEN_FAMILIES`` (several are separated
    as in PATH), and the folder of the exam file ``beside``. A family is a folder in one of them with a ``family.toml``.
    Raises InputError for a folder that does not exist.
    """
    listed = [Path(text) for text in os.environ.get(VARIABLE, "").split(os.pathsep) if text]
    for source, folders in (("--families", chosen), (VARIABLE, listed)):
        for folder in folders:
            if not folder.is_dir():
                raise InputError(Problem("is no folder", key=source, value=str(folder), remedy="check the path"))
    near = [beside.resolve().parent] if beside is not None else []
    return tuple(dict.fromkeys(folder.resolve() for folder in (*chosen, *listed, *near)))


def family_names(folders: Folders = ()) -> list[str]:
    """Names of the families in the given folders and in the catalogue, sorted."""
    return sorted({path.parent.name for folder in searched(folders) for path in folder.glob(f"*/{FAMILY}")})


def searched(folders: Folders) -> list[Path]:
    """The given folders, then the catalogue. Raises InputError for what is no path."""
    try:
        return [*map(Path, [folders] if isinstance(folders, str | PathLike) else folders), catalog_dir()]
    except TypeError:
        raise InputError(Problem("expected a list of folders", key="folders", value=repr(folders))) from None


def file_of(name: str, folders: Folders = ()) -> Path | None:
    """The file of a family by its name, in the first folder that has it."""
    return next((path for folder in searched(folders) if (path := folder / name / FAMILY).is_file()), None)
