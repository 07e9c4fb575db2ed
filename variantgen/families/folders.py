"""Where families are looked for besides the catalogue."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from variantgen.errors import InputError, Problem

VARIABLE = "VARIANTGEN_FAMILIES"


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
