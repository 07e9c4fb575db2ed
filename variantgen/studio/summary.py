"""The numbers under the steps: how far the work on an exam has come. They are counted from files, quickly."""

from __future__ import annotations

import json
from collections.abc import Mapping
from datetime import date
from typing import Any

from variantgen.errors import InputError
from variantgen.studio.documents.document import Document
from variantgen.studio.studio import Studio
from variantgen.studio.words import PageWords


def problems_of(document: Document) -> list[Mapping[str, Any]]:
    """The tables of the problems of an exam, as the file has them."""
    found = document.state().data.get("problem", [])
    return [item for item in found if isinstance(item, dict)] if isinstance(found, list) else []


def students(studio: Studio) -> int | None:
    """How many students the roster has; None without one. Raises InputError for one that a build would refuse."""
    path = studio.workspace.roster()
    if path is None:
        return None
    from variantgen.exam.roster import read_class

    return len(read_class(path).students)


def groups(studio: Studio) -> set[str]:
    """The groups of the roster; none without one. Raises InputError for one that a build would refuse."""
    path = studio.workspace.roster()
    if path is None:
        return set()
    from variantgen.exam.roster import read_class

    return {student.group for student in read_class(path).students}


def _class_words(words: PageWords, studio: Studio) -> str:
    """The number of students, or that there is no roster, or a wrong one."""
    try:
        known = students(studio)
    except InputError:
        return words.of("frame")["wrong_roster"]
    return words.of("frame")["no_roster"] if known is None else words.counted(known, "student")


def built_words(words: PageWords, day: date) -> str:
    """A day in words, with the year where it is not this one."""
    month = words.of("frame")["months"].split()[day.month - 1]
    return f"{day.day}\N{NO-BREAK SPACE}{month}" + (f" {day.year}" if day.year != date.today().year else "")


def _built(words: PageWords, studio: Studio, document: Document) -> str:
    """Whether a build of an exam runs, or when the last one was made."""
    frame = words.of("frame")
    if studio.builds.state(document.key).get("phase") in ("begun", "drawing", "typesetting"):
        return frame["in_progress"]
    days = [one.day for one in studio.builds.finished(document.key).values()]
    return built_words(words, max(days)) if days else frame["not_yet"]


def _marked(words: PageWords, studio: Studio, document: Document) -> str:
    """How many students of the last build have handed in, as the page Mark has counted last."""
    frame, last = words.of("frame"), next(iter(studio.builds.finished(document.key).values()), None)
    if last is None:
        return ""
    try:
        state = json.loads(studio.workspace.state("marks", f"{last.key}-state.json").read_text("utf-8"))
        return frame["marked"].format(done=int(state["handed_in"]), all=int(state["students"]))
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return frame["not_yet"]


def summary(words: PageWords, studio: Studio, document: Document) -> dict[str, str]:
    """The words under each step."""
    problems = problems_of(document)
    points = sum(item["points"] for item in problems if isinstance(item.get("points"), int))
    return {
        "choose": words.counted(len(problems), "problem"),
        "compose": words.counted(points, "point"),
        "roster": _class_words(words, studio),
        "build": _built(words, studio, document),
        "mark": _marked(words, studio, document),
    }
