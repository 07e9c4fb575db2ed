"""The cards of the catalogue and their figures, drawn in advance, so that a gallery is there at the first start.

They lie in ``assets/shipped``. Those of a family whose file, or whose description in ``assets/catalogue.toml``, has
been changed since are left aside: they are made when they are asked for. After a change of the catalogue or of how
figures look, ``python -m variantgen.studio.shipped`` makes all of them anew.
"""

from __future__ import annotations

import hashlib
import json
import sys
import tempfile
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from variantgen.studio.words import ASSETS, LANGUAGES

_FOLDER = ASSETS / "shipped"
_INDEX = "cards.json"


@cache
def _index() -> Mapping[str, Mapping[str, Any]]:
    """What was made for each family: the mark of its file and its cards."""
    try:
        found: Mapping[str, Mapping[str, Any]] = json.loads((_FOLDER / _INDEX).read_text("utf-8"))
    except (OSError, ValueError):
        return {}
    return found


@cache
def _description() -> bytes:
    return (ASSETS / "catalogue.toml").read_bytes()


def _mark(path: Path) -> str:
    """What cards and figures of a family depend on, but for the program."""
    return hashlib.sha256(path.read_bytes() + _description()).hexdigest()[:16]


def is_current(family: str, path: Path) -> bool:
    """Whether the cards and figures of a family of the catalogue with this file were made in advance."""
    return family in _index() and _index()[family]["mark"] == _mark(path)


def shipped_cards(family: str, path: Path) -> list[dict[str, Any]] | None:
    """The cards of a family of the catalogue, without their version; None where they have to be made."""
    return [dict(card) for card in _index()[family]["cards"]] if is_current(family, path) else None


def shipped_figure(family: str, path: Path, form: str, language: str) -> str | None:
    """The first figure of a form; None where it has to be drawn."""
    if not is_current(family, path) or form not in {card["form"] for card in _index()[family]["cards"]}:
        return None
    try:
        return (_FOLDER / _name(family, form, language)).read_text("utf-8")
    except OSError:
        return None


def _name(family: str, form: str, language: str) -> str:
    return f"{family}-{form}-{language}.svg"


def made() -> Iterator[tuple[str, str]]:
    """Names and texts of all files, made anew."""
    from variantgen.studio.catalogue import cards_of, family_files
    from variantgen.studio.figures import FIRST_SEED, draw_card
    from variantgen.studio.workspace import Workspace

    with tempfile.TemporaryDirectory() as folder:
        workspace = Workspace(Path(folder))
        index = {}
        for family, path in family_files(workspace).items():
            cards = [{k: v for k, v in card.items() if k != "version"} for card in cards_of(family, path, workspace)]
            index[family] = {"mark": _mark(path), "cards": cards}
            for card in cards:
                for language in LANGUAGES:
                    figure = draw_card(workspace, family, card["form"], FIRST_SEED, language)
                    yield _name(family, card["form"], language), figure
        yield _INDEX, json.dumps(index, ensure_ascii=False, indent=0) + "\n"


def main() -> None:
    """Make all of them anew."""
    _FOLDER.mkdir(exist_ok=True)
    files = dict(made())
    for old in _FOLDER.iterdir():
        if old.name not in files:
            old.unlink()
    for name, text in files.items():
        (_FOLDER / name).write_text(text, "utf-8", newline="\n")
    sys.stdout.write(f"{len(files)} files, {sum(map(len, files.values())) // 1000} kB in {_FOLDER}\n")


if __name__ == "__main__":
    main()
