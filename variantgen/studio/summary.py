"""The numbers under the steps: how far the work on an exam has come. They are counted from files, quickly."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from datetime import date
from typing import Any

from variantgen.studio.documents.document import Document
from variantgen.studio.studio import Studio
from variantgen.studio.words import PageWords
from variantgen.studio.workspace import BUILDS, MANIFEST, ROSTER, is_own

USUAL_CLASS = 30  # numbered variants where there is no roster


def problems_of(document: Document) -> list[Mapping[str, Any]]:
    """The tables of the problems of an exam, as the file has them."""
    found = document.state().data.get("problem", [])
    return [item for item in found if isinstance(item, dict)] if isinstance(found, list) else []


def students(studio: Studio) -> int | None:
    """How many students the roster has; None without one."""
    path = studio.workspace.folder / ROSTER
    if not is_own(path, studio.workspace.folder):
        return None
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            return max(0, sum(1 for row in csv.reader(file) if any(row)) - 1)
    except (OSError, UnicodeDecodeError, csv.Error):
        return None


def built_words(words: PageWords, day: date) -> str:
    """A day in words, with the year where it is not this one."""
    month = words.of("frame")["months"].split()[day.month - 1]
    return f"{day.day}\N{NO-BREAK SPACE}{month}" + (f" {day.year}" if day.year != date.today().year else "")


def _built(words: PageWords, studio: Studio, document: Document) -> str:
    """Whether a build of an exam runs, or when the last one was made."""
    frame = words.of("frame")
    if studio.builds.state(document.key).get("phase") in ("begun", "drawing", "typesetting"):
        return frame["in_progress"]
    home = studio.workspace.folder / BUILDS
    days = [] if home.is_symlink() else [path.stat().st_mtime for path in home.glob(f"{document.key}-*/{MANIFEST}")]
    return built_words(words, date.fromtimestamp(max(days))) if days else frame["not_yet"]


def summary(words: PageWords, studio: Studio, document: Document) -> dict[str, str]:
    """The words under each step."""
    problems = problems_of(document)
    points = sum(item["points"] for item in problems if isinstance(item.get("points"), int))
    known = students(studio)
    return {
        "choose": words.counted(len(problems), "problem"),
        "compose": words.counted(points, "point"),
        "roster": words.of("frame")["no_roster"] if known is None else words.counted(known, "student"),
        "build": _built(words, studio, document),
        "mark": "",
    }
