"""Makes the cards and figures that :mod:`variantgen.studio.gallery.shipped` has.

``python -m variantgen.studio.gallery.shipping`` does it.
"""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from variantgen.studio.gallery.cards import cards_of, family_files
from variantgen.studio.gallery.figures import FIRST_SEED, draw_card
from variantgen.studio.gallery.shipped import FOLDER, INDEX, mark_of, name_of
from variantgen.studio.words import LANGUAGES
from variantgen.studio.workspace import Workspace


def made() -> Iterator[tuple[str, str]]:
    """Names and texts of all files, made anew."""
    with tempfile.TemporaryDirectory() as folder:
        workspace = Workspace(Path(folder))
        index = {}
        for family, path in family_files(workspace).items():
            cards = [{k: v for k, v in card.items() if k != "version"} for card in cards_of(family, path, workspace)]
            index[family] = {"mark": mark_of(path), "cards": cards}
            for card in cards:
                for language in LANGUAGES:
                    figure = draw_card(workspace, family, card["form"], FIRST_SEED, language)
                    yield name_of(family, card["form"], language), figure
        yield INDEX, json.dumps(index, ensure_ascii=False, indent=0) + "\n"


def main() -> None:
    """Make all of them anew."""
    FOLDER.mkdir(exist_ok=True)
    files = dict(made())
    for old in FOLDER.iterdir():
        if old.name not in files:
            old.unlink()
    for name, text in files.items():
        (FOLDER / name).write_text(text, "utf-8", newline="\n")
    sys.stdout.write(f"{len(files)} files, {sum(map(len, files.values())) // 1000} kB in {FOLDER}\n")


if __name__ == "__main__":
    main()
