"""Packages of QTI 2.1 and 3.0: their structure by an own reading of the specification, and how they score."""

from __future__ import annotations

import re
from decimal import Decimal
from pathlib import Path
from xml.etree.ElementTree import Element
from xml.parsers.expat import ExpatError

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.outputs.formats.packages import (
    NAME,
    SEAM,
    TITLE,
    XML,
    build,
    direction,
    every,
    exam,
    files_of,
    key,
    local,
    parsed,
    plain,
    space,
    unpacked,
)
from tests.outputs.formats.qti_reading import MATHML, Attempt, check
from variantgen.cli import main
from variantgen.outputs.platforms.point_shares import shares
from variantgen.outputs.qti.dialect import QTI21, QTI30, Dialect
from variantgen.outputs.qti.item import QtiItems
from variantgen.outputs.qti.options import PackageOptions
from variantgen.outputs.qti.package import contents, indexes, names, pack
from variantgen.outputs.qti.package import package as zip_package
from variantgen.outputs.qti.package_images import package_figures
from variantgen.outputs.qti.xml_tree import document

NAMESPACES = {
    "qti21": ("http://www.imsglobal.org/xsd/imsqti_v2p1", "http://www.imsglobal.org/xsd/imscp_v1p1"),
    "qti30": ("http://www.imsglobal.org/xsd/imsqtiasi_v3p0", "http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1"),
}
VERSIONS = sorted(NAMESPACES)
SEEN = re.sub(r"\s+", " ", TITLE)
# All kinds of answers (magnitudes, signed rates, an angle, a sense, a component), a listing, plans of vectors.
PROBLEMS = (
    'family = "sleeve_on_crank"\npoints = 10',
    'family = "four_bar"\nask = ["v_B.angle", "omega_AB.sense", "v_B.x"]\nmethod = "coordinates"\npoints = 7',
    'family = "four_bar"\nask = ["v_B", "a_B"]\nmethod = "graphical"',
)


@pytest.fixture(scope="module")
def russian(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With solutions in English, drawn by chance."""
    text = exam(*PROBLEMS, head='formats = ["qti21", "qti30"]', tables='[solutions]\nlanguage = "en"')
    return build(tmp_path_factory.mktemp("qti") / "ru", text)


@pytest.fixture(scope="module")
def english(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Without solutions, a test for each student, figures as SVG."""
    options = "\n".join(f'[{name}]\ntests = "students"\nnames = true\nfigures = "svg"' for name in VERSIONS)
    text = exam(*PROBLEMS, language="en", head='formats = ["qti21", "qti30"]', tables=options)
    return build(tmp_path_factory.mktemp("qti") / "en", text, "out", "--no-solutions")


@pytest.fixture(params=[(kind, version) for kind in ("russian", "english") for version in VERSIONS], ids="-".join)
def package(request: pytest.FixtureRequest) -> tuple[Path, str]:
    """The folder of a build, and a version."""
    kind, version = request.param
    return request.getfixturevalue(kind), version


def items(files: dict[str, bytes]) -> dict[tuple[str, str], Element]:
    """The items of a package by problem and code."""
    found = {}
    for name, content in files.items():
        match = re.fullmatch(r"i[0-9a-f]{8}-(\d+)-([A-Z0-9-]+)\.xml", name)
        if match:
            found[match[1], match[2]] = parsed(content)
    return found


def assessments(files: dict[str, bytes]) -> list[Element]:
    """The tests of a package."""
    return [parsed(content) for name, content in files.items() if re.fullmatch(r"t[^/]*\.xml", name)]


def test_everything_is_as_the_specification_says(package: tuple[Path, str]) -> None:
    out, version = package
    files = unpacked(out / f"{version}.zip")
    own = items(files)
    assert own.keys() == key(out).keys()
    for tree in (*own.values(), *assessments(files)):
        assert {space(one.tag) for one in tree.iter()} <= {NAMESPACES[version][0], MATHML}
        math = {one for top in every(tree, "math") for one in top.iter()}
        assert all((space(one.tag) == MATHML) == (one in math) for one in tree.iter())
        modern = version == "qti30"
        assert all(local(one.tag).startswith("qti-") == modern for one in every(tree, "itemBody", "qti-item-body"))
        check(plain(tree), modern)


def test_the_manifest_lists_every_file_and_nothing_else(package: tuple[Path, str]) -> None:
    out, version = package
    files = unpacked(out / f"{version}.zip")
    assert next(iter(files)) == "imsmanifest.xml"
    manifest = parsed(files["imsmanifest.xml"])
    assert space(manifest.tag) == NAMESPACES[version][1]
    assert sorted(set(files_of(manifest))) == sorted(files.keys() - {"imsmanifest.xml"})
    kinds = {resource.get("href"): resource.get("type") for resource in every(manifest, "resource")}
    number = version[3] + "p" + version[4]
    for name, content in files.items():
        if name.endswith(".xml") and name != "imsmanifest.xml":
            assert kinds[name] == f"imsqti_{'test' if name.startswith('t') else 'item'}_xmlv{number}"
            tree = parsed(content)
            (resource,) = (one for one in every(manifest, "resource") if one.get("href") == name)
            assert resource.get("identifier") == tree.get("identifier")
            listed = {file.get("href") for file in every(resource, "file")}
            assert listed == {name, *(image.get("src") for image in every(tree, "img"))}
            refs = list(plain(tree).iter("assessmentItemRef"))
            assert [ref.get("href") for ref in refs] == [f"{ref.get('identifier')}.xml" for ref in refs]
            depends = [one.get("identifierref") for one in every(resource, "dependency")]
            assert depends == [ref.get("identifier") for ref in refs]
    (title,) = every(manifest, "string")
    assert title.text == SEEN
    assert [one.text for one in every(manifest, "language")] == [title.get("language")]


def test_the_reading_refuses_what_is_wrong(russian: Path) -> None:
    tree = plain(next(iter(items(unpacked(russian / "qti30.zip")).values())))
    with pytest.raises(AssertionError):
        check(tree, modern=False)  # HTML 5
    for wrong in ("moved", "text", "attribute"):
        body = plain(next(iter(items(unpacked(russian / "qti21.zip")).values())))
        match wrong:
            case "moved":
                body[:] = [*body[1:], body[0]]
            case "text":
                body.text = "text"
            case "attribute":
                next(body.iter("img")).attrib.pop("alt")
        with pytest.raises(AssertionError):
            check(body, modern=False)


def score(item: Element, values: list[float | None]) -> tuple[float, float]:
    """The score of an attempt, and the greatest one."""
    outcomes = Attempt(item, {f"RESPONSE_a{k}": value for k, value in enumerate(values, start=1)}).values
    assert outcomes.get("FEEDBACK", "SOLUTION") == "SOLUTION"
    reached, greatest = outcomes["SCORE"], outcomes["MAXSCORE"]
    assert isinstance(reached, float)
    assert isinstance(greatest, float)
    return reached, greatest


def test_right_numbers_of_the_key_score_and_others_do_not(package: tuple[Path, str]) -> None:
    out, version = package
    own, rows = items(unpacked(out / f"{version}.zip")), key(out)
    points = {"1": 10.0, "2": 7.0, "3": 2.0}
    for where, tree in own.items():
        item, asked = plain(tree), rows[where]
        right: list[float | None] = [row.value for row in asked]
        declared = [float(one.findtext("correctResponse/value") or "") for one in item.iter("responseDeclaration")]
        assert declared == right
        assert all(re.fullmatch(r"-?\d+(\.\d+)?", one.text or "") for one in item.iter("value"))
        assert score(item, right) == (pytest.approx(points[where[0]]), points[where[0]])
        assert score(item, [None] * len(asked))[0] == 0.0
        shares_of = []
        for place, row in enumerate(asked):
            for side in (-1, 1):
                inside = [*right[:place], row.value + side * 0.999 * row.tolerance, *right[place + 1 :]]
                assert score(item, inside)[0] == pytest.approx(points[where[0]])
                step = 1.001 * row.tolerance if row.tolerance else 1e-3
                outside = [*right[:place], row.value + side * step, *right[place + 1 :]]
                shares_of.append(points[where[0]] - score(item, outside)[0])
        assert sum(shares_of) == pytest.approx(2 * points[where[0]])
        assert min(shares_of) >= max(shares_of) - 0.0101


def test_both_versions_say_the_same(russian: Path) -> None:
    old, new = (items(unpacked(russian / f"{version}.zip")) for version in VERSIONS)
    for where in old:
        first, second = plain(old[where]), plain(new[where])
        for name in ("responseDeclaration", "outcomeDeclaration", "responseProcessing"):
            output = [
                [(one.tag, one.attrib, one.text) for top in tree.iter(name) for one in top.iter()]
                for tree in (first, second)
            ]
            assert output[0] == output[1]
            assert output[0]
        texts = ["".join(tree.find("itemBody").itertext()) for tree in (first, second)]  # type: ignore[union-attr]
        assert texts[0] == texts[1]


def test_what_a_student_sees(russian: Path) -> None:
    for version in VERSIONS:
        for (problem, code), tree in items(unpacked(russian / f"{version}.zip")).items():
            assert tree.get("title") == f"{SEEN}. Задача {problem}, вариант {code}"
            assert tree.get(f"{XML}lang") == "ru"
            item = plain(tree)
            body = item.find("itemBody")
            assert body is not None
            text = "".join(body.itertext())
            assert "Дано:" in text
            assert "десятичной точкой" in text
            boxes = [box.get("responseIdentifier") for box in body.iter("textEntryInteraction")]
            assert boxes == [one.get("identifier") for one in item.iter("responseDeclaration")]
            (figure,) = body.iter("img")
            assert "Шарнир" in figure.get("alt", "")
            assert int(figure.get("width", "")) > 100
            if problem == "1":
                line = next("".join(p.itertext()) for p in body.iter("p") if p.find("textEntryInteraction") is not None)
                assert line == "vB\u00a0=\u00a0\u00a0см/с"


def test_solutions_are_shown_after_an_attempt(russian: Path) -> None:
    files = {version: unpacked(russian / f"{version}.zip") for version in VERSIONS}
    for version in VERSIONS:
        for (problem, _), tree in items(files[version]).items():
            (feedback,) = plain(tree).iter("modalFeedback")
            assert (feedback.get("outcomeIdentifier"), feedback.get("identifier")) == ("FEEDBACK", "SOLUTION")
            assert feedback.get("showHide") == "show"
            text = "".join(feedback.itertext())
            assert "Answer:" in text
            assert ("print(" in text) == (problem == "2")
            assert [one.get(f"{XML}lang") for one in every(tree, "div") if one.get(f"{XML}lang")] == ["en"]
            assert all(image.get("alt") for image in every(tree, "img"))
            assert any(every(tree, "math"))
        control = next(plain(assessments(files[version])[0]).iter("itemSessionControl"))
        assert (control.get("maxAttempts"), control.get("showFeedback")) == ("1", "true")


def test_without_solutions_nothing_is_shown(english: Path) -> None:
    for version in VERSIONS:
        files = unpacked(english / f"{version}.zip")
        for tree in items(files).values():
            assert not list(plain(tree).iter("modalFeedback"))
            assert "FEEDBACK" not in {one.get("identifier") for one in plain(tree).iter("outcomeDeclaration")}
        controls = [next(plain(test).iter("itemSessionControl")) for test in assessments(files)]
        assert [control.get("showFeedback") for control in controls] == ["false", "false"]


def test_one_test_draws_a_whole_sheet_without_names(russian: Path) -> None:
    for version in VERSIONS:
        files = unpacked(russian / f"{version}.zip")
        (test,) = map(plain, assessments(files))
        assert test.get("title") == SEEN
        (outer,) = test.findall("testPart/assessmentSection")
        assert [one.get("select") for one in outer.findall("selection")] == ["1"]
        sheets = outer.findall("assessmentSection")
        assert len(sheets) == 2
        for sheet in sheets:
            refs = [ref.get("identifier", "") for ref in sheet.findall("assessmentItemRef")]
            code = (sheet.get("identifier") or "")[1:]
            assert sheet.get("title") == f"Вариант {code}"
            assert [ref[10:] for ref in refs] == [f"{number}-{code}" for number in (1, 2, 3)]
        assert not any("Иванов".encode() in content or b"Brien" in content for content in files.values())


def test_a_test_for_each_student_with_names(english: Path) -> None:
    for version in VERSIONS:
        found = [plain(test) for test in assessments(unpacked(english / f"{version}.zip"))]
        assert len(found) == 2
        assert all(
            not list(test.iter("selection")) and len(list(test.iter("assessmentItemRef"))) == 3 for test in found
        )
        assert [(test.get("title") or "").partition(", ")[2] for test in found] == [NAME, "Иванов Иван"]
        assert all((test.get("title") or "").startswith(f"{SEEN}. Variant ") for test in found)


def test_figures_are_pictures_of_their_kind_kept_once(russian: Path, english: Path) -> None:
    for version in VERSIONS:
        for out, ending, start in ((russian, ".png", b"\x89PNG"), (english, ".svg", b"<?xml")):
            pictures = {name: data for name, data in unpacked(out / f"{version}.zip").items() if name.endswith(ending)}
            assert all(content.startswith(start) for content in pictures.values())
            assert len(set(pictures.values())) == len(pictures) >= 6


def test_same_bytes_for_any_number_of_processes(tmp_path: Path) -> None:
    text = exam('family = "spool"', head='formats = ["qti21", "qti30", "canvas"]')
    one, two = build(tmp_path, text, "one"), build(tmp_path, text, "two", "--jobs", "2")
    for name in ("qti21.zip", "qti30.zip", "canvas.zip"):
        assert (one / name).read_bytes() == (two / name).read_bytes()


@pytest.mark.parametrize("dialect", [QTI21, QTI30])
def test_a_direction_near_the_seam_may_be_given_with_a_turn_more(dialect: Dialect, tmp_path: Path) -> None:
    with direction(tmp_path) as (part, answered):
        items_of = QtiItems(dialect, part.exam, package_figures(part.engine, "svg"), PackageOptions())
        for value, right, wrong in SEAM:
            item = plain(parsed(document(items_of.item(answered(value)))))
            check(item, dialect is QTI30)
            assert [score(item, [given])[0] for given in right] == [1.0] * len(right)
            assert [score(item, [given])[0] for given in wrong] == [0.0] * len(wrong)


def test_a_package_holds_a_file_of_several_parts_once(tmp_path: Path) -> None:
    pieces = []
    for number, files in enumerate(
        ({"a.xml": b"<a/>", "images/x.png": b"x"}, {"b.xml": b"<b/>", "images/x.png": b"x"})
    ):
        pieces.append(tmp_path / f"{number}.zip")
        pieces[-1].write_bytes(pack(files, [number]))
    assert list(indexes(pieces)) == [[0], [1]]
    assert list(names(pieces, "images/")) == ["images/x.png"]
    with zip_package(tmp_path / "whole.zip") as made:
        with made.outline("o.xml") as outline, outline.inside("o", {"t": '<&"\u0007\n'}):
            outline.add(Element("p"))
        for name, content in contents(pieces):
            made.add(name, content)
    found = unpacked(tmp_path / "whole.zip")
    assert list(found) == ["o.xml", "a.xml", "images/x.png", "b.xml"]
    assert parsed(found["o.xml"]).get("t") == '<&"\N{REPLACEMENT CHARACTER}\n'
    with pytest.raises(ExpatError), zip_package(tmp_path / "bad.zip") as made, made.outline("o.xml") as outline:
        with outline.inside("no name"):
            pass
        outline.close()


@given(points=st.none() | st.integers(1, 1000), parts=st.integers(1, 40))
def test_shares_are_equal_and_sum_up(points: int | None, parts: int) -> None:
    found = shares(points, parts)
    assert sum(found) == (parts if points is None else points)
    assert max(found) - min(found) <= Decimal("0.01")


@pytest.mark.parametrize(
    ("table", "output"),
    [
        ('[qti21]\nfigures = "jpg"', ['qti21.figures: expected one of "png", "svg"', "jpg"]),
        ('[qti30]\ntests = "student"', ["qti30.tests", "did you mean students?"]),
        ("[qti30]\nnames = true", ["qti30.names", "names of others", 'tests = "students"']),
        ('[qti21]\nformulas = "latex"', ["qti21.formulas", '"mathml", "html"']),
        ("[qti21]\nfigure = 1", ["qti21.figure: unknown key", "did you mean figures"]),
    ],
)
def test_mistakes_in_options_are_told(
    table: str, output: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(exam('family = "spool"', tables=table, title="T"), "utf-8")
    assert main(["build", str(path), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    said = capsys.readouterr().err
    assert all(part in said for part in output), said
