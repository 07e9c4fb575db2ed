"""Packages for Canvas: their structure, what students see, and how Canvas scores.

The schema of QTI 1.2 is in no package that can be installed, and Canvas has habits of its own beyond it. So documents
are compared with what Canvas itself exports: elements, their order, fields of metadata.
"""

from __future__ import annotations

import re
from decimal import Decimal
from pathlib import Path
from urllib.parse import unquote
from xml.etree.ElementTree import Element

import html5lib
import pytest

from tests.outputs.formats.packages import (
    NAME,
    SEAM,
    TITLE,
    build,
    direction,
    every,
    exam,
    files_of,
    key,
    parsed,
    plain,
    space,
    unpacked,
)
from variantgen.cli import main
from variantgen.outputs.qti.canvas_item import CanvasItems
from variantgen.outputs.qti.options import PackageOptions
from variantgen.outputs.qti.package_images import package_figures

QTI = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
SEEN = re.sub(r"\s+", " ", TITLE)
PROBLEMS = (
    'family = "sleeve_on_crank"\nask = ["v_B", "omega_BD", "v_rel_C"]\npoints = 10',
    'family = "four_bar"\nask = ["v_B.angle", "omega_AB.sense"]',
)
SINGLE = ('family = "four_bar"\nask = ["v_B"]\npoints = 5', 'families = ["spool", "rolling_wheel"]\nask = ["v_A"]')
# The children of each element of a document of questions, in their order, as Canvas exports them.
CHILDREN = {
    "questestinterop": "assessment",
    "assessment": "qtimetadata section",
    "section": "selection_ordering? section* item*",
    "selection_ordering": "selection",
    "selection": "selection_number selection_extension",
    "selection_extension": "points_per_item",
    "item": "itemmetadata presentation resprocessing? itemfeedback?",
    "itemmetadata": "qtimetadata",
    "qtimetadata": "qtimetadatafield+",
    "qtimetadatafield": "fieldlabel fieldentry",
    "presentation": "material response_str?",
    "material": "mattext",
    "response_str": "render_fib",
    "render_fib": "response_label",
    "resprocessing": "outcomes respcondition+",
    "outcomes": "decvar",
    "respcondition": "conditionvar setvar? displayfeedback?",
    "itemfeedback": "flow_mat",
    "flow_mat": "material",
    "or": "varequal and",
    "and": "vargte varlte",
}


@pytest.fixture(scope="module")
def russian(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A quiz for each student, with solutions."""
    return build(tmp_path_factory.mktemp("canvas") / "ru", exam(*PROBLEMS, head='formats = ["canvas"]'))


@pytest.fixture(scope="module")
def english(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The statement once, names, SVG, no solutions."""
    options = '[solutions]\ndepth = "none"\n[canvas]\nstatement = "once"\nnames = true\nfigures = "svg"'
    text = exam(*PROBLEMS, language="en", head='formats = ["canvas"]', tables=options)
    return build(tmp_path_factory.mktemp("canvas") / "en", text)


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One quiz that draws."""
    text = exam(*SINGLE, language="en", head='formats = ["canvas"]', tables='[canvas]\nquizzes = "draw"')
    return build(tmp_path_factory.mktemp("canvas") / "drawn", text)


@pytest.fixture(params=["russian", "english", "drawn"])
def out(request: pytest.FixtureRequest) -> Path:
    """The folder of a build."""
    found: Path = request.getfixturevalue(request.param)
    return found


def quizzes(out: Path) -> dict[str, Element]:
    """The documents of questions by the name of the quiz."""
    files = unpacked(out / "canvas.zip")
    names = [name for name in files if name.endswith("/assessment_meta.xml")]
    folders = [name.partition("/")[0] for name in names]
    return {folder: parsed(files[f"{folder}/{folder}.xml"]) for folder in folders}


def questions(tree: Element) -> list[Element]:
    """The items that ask for a number."""
    return [item for item in plain(tree).iter("item") if field(item, "question_type") == "numerical_question"]


def field(item: Element, label: str) -> str:
    """A field of metadata."""
    found = {one.findtext("fieldlabel"): one.findtext("fieldentry") for one in item.iter("qtimetadatafield")}
    return found.get(label) or ""


def shown(item: Element) -> str:
    """The HTML of a question or a text, which is proper HTML."""
    html = item.findtext("presentation/material/mattext") or ""
    html5lib.HTMLParser(strict=True).parseFragment(html)
    return html


def test_documents_are_as_canvas_writes_them(out: Path) -> None:
    for name, tree in quizzes(out).items():
        assert {space(one.tag) for one in tree.iter()} == {QTI}
        idents = [one.get("ident") or "" for one in every(tree, "item", "section", "assessment")]
        assert len(set(idents)) == len(idents)
        assert plain(tree)[0].get("ident") == name
        for one in plain(tree).iter():
            order = CHILDREN.get(one.tag, "")
            if one.tag == "conditionvar":
                order = "|".join(["or", "other", "vargte varlte"])
            wanted = "|".join(
                "".join(f"(?:{part.rstrip('?*+')} ){part[-1] if part[-1] in '?*+' else ''}" for part in way.split())
                for way in order.split("|")
            )
            assert re.fullmatch(wanted, "".join(f"{child.tag} " for child in one)), (one.tag, [c.tag for c in one])
        for item in plain(tree).iter("item"):
            kind = field(item, "question_type")
            assert kind in ("numerical_question", "text_only_question")
            boxes = [box.get("fibtype") for box in item.iter("render_fib")]
            assert boxes == (["Decimal"] if kind == "numerical_question" else [])


def test_the_manifest_lists_every_file_and_nothing_else(out: Path) -> None:
    files = unpacked(out / "canvas.zip")
    manifest = parsed(files["imsmanifest.xml"])
    assert next(iter(files)) == "imsmanifest.xml"
    assert sorted(files_of(manifest)) == sorted(files.keys() - {"imsmanifest.xml"})
    kinds = [(one.get("type") or "").rpartition("/")[2] for one in every(manifest, "resource")]
    count = len(quizzes(out))
    assert kinds.count("imsqti_xmlv1p2") == kinds.count("learning-application-resource") == count
    assert kinds.count("webcontent") == len(kinds) - 2 * count > 0
    used = set()
    for tree in quizzes(out).values():
        for text in every(tree, "mattext"):
            for source in re.findall(r'<img [^>]*src="([^"]*)"', text.text or ""):
                root, _, name = unquote(source).partition("/")
                assert root == "$IMS-CC-FILEBASE$"
                used.add(name)
    assert used == {name for name in files if name.startswith("images/")}


def score(item: Element, given: float) -> float:
    """What Canvas gives for a number: the first condition that holds and ends decides."""

    def holds(test: Element) -> bool:
        bound = Decimal(test.text or "0") if len(test) == 0 and test.tag != "other" else Decimal(0)
        number = Decimal(repr(given))
        match test.tag:
            case "or":
                return any(map(holds, test))
            case "and" | "conditionvar":
                return all(map(holds, test))
            case "varequal":
                return number == bound
            case "vargte":
                return number >= bound
            case "varlte":
                return number <= bound
            case "other":
                return True
        raise AssertionError(test.tag)

    for condition in item.findall("resprocessing/respcondition"):
        (test,) = condition.findall("conditionvar")
        if holds(test):
            for change in condition.findall("setvar"):
                assert (change.get("action"), change.get("varname"), change.text) == ("Set", "SCORE", "100")
                return float(change.text or "0")
            assert condition.get("continue") == "Yes"
    return 0.0


def test_right_numbers_of_the_key_score_and_others_do_not(out: Path) -> None:
    rows = [row for found in key(out).values() for row in found]
    asked = [item for tree in quizzes(out).values() for item in questions(tree)]
    assert len(asked) == len(rows)
    found = {
        (match[1], match[2], int(match[3])): item
        for item in asked
        if (match := re.fullmatch(r"i[0-9a-f]{8}-(\d+)-([A-Z0-9-]+)-a(\d+)", item.get("ident") or ""))
    }
    for (problem, code), own in key(out).items():
        for place, row in enumerate(own, start=1):
            item = found[problem, code, place]
            exact = Decimal(item.findtext("resprocessing/respcondition/conditionvar/or/varequal") or "")
            upper = Decimal(item.findtext("resprocessing/respcondition/conditionvar/or/and/varlte") or "")
            assert float(exact) == row.value
            assert float(upper - exact) == row.tolerance  # the margin that Classic Quizzes read
            assert score(item, row.value) == 100
            for side in (-1, 1):
                assert score(item, row.value + side * 0.999 * row.tolerance) == 100
                step = 1.001 * row.tolerance if row.tolerance else 1e-3
                assert score(item, row.value + side * step) == 0
            if ".angle" in row.quantity and abs(row.value) + row.tolerance < 180:
                assert score(item, row.value + 360) == 0


def test_a_direction_near_the_seam_may_be_given_with_a_turn_more(tmp_path: Path) -> None:
    with direction(tmp_path) as (part, answered):
        make = CanvasItems(part.exam, package_figures(part.engine, "svg"), PackageOptions(formulas="html"), once=False)
        for value, right, wrong in SEAM:
            (item,) = make.items(answered(value))
            assert [score(item, given) for given in right] == [100] * len(right)
            assert [score(item, given) for given in wrong] == [0] * len(wrong)
            assert shown(item).count("<img") == 1


def test_points_are_those_of_the_problems(out: Path) -> None:
    files = unpacked(out / "canvas.zip")
    for name, tree in quizzes(out).items():
        meta = plain(parsed(files[f"{name}/assessment_meta.xml"]))
        groups = [Decimal(one.text or "") for one in every(tree, "points_per_item")]
        points = groups or [Decimal(field(item, "points_possible")) for item in questions(tree)]
        assert sum(points) == Decimal(meta.findtext("points_possible") or "") == (6 if groups else 12)
        assert meta.findtext("assignment/points_possible") == meta.findtext("points_possible")
        assert meta.get("identifier") == meta.findtext("assignment/quiz_identifierref") == name
        assert meta.findtext("only_visible_to_overrides") == ("false" if groups else "true")
        assert meta.findtext("available") == "false"


def test_every_question_has_statement_figure_and_what_is_asked(russian: Path) -> None:
    for tree in quizzes(russian).values():
        asked = questions(tree)
        assert [field(item, "points_possible") for item in asked] == ["3.34", "3.33", "3.33", "1", "1"]
        for item, which, symbol in zip(
            asked,
            ("1 из 3", "2 из 3", "3 из 3", "1 из 2", "2 из 2"),
            ("см/с", "рад/с", "см/с", "°", "sgn"),
            strict=True,
        ):
            html = shown(item)
            assert "Дано:" in html
            assert re.search(r'<img [^>]*alt="[^"]*Шарнир', html)
            assert f"<strong>Ответ {which}: </strong>" in html
            assert symbol in html.partition("Ответ")[2]
            assert "десятичной точкой" in html


def test_the_solution_follows_the_last_number_of_a_problem(russian: Path) -> None:
    for tree in quizzes(russian).values():
        output = []
        for item in questions(tree):
            links = [one.get("linkrefid") for one in item.iter("displayfeedback")]
            own = [one.get("ident") for one in item.iter("itemfeedback")]
            assert links == own
            output.append(bool(own))
            for one in item.iter("itemfeedback"):
                html = one.findtext("flow_mat/material/mattext") or ""
                html5lib.HTMLParser(strict=True).parseFragment(html)
                assert "Ответ:" in html
                assert "<math" not in html
                assert all(re.findall(r'<img [^>]*alt="([^"]*)"', html))
        assert output == [False, False, True, False, True]


def test_the_statement_once_before_its_questions(english: Path) -> None:
    for tree in quizzes(english).values():
        kinds = [field(item, "question_type") for item in plain(tree).iter("item")]
        number = "numerical_question"
        assert kinds == ["text_only_question", number, number, number, "text_only_question", number, number]
        text = ""
        for item in plain(tree).iter("item"):
            if field(item, "question_type") == "text_only_question":
                text = item.get("ident") or ""
                assert "Given:" in shown(item)
                assert field(item, "points_possible") == "0"
                assert not list(item.iter("resprocessing"))
            else:
                assert field(item, "parent_stimulus_item_ident") == text
                assert "<img" not in shown(item)
                assert re.match(r"<p><strong>Problem \d\. Answer \d of \d: </strong>", shown(item))
            assert not list(item.iter("itemfeedback"))


def test_titles(english: Path, russian: Path) -> None:
    titles = [plain(tree)[0].get("title") or "" for tree in quizzes(english).values()]
    assert [title.partition(", ")[2] for title in titles] == [NAME, "Иванов Иван"]
    for name, tree in quizzes(russian).items():
        code = name[10:]
        assert plain(tree)[0].get("title") == f"{SEEN}. Вариант {code}"
        assert [item.get("title") for item in questions(tree)][:2] == [f"Задача 1 ({k}/3). {code}" for k in (1, 2)]
        (title,) = every(parsed(unpacked(russian / "canvas.zip")[f"{name}/assessment_meta.xml"])[0], "title")
        assert title.text == f"{SEEN}. Вариант {code}"
    assert not any(b"Brien" in content for content in unpacked(russian / "canvas.zip").values())


def test_one_quiz_draws_a_question_for_each_problem(drawn: Path) -> None:
    ((_, tree),) = quizzes(drawn).items()
    root = plain(tree)[0].find("section")
    assert root is not None
    assert root.get("ident") == "root_section"
    groups = root.findall("section")
    assert [group.get("title") for group in groups] == ["Problem 1", "Problem 2"]
    assert [group.findtext("selection_ordering/selection/selection_number") for group in groups] == ["1", "1"]
    assert [len(group.findall("item")) for group in groups] == [2, 2]
    for group in groups:
        points = group.findtext("selection_ordering/selection/selection_extension/points_per_item")
        assert {field(item, "points_possible") for item in group.findall("item")} == {points}
        assert all("Answer 1 of" not in shown(item) and "Given:" in shown(item) for item in group.findall("item"))


@pytest.mark.parametrize(
    ("problem", "table", "output"),
    [
        (
            'family = "four_bar"\nask = ["v_B", "omega_AB"]',
            'quizzes = "draw"',
            ["problem[1].ask", "different variants", "2 numbers", 'quizzes = "students"'],
        ),
        ('family = "spool"', 'quizzes = "sheets"', ["canvas.quizzes", '"draw", "students"', "sheets"]),
        ('family = "spool"', 'quizzes = "draw"\nstatement = "once"', ["canvas.statement", "drawn like a question"]),
        ('family = "spool"', 'quizzes = "draw"\nnames = true', ["canvas.names", "names of others"]),
        ('family = "spool"', "stem = 1", ["canvas.stem: unknown key"]),
    ],
)
def test_mistakes_in_options_are_told(
    problem: str, table: str, output: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(exam(problem, head='formats = ["canvas"]', tables=f"[canvas]\n{table}", title="T"), "utf-8")
    assert main(["build", str(path), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    said = capsys.readouterr().err
    assert all(part in said for part in output), said
