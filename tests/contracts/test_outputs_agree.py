"""One build, the same numbers everywhere: every output has the answers of ``key.csv`` for the same students.

Each output is read by a reader of its own, from what a user gets. An output without a reader here fails.
"""

from __future__ import annotations

import csv
import json
import re
import zipfile
from collections.abc import Callable, Iterator
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path
from xml.etree import ElementTree

import html5lib
import openpyxl
import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.outputs.formats import FORMATS

EXAM = """
title = "Контрольная"
course = "Механика"
language = "{language}"
seed = 11
formats = {formats}
{units}
[solutions]
depth = "answers"
[moodle]
categories = "{categories}"
[[problem]]
family = "four_bar"
ask = ["v_B", "omega_AB", "v_B.angle", "omega_AB.sense"]
points = 7
[[problem]]
families = ["spool", "rolling_wheel"]
[[problem]]
family = "sleeve_on_crank"
ask = ["a_cor_C", "v_rel_C"]
nice = true
"""
ROSTER = "id;name;group\n17;Иванов Иван;М-21\n4;Öztürk Ann;М-22\n99;De la Cruz, Ana;\n5;Bob;М-21\n6;Eve;М-21\n"

Place = tuple[str, int]  # the code of the sheet, the number of the problem
Windows = list[list[tuple[Decimal, Decimal]]]
Read = tuple[Place, list[float], Windows | None]


@pytest.fixture(scope="module", params=["ru", "en"])
def built(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    folder = tmp_path_factory.mktemp(request.param)
    categories = {"ru": "students", "en": "families"}[request.param]
    units = {"ru": "", "en": 'units = "ft"'}[request.param]
    text = EXAM.format(language=request.param, formats=json.dumps(list(FORMATS)), categories=categories, units=units)
    (folder / "exam.toml").write_text(text, "utf-8")
    (folder / "class.csv").write_text(ROSTER, "utf-8")
    arguments = [
        "build",
        str(folder / "exam.toml"),
        "--roster",
        str(folder / "class.csv"),
        "--out",
        str(folder / "out"),
    ]
    assert main(arguments) == 0
    return request.param, folder / "out"


def key(out: Path) -> dict[Place, list[dict[str, str]]]:
    """The rows of ``key.csv`` by problem."""
    found: dict[Place, list[dict[str, str]]] = {}
    with (out / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault((row["code"], int(row["problem"])), []).append(row)
    return found


def place(identifier: str) -> Place:
    """The place in an identifier like ``36b281a5-2-7Q4-K2M``."""
    match = re.search(r"[0-9a-f]{8}-(\d+)-([0-9A-Z]{3}(?:-[0-9A-Z]{3})+)", identifier)
    assert match, identifier
    return match[2], int(match[1])


# Outputs for programs: all digits, and what counts as right.


def moodle(out: Path) -> Iterator[Read]:
    for question in ElementTree.parse(out / "moodle.xml").iterfind("question[@type='cloze']"):
        parts = re.findall(r"\{\d+:NUMERICAL:([^}]*)\}", question.findtext("questiontext/text", ""))
        accepted = [
            [tuple(map(Decimal, one.removeprefix("=").split(":"))) for one in part.split("~")] for part in parts
        ]
        accepted_intervals = [
            [(value - relative_tolerance, value + relative_tolerance) for value, relative_tolerance in part]
            for part in accepted
        ]
        yield place(question.findtext("idnumber", "")), [float(part[0][0]) for part in accepted], accepted_intervals


def prairielearn(out: Path) -> Iterator[Read]:
    for path in (out / "prairielearn").rglob("variants.json"):
        number = int(path.parent.name.split("-")[-2])
        for variant in json.loads(path.read_text("utf-8"), parse_float=Decimal):
            values = [variant["answers"][part["name"]] for part in variant["parts"]]
            answer_tolerances = [Decimal(part["tolerance"]) for part in variant["parts"]]
            accepted_intervals = [
                [(v - m, v + m), *map(tuple, p["also"])]
                for v, m, p in zip(values, answer_tolerances, variant["parts"], strict=True)
            ]
            yield (variant["code"], number), list(map(float, values)), accepted_intervals


def qti(out: Path, name: str) -> Iterator[Read]:
    with zipfile.ZipFile(out / f"{name}.zip") as archive:
        for file in archive.namelist():
            if file.startswith("i") and "/" not in file and file != "imsmanifest.xml":
                tree = ElementTree.fromstring(archive.read(file))
                declared = [e for e in tree if re.fullmatch(r"\{.*\}(qti-)?response-?declaration", e.tag.lower())]
                values = [e.text for one in declared for e in one.iter() if (e.text or "").strip()]
                yield place(file), list(map(float, values)), None


def canvas(out: Path) -> Iterator[Read]:
    """An item for each number; its exact answer stands in ``varequal``."""
    space = "{http://www.imsglobal.org/xsd/ims_qtiasiv1p2}"
    with zipfile.ZipFile(out / "canvas.zip") as archive:
        for file in archive.namelist():
            if "/i" in file and file.endswith(".xml"):
                found: dict[Place, list[float]] = {}
                for item in ElementTree.fromstring(archive.read(file)).iter(f"{space}item"):
                    own = [float(e.text or "") for e in item.iter(f"{space}varequal")]
                    found.setdefault(place(item.get("ident", "")), []).extend(own[:1])
                yield from ((where, values, None) for where, values in found.items())


def xlsx(out: Path) -> Iterator[Read]:
    rows = list(openpyxl.load_workbook(out / "key.xlsx").worksheets[0].iter_rows(values_only=True))
    found: dict[Place, list[tuple[float, tuple[Decimal, Decimal]]]] = {}
    for row in rows[1:]:
        value, low, high = row[7:10]
        found.setdefault((row[0], row[4]), []).append((float(value), (Decimal(str(low)), Decimal(str(high)))))
    for where, own in found.items():
        yield where, [value for value, _ in own], [[window] for _, window in own]


PROGRAMS: dict[
    str, Callable[[Path], Iterator[tuple[Place, list[float], list[list[tuple[Decimal, Decimal]]] | None]]]
] = {
    "moodle": moodle,
    "prairielearn": prairielearn,
    "qti21": lambda out: qti(out, "qti21"),
    "qti30": lambda out: qti(out, "qti30"),
    "canvas": canvas,
    "xlsx": xlsx,
}

# Outputs for people: the printed number, found in the text under the code of the sheet.


def page(path: Path) -> str:
    tree = html5lib.parse(path.read_text("utf-8"), namespaceHTMLElements=False)
    for parent in list(tree.iter()):
        for contents in parent.findall("nav"):
            parent.remove(contents)
    return "".join(tree.itertext())


PEOPLE: dict[str, Callable[[Path], dict[str, str]]] = {
    "pdf": lambda out: {name: "".join(page_texts(out / f"{name}.pdf")) for name in ("key", "solutions")},
    "latex": lambda out: {name: "".join(page_texts(out / "latex" / f"{name}.pdf")) for name in ("key", "solutions")},
    "html": lambda out: {name: page(out / "html" / f"{name}.html") for name in ("key", "solutions")},
}


def test_every_output_has_a_reader() -> None:
    assert set(FORMATS) == PROGRAMS.keys() | PEOPLE.keys()


@pytest.mark.parametrize("name", sorted(PROGRAMS))
def test_outputs_for_programs(name: str, built: tuple[str, Path]) -> None:
    truth = key(built[1])
    found = list(PROGRAMS[name](built[1]))
    assert sorted(where for where, _, _ in found) == sorted(truth)
    for where, values, accepted_intervals in found:
        assert values == [float(row["value"]) for row in truth[where]]
        for row, own in zip(truth[where], accepted_intervals or [], strict=accepted_intervals is not None):
            value, relative_tolerance = Decimal(row["value"]), Decimal(row["tolerance"])
            # PrairieLearn compares numbers with rounding errors: what stands at the edge is right there too.
            more = Decimal("2e-9") * abs(value) if name == "prairielearn" else Decimal(0)
            assert value - relative_tolerance - more <= own[0][0] <= value - relative_tolerance
            assert value + relative_tolerance <= own[0][1] <= value + relative_tolerance + more


def printed(row: dict[str, str], language: str) -> str:
    """Four significant digits, or fewer where they are all, with the mark of the language; a sense is 1 or -1."""
    value = float(row["value"])
    if row["quantity"].endswith(".sense"):
        return f"{value:.0f}".replace("-", "\N{MINUS SIGN}")
    exact = Decimal(repr(value))
    rounded = exact.quantize(Decimal(1).scaleb(exact.adjusted() - 3), ROUND_HALF_UP) if value else Decimal(0)
    text = f"{rounded:f}" if len(rounded.as_tuple().digits) < 5 else f"{rounded:.3e}"
    text = f"{exact.normalize() if Decimal(text) == exact else Decimal(text):f}"
    return text.replace("-", "\N{MINUS SIGN}").replace(".", "," if language == "ru" else ".")


@pytest.mark.parametrize("document", ["key", "solutions"])
@pytest.mark.parametrize("name", sorted(PEOPLE))
def test_outputs_for_people(name: str, document: str, built: tuple[str, Path], request: pytest.FixtureRequest) -> None:
    if name == "latex":
        request.getfixturevalue("latexmk")
    language, out = built
    text = re.sub(r"\s+", "", PEOPLE[name](out)[document])
    truth = key(out)
    codes = list(dict.fromkeys(code for code, _ in truth))
    for code in codes:
        # In the key a student's part comes first in the order of the class; in solutions it begins with the code.
        begin = text.index(code)
        ends = [text.find(other, begin + 1) for other in codes if other != code]
        block = text[begin : min((end for end in ends if end > 0), default=len(text))]
        at = 0
        for where, rows in truth.items():
            for row in rows if where[0] == code else []:
                number = printed(row, language)
                assert number in block[at:], f"{where} {row['quantity']}: {number}"
                at = block.index(number, at) + len(number)
