"""Back ends for single figures, one module per format, found by the endings they name.

Each module has ``SUFFIXES`` and ``render(drawing, width_mm=None) -> bytes``. All draw the same
:class:`~variantgen.figure.drawing.Drawing`; a width in millimetres takes the place of the usual size.
"""

from __future__ import annotations

import importlib
import os
import tempfile
from pathlib import Path
from types import ModuleType

from variantgen.errors import InputError, Problem, nearest
from variantgen.figure.drawing import Drawing
from variantgen.figure.motion.plans import without_millimetres
from variantgen.methods.graphical.plan_scale import MILLIMETRES
from variantgen.resources import module_names


def unit(drawing: Drawing, width_mm: float | None = None) -> float:
    """Millimetres of one figure unit, for a drawing of a given width or of the usual size."""
    return MILLIMETRES if width_mm is None else width_mm / drawing.width


def back_ends() -> dict[str, ModuleType]:
    """The module for each ending."""
    found = {}
    for name in module_names(__path__):
        module = importlib.import_module(f"{__name__}.{name}")
        found.update(dict.fromkeys(getattr(module, "SUFFIXES", ()), module))
    return found


def check_ending(path: Path) -> None:
    """Raise InputError for a file whose ending is that of no format of figures."""
    known = back_ends()
    if path.suffix.lower() not in known:
        remedy = nearest(path.suffix.lower(), known)
        raise InputError(Problem("unknown format of a figure", value=path.name or str(path), remedy=remedy))


def write_figure(drawing: Drawing, path: Path, width_mm: float | None = None) -> None:
    """Write a figure, complete or not at all; the format follows the ending. Raises InputError."""
    check_ending(path)
    usual = drawing if width_mm is None else without_millimetres(drawing)
    write_whole(path, back_ends()[path.suffix.lower()].render(usual, width_mm))


def write_whole(path: Path, content: bytes, key: str = "") -> None:
    """Write a file beside its place and move it there. Raises InputError, which names the key, if impossible."""
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=f".{path.name}.", delete=False) as file:
            made = Path(file.name)
        try:
            made.write_bytes(content)
            made.chmod(0o666 & ~_umask())
            made.replace(path)
        except OSError:
            made.unlink(missing_ok=True)
            raise
    except OSError as error:
        raise InputError(Problem(f"cannot be written: {error.strerror}", key=key, value=str(path))) from None


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
