"""Builds for the tests of packages, and an own small reading of QTI."""

from __future__ import annotations

import csv
import io
import json
import re
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from variantgen.cli import main
from variantgen.exam.content import Content
from variantgen.exam.roster import numbered
from variantgen.outputs.formats import Chunk, read_exam
from variantgen.outputs.platforms.questions import Question, questions
from variantgen.outputs.typst.typesetter import typesetter

# A title and a name that no markup, file name or document of XML may break on.
TITLE = '<b>&amp; ]]> "Тест" ../../x {{7*7}} %s'
NAME = 'O\'Brien <script>alert(1)</script> & Ёлкин, "x" ../../../etc'
XML = "{http://www.w3.org/XML/1998/namespace}"


@dataclass(frozen=True)
class Row:
    """A row of key.csv."""

    code: str
    problem: str
    quantity: str
    value: float
    tolerance: float


def build(folder: Path, exam: str, name: str = "out", *more: str) -> Path:
    """Build an exam for two students with strange names; the folder of the output."""
    folder.mkdir(exist_ok=True)
    (folder / "exam.toml").write_text(exam, "utf-8")
    rows = io.StringIO(newline="")
    csv.writer(rows).writerows([("id", "name"), ("7", NAME), ("8", "Иванов Иван")])
    (folder / "class.csv").write_text(rows.getvalue(), "utf-8")
    out = folder / name
    arguments = ["build", str(folder / "exam.toml"), "--roster", str(folder / "class.csv"), "--out", str(out), *more]
    assert main(arguments) == 0
    return out


def exam(*problems: str, language: str = "ru", head: str = "", tables: str = "", title: str = TITLE) -> str:
    """An exam file."""
    tables_of_problems = "\n".join(f"[[problem]]\n{problem}" for problem in problems)
    return (
        f'title = {json.dumps(title, ensure_ascii=False)}\nlanguage = "{language}"\nseed = 3\n'
        f"{head}\n{tables}\n{tables_of_problems}\n"
    )


@contextmanager
def direction(folder: Path) -> Iterator[tuple[Chunk, Callable[[float], Question]]]:
    """A part of an exam without solutions, and its question for a direction with another answer, within 1 degree."""
    (folder / "exam.toml").write_text(
        exam('family = "four_bar"\nask = ["v_B.angle"]', tables='[solutions]\ndepth = "none"'), "utf-8"
    )
    read = read_exam(folder / "exam.toml")
    sheets = drawn_sheets(replace(read, seed="1"), numbered(1))
    with typesetter() as engine:
        part = Chunk(Content(read, sheets), True, engine)
        asked = next(questions(part))
        (number,) = asked.parts

        def answered(value: float) -> Question:
            answer = replace(number.answer, value=value, tolerance=1.0)
            return replace(asked, parts=(replace(number, answer=answer),))

        yield part, answered


# Directions, and what is right and wrong for them within 1 degree.
SEAM = [
    (179.5, [179.5, 178.6, 180.4, -180.5, -179.6, -181.4], [178.4, 180.6, -179.4, -181.6, 0.5]),
    (-179.5, [-179.5, -178.6, 180.5, 181.4], [-178.4, 178.0, 181.6]),
    (10.0, [10.0, 9.1, 10.9], [8.9, 370.0, -350.0]),
]


def key(out: Path) -> dict[tuple[str, str], list[Row]]:
    """The rows of key.csv by problem and code."""
    found: dict[tuple[str, str], list[Row]] = {}
    for row in csv.DictReader(io.StringIO((out / "key.csv").read_text("utf-8-sig"))):
        one = Row(row["code"], row["problem"], row["quantity"], float(row["value"]), float(row["tolerance"]))
        found.setdefault((one.problem, one.code), []).append(one)
    return found


def unpacked(path: Path) -> dict[str, bytes]:
    """The files of a package; each name is there once, harmless, and of the first day of archives."""
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        entries = archive.infolist()
        assert all(entry.date_time == (1980, 1, 1, 0, 0, 0) for entry in entries)
        names = [entry.filename for entry in entries]
        assert len(set(names)) == len(names)
        assert all(re.fullmatch(r"([A-Za-z0-9_-]+/)?[A-Za-z0-9_-]+\.(xml|png|svg)", name) for name in names)
        return {name: archive.read(name) for name in names}


def parsed(content: bytes) -> Element:
    """A document of XML."""
    return ElementTree.fromstring(content)


def local(tag: str) -> str:
    """The name of an element without its namespace."""
    return tag.rpartition("}")[2]


def space(tag: str) -> str:
    """The namespace of an element."""
    return tag[1:].partition("}")[0]


def plain(tree: Element) -> Element:
    """A tree without namespaces, with the names of QTI 2.1."""

    def camel(name: str) -> str:
        return re.sub("-([a-z])", lambda found: found[1].upper(), name)

    made = Element(camel(local(tree.tag).removeprefix("qti-")))
    attributes = {name: value for name, value in tree.attrib.items() if not name.startswith("{")}
    made.attrib = {camel(name): value for name, value in attributes.items()}
    made.text, made.tail = tree.text, tree.tail
    made.extend(plain(child) for child in tree)
    return made


def every(tree: Element, *names: str) -> Iterator[Element]:
    """The elements of these names anywhere in a tree."""
    return (one for one in tree.iter() if local(one.tag) in names)


def files_of(manifest: Element) -> list[str]:
    """What the resources of a manifest list; a resource lists its own place first and depends on what is there."""
    resources = list(every(manifest, "resource"))
    names = [resource.get("identifier", "") for resource in resources]
    assert len(set(names)) == len(names)
    for resource in resources:
        found = [file.get("href", "") for file in every(resource, "file")]
        assert resource.get("href", found[0]) == found[0]
        assert {depends.get("identifierref") for depends in every(resource, "dependency")} <= set(names)
    return [file.get("href", "") for resource in resources for file in every(resource, "file")]
