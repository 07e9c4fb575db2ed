"""Exams for learning platforms, built in the same process, and what is shared by the tests of their outputs."""

from __future__ import annotations

import csv
import io
import json
import shutil
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

from variantgen.builder import build
from variantgen.exam.roster import Student, numbered
from variantgen.outputs.formats import read_exam
from variantgen.resources import catalog_dir

HOSTILE = "]]> {1:NUMERICAL:=5} {#1} <script>alert(1)</script> {{7*7}} {{{params}}} ~ = # } %100% /a//b/ & \\(x\\)"


def built(
    folder: Path,
    body: str,
    count: int = 3,
    *,
    title: str = "T",
    language: str = "en",
    students: Sequence[Student] = (),
    jobs: int = 1,
) -> Path:
    """The output folder of an exam file with these lines."""
    folder.mkdir(parents=True, exist_ok=True)
    head = f'title = {json.dumps(title)}\ncourse = {json.dumps(title)}\nlanguage = "{language}"\nsort = "roster"\n'
    (folder / "exam.toml").write_text(head + body, "utf-8")
    build(read_exam(folder / "exam.toml"), students or numbered(count), folder / "out", jobs=jobs)
    return folder / "out"


def hostile_family(folder: Path) -> None:
    """A family ``strange`` in the folder whose title and statement are full of what formats give a meaning."""
    copy = folder / "strange"
    shutil.copytree(catalog_dir() / "spool", copy)
    (copy / "cases.toml").unlink()
    text = (copy / "family.toml").read_text("utf-8").splitlines()
    text[1] = f"title = {{ en = {json.dumps(HOSTILE)}, ru = {json.dumps(HOSTILE)} }}"
    (copy / "family.toml").write_text("\n".join(text), "utf-8")
    for language in ("en", "ru"):
        path = copy / f"statement.{language}.j2"
        path.write_text("{% raw %}" + HOSTILE + "{% endraw %} " + path.read_text("utf-8"), "utf-8")


def key_rows(out: Path) -> dict[tuple[str, str], list[dict[str, str]]]:
    """The rows of the key by code of the sheet and number of the problem."""
    found: dict[tuple[str, str], list[dict[str, str]]] = defaultdict(list)
    for row in csv.DictReader(io.StringIO((out / "key.csv").read_text("utf-8-sig"))):
        found[row["code"], row["problem"]].append(row)
    return found


def content(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
