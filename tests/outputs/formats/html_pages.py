"""Exams built as pages of HTML for the tests, and what every page has to fulfil."""

from __future__ import annotations

import base64
import csv
import hashlib
import re
import xml.etree.ElementTree as ET
from functools import cache
from itertools import pairwise
from pathlib import Path

import html5lib

from variantgen.cli import main

XHTML, SVG, MATH = (
    "{http://www.w3.org/1999/xhtml}",
    "{http://www.w3.org/2000/svg}",
    "{http://www.w3.org/1998/Math/MathML}",
)
TITLES = {"en": "Test of June", "ru": "Зачётная работа"}
NAMES = ["Anna Berg", "Пётр Ёлкин", "Chiara Rossi", "Eva Lind"]
# A long solution, figures of plans, a listing, six answers in a row, families to choose from, points.
PROBLEMS = """
[[problem]]
family = "sleeve_on_crank"
points = 3
[[problem]]
families = ["planetary_train", "spool"]
points = 11
[[problem]]
family = "four_bar"
method = "graphical"
[[problem]]
family = "slider_crank"
method = "coordinates"
"""


def exam(
    folder: Path, language: str, more: str = "", problems: str = PROBLEMS, formats: str = '["html", "pdf"]'
) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    head = f'title = "{TITLES[language]}"\ncourse = "Mechanics"\nlanguage = "{language}"\nformats = {formats}\n'
    head += 'sort = "roster"\n'
    (folder / "exam.toml").write_text(head + more + problems, encoding="utf-8")
    rows = "".join(f"{number},{name},G-{number % 2}\n" for number, name in enumerate(NAMES, start=1))
    (folder / "class.csv").write_text("id,name,group\n" + rows, encoding="utf-8")
    return folder


def build(folder: Path, out: str = "out", *options: str) -> Path:
    files = [str(folder / "exam.toml"), "--roster", str(folder / "class.csv")]
    assert main(["build", *files, "--out", str(folder / out), *options]) == 0
    return folder / out


def pages(out: Path) -> list[Path]:
    return sorted((out / "html").rglob("*.html"))


@cache
def read(path: Path) -> ET.Element:
    """A page, read by a parser that takes no mistake."""
    tree: ET.Element = html5lib.HTMLParser(strict=True).parse(path.read_text("utf-8"))
    return tree


def text(node: ET.Element) -> str:
    return "".join(node.itertext())


def key_rows(out: Path) -> list[dict[str, str]]:
    with (out / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


def codes(out: Path) -> list[str]:
    return list(dict.fromkeys(row["code"] for row in key_rows(out)))


def sound(path: Path, language: str) -> None:
    """Check what every page has to fulfil."""
    source, tree = path.read_text("utf-8"), read(path)
    assert tree.get("lang") == language
    ids = [node.get("id") for node in tree.iter() if node.get("id")]
    assert len(ids) == len(set(ids))
    for name in ("aria-labelledby", "aria-describedby"):
        assert {part for node in tree.iter() for part in (node.get(name) or "").split()} <= set(ids)
    local = {(node.get("href") or "")[1:] for node in tree.iter(f"{XHTML}a") if (node.get("href") or "")[0] == "#"}
    assert local <= set(ids)
    assert len(list(tree.iter(f"{XHTML}main"))) == len(list(tree.iter(f"{XHTML}title"))) == 1
    levels = [int(node.tag[-1]) for node in tree.iter() if re.fullmatch(rf"{XHTML}h\d", str(node.tag))]
    assert levels.count(1) == 1
    assert levels[0] == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))
    for head in tree.iter(f"{XHTML}th"):
        assert head.get("scope") in {"col", "row"}
    for drawn in tree.iter(f"{SVG}svg"):
        assert drawn.get("role") == "img"
        assert drawn.get("aria-labelledby")
        assert all(len(text(node)) > 8 for node in drawn if node.tag in {f"{SVG}title", f"{SVG}desc"})
    for label in tree.iter(f"{XHTML}label"):
        assert len(list(label.iter(f"{XHTML}input"))) == 1
        assert text(label).strip()
    needs_nothing(source, tree)


def needs_nothing(source: str, tree: ET.Element) -> None:
    """Check that a page loads nothing and runs nothing, and that it says so to the browser."""
    assert not {f"{XHTML}{name}" for name in ("script", "link", "img", "iframe", "object", "embed", "form")} & {
        node.tag for node in tree.iter()
    }
    for node in tree.iter():
        assert not [name for name in node.attrib if name.startswith("on") or name in {"src", "style"}]
        assert not re.match(r"[a-z]+:|//", node.get("href") or "")
    (style,) = [node.text or "" for node in tree.iter(f"{XHTML}style")]
    assert "url(" not in style
    assert "@import" not in style
    output = {
        node.get("http-equiv") or node.get("name"): node.get("content") or "" for node in tree.iter(f"{XHTML}meta")
    }
    digest = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
    policy = f"default-src 'none'; style-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'"
    assert output["Content-Security-Policy"] == policy
    assert output["viewport"] == "width=device-width, initial-scale=1"
    assert source.startswith("<!doctype html>\n")
