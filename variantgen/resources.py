"""Where the catalogue and the templates are: the only module that knows; and which modules stand in a package.

In a wheel both folders are shipped inside the package as ``_shipped/``; in a checkout and in an editable install
they are the folders beside the package. The imported package's own folder is asked first.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent


@cache
def _root() -> Path:
    shipped = _PACKAGE / "_shipped"
    return shipped if shipped.is_dir() else _PACKAGE.parent


def catalog_dir() -> Path:
    """The folder of problem families and of sample exams."""
    return _root() / "catalog"


def templates_dir() -> Path:
    """The folder of document looks and of words per language."""
    return _root() / "templates"


def module_names(path: Iterable[str]) -> list[str]:
    """The modules and packages in a package with this ``__path__``, in alphabetical order, without importing any.

    As ``pkgutil.iter_modules`` finds them, which loads ``inspect`` to do so: a fortieth of what ``solve`` takes.
    """
    found = set()
    for folder in path:
        for entry in Path(folder).iterdir():
            if entry.suffix == ".py" or (entry / "__init__.py").is_file():
                found.add(entry.stem)
    return sorted(found - {"__init__"})


def languages() -> list[str]:
    """Names of the languages there are: each has its file of words."""
    return sorted(path.stem for path in (templates_dir() / "words").glob("*.toml"))


def folder_hash(folder: Path) -> str:
    """Hash (16 hex digits) of the names and bytes of all files below a folder, in sorted order."""
    import hashlib  # with OpenSSL, which `list` and `--help` have no use for

    digest = hashlib.sha256()
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        digest.update(path.relative_to(folder).as_posix().encode() + b"\0")
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()[:16]
