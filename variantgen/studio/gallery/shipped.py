"""The cards of the catalogue and their figures, drawn in advance, so that a gallery is there at the first start.

They lie in ``assets/shipped``. Those of a family whose file, or whose description in ``assets/catalogue.toml``, has
been changed since are left aside: they are made when they are asked for. After a change of the catalogue or of how
figures look, ``python -m variantgen.studio.gallery.shipping`` makes all of them anew.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from variantgen.studio.words import ASSETS

FOLDER = ASSETS / "shipped"
INDEX = "cards.json"


@cache
def _index() -> Mapping[str, Mapping[str, Any]]:
    """What was made for each family: the mark of its file and its cards."""
    try:
        found: Mapping[str, Mapping[str, Any]] = json.loads((FOLDER / INDEX).read_text("utf-8"))
    except (OSError, ValueError):
        return {}
    return found


@cache
def _description() -> bytes:
    return (ASSETS / "catalogue.toml").read_bytes()


def mark_of(path: Path) -> str:
    """What cards and figures of a family depend on, but for the program."""
    return hashlib.sha256(path.read_bytes() + _description()).hexdigest()[:16]


def is_current(family: str, path: Path) -> bool:
    """Whether the cards and figures of a family of the catalogue with this file were made in advance."""
    return family in _index() and _index()[family]["mark"] == mark_of(path)


def shipped_cards(family: str, path: Path) -> list[dict[str, Any]] | None:
    """The cards of a family of the catalogue, without their version; None where they have to be made."""
    return [dict(card) for card in _index()[family]["cards"]] if is_current(family, path) else None


def shipped_figure(family: str, path: Path, form: str, language: str) -> str | None:
    """The first figure of a form; None where it has to be drawn."""
    if not is_current(family, path) or form not in {card["form"] for card in _index()[family]["cards"]}:
        return None
    try:
        return (FOLDER / name_of(family, form, language)).read_text("utf-8")
    except OSError:
        return None


def name_of(family: str, form: str, language: str) -> str:
    """The name of the file of a figure."""
    return f"{family}-{form}-{language}.svg"
