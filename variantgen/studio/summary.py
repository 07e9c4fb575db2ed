"""The numbers under the steps: how far the work on an exam has come. They are counted from files, quickly."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from typing import Any

from variantgen.studio.documents.document import Document
from variantgen.studio.studio import Studio
from variantgen.studio.words import PageWords
from variantgen.studio.workspace import ROSTER, is_own

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


def summary(words: PageWords, studio: Studio, document: Document) -> dict[str, str]:
    """The words under each step."""
    problems = problems_of(document)
    points = sum(item["points"] for item in problems if isinstance(item.get("points"), int))
    known = students(studio)
    return {
        "choose": words.counted(len(problems), "problem"),
        "compose": words.counted(points, "point"),
        "roster": words.of("frame")["no_roster"] if known is None else words.counted(known, "student"),
        "build": "",
        "mark": "",
    }
