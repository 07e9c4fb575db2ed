"""The folder for PrairieLearn, used as PrairieLearn does: server.py, then Mustache, then the elements.

The order and the data are those of apps/prairielearn/src/question-servers/freeform.ts; what an input accepts is
written anew from apps/prairielearn/elements/pl-number-input/pl-number-input.py.
"""

from __future__ import annotations

import copy
import json
import re
import uuid
import xml.etree.ElementTree as ET
from decimal import Decimal
from pathlib import Path
from typing import Any

import chevron
import html5lib
import pytest

from tests.outputs.formats.platform_exams import HOSTILE, built, content, hostile_family, key_rows
from variantgen.cli import main
from variantgen.exam.roster import Student

TWO = '[[problem]]\nfamily = "four_bar"\n[[problem]]\nfamilies = ["spool", "rolling_wheel"]\n'
FORMAT = 'formats = ["prairielearn"]\n'
NO_SOLUTIONS = '[solutions]\ndepth = "none"\n'
SEEDS = [0, 1, 2, 3, 12, 1_000_003, 2**31 - 1]


class Question:
    """A folder of a question, as PrairieLearn sees it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._functions: dict[str, Any] = {}
        source = (folder / "server.py").read_text("utf-8")
        exec(compile(source, "server.py", "exec"), self._functions)  # the file has no name of its own there

    def generated(self, seed: int) -> dict[str, Any]:
        options = {"question_path": str(self.folder)}
        data = {"params": {}, "correct_answers": {}, "variant_seed": seed, "options": options}
        self._functions["generate"](data)
        assert json.loads(json.dumps(data)) == data
        return data

    def page(self, data: dict[str, Any]) -> ET.Element:
        html = chevron.render((self.folder / "question.html").read_text("utf-8"), data)
        parser = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False)
        found: ET.Element = parser.parseFragment(html)
        return found

    def score(self, data: dict[str, Any], raw: dict[str, str]) -> tuple[float, dict[str, Any]]:
        """What PrairieLearn gives for what a student writes: the score, and errors of format."""
        data = copy.deepcopy(data)
        data.update(raw_submitted_answers=raw, submitted_answers={}, format_errors={}, partial_scores={})
        inputs = {element.get("answers-name", ""): element for element in self.page(data).iter("pl-number-input")}
        for name in inputs:
            try:
                data["submitted_answers"][name] = float(raw[name])
            except ValueError:
                data["submitted_answers"][name], data["format_errors"][name] = None, "no number"
        self._functions["parse"](data)
        if data["format_errors"]:
            return 0.0, data["format_errors"]
        for name, element in inputs.items():
            assert (element.get("comparison"), element.get("rtol")) == ("relabs", "0")
            error = abs(data["submitted_answers"][name] - data["correct_answers"][name])
            right = error <= float(element.get("atol", ""))
            data["partial_scores"][name] = {"score": int(right), "weight": 1}
        data["score"] = sum(one["score"] for one in data["partial_scores"].values()) / len(inputs)
        self._functions["grade"](data)
        json.dumps(data)
        return data["score"], {}


def questions(out: Path) -> list[Question]:
    return [Question(folder) for folder in sorted((out / "prairielearn" / "questions").iterdir())]


def number_of(question: Question) -> str:
    return question.folder.name.split("-")[-2]


@pytest.mark.parametrize("language", ["ru", "en"])
def test_every_variant_has_the_answers_of_the_key(language: str, tmp_path: Path) -> None:
    out = built(tmp_path, FORMAT + NO_SOLUTIONS + TWO, 12, language=language)
    key, found = key_rows(out), []
    for question in questions(out):
        variants = json.loads((question.folder / "variants.json").read_text("utf-8"))
        seen = [question.generated(seed) for seed in range(len(variants))]
        for data in seen:
            found.append((data["params"]["code"], number_of(question)))
            rows = key[found[-1]]
            assert list(data["correct_answers"].values()) == [float(row["value"]) for row in rows]
            page = question.page(data)
            inputs = list(page.iter("pl-number-input"))
            assert [element.get("answers-name") for element in inputs] == list(data["correct_answers"])
            for element, row in zip(inputs, rows, strict=True):
                more = float(element.get("atol", "")) - float(row["tolerance"])
                assert 0 < more <= 1.1e-9 * max(abs(float(row["value"])), float(row["tolerance"]))
            assert all(re.fullmatch(r"\\\(.+\\\) =", element.get("label", "")) for element in inputs)
            units = ["".join(re.findall(r"\\text\{(.*?)\}", element.get("suffix", ""))) for element in inputs]
            assert all(units)
            assert [("рад" in unit, "rad" in unit) for unit in units] == [
                ("rad" in row["unit"] and language == "ru", "rad" in row["unit"] and language == "en") for row in rows
            ]
            assert page.find(".//pl-answer-panel") is None
    assert sorted(found) == sorted(key)


def test_a_seed_gives_the_same_variant_every_time(tmp_path: Path) -> None:
    out = built(tmp_path, FORMAT + NO_SOLUTIONS + TWO, 4)
    for question in questions(out):
        for seed in SEEDS:
            assert question.generated(seed) == Question(question.folder).generated(seed)
        assert len({question.generated(seed)["params"]["code"] for seed in range(40)}) == len(
            json.loads((question.folder / "variants.json").read_text("utf-8"))
        )


def test_the_number_of_inputs_is_that_of_the_variant(tmp_path: Path) -> None:
    body = '[[problem]]\nfamily = "triangle_plate"\n'
    (question,) = questions(built(tmp_path, FORMAT + NO_SOLUTIONS + body, 16))
    assert {len(list(question.page(question.generated(seed)).iter("pl-number-input"))) for seed in range(16)} == {2, 3}


@pytest.mark.parametrize("form", ["svg", "png"])
def test_all_figures_are_there_and_none_besides(form: str, tmp_path: Path) -> None:
    body = f'[prairielearn]\nfigures = "{form}"\n[[problem]]\nfamily = "four_bar"\n'
    (question,) = questions(built(tmp_path, FORMAT + body, 2))
    folder = question.folder / "clientFilesQuestion"
    used = set()
    for seed in (0, 1):
        page = question.page(question.generated(seed))
        shown = list(page.iter("pl-figure"))
        assert len(shown) >= 4
        assert len(shown[0].get("alt", "")) > 30
        assert all(100 < int(element.get("width", "")) < 1000 for element in shown)
        used |= {element.get("file-name") for element in shown}
        assert len(page.findall(".//pl-answer-panel")) == 1
        # PrairieLearn does not escape text right after an element of its own, nor at the start of a panel.
        assert not any((element.tail or "").strip() for element in shown)
        panels = [*page.iter("pl-question-panel"), *page.iter("pl-answer-panel")]
        assert not any((panel.text or "").strip() for panel in panels)
    assert {path.name for path in folder.iterdir()} == used
    for path in folder.iterdir():
        assert re.fullmatch(rf"[0-9a-f]{{20}}\.{form}", path.name)
        if form == "png":
            assert path.read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
        else:
            assert ET.parse(path).getroot().tag == "{http://www.w3.org/2000/svg}svg"


def test_answers_are_graded(tmp_path: Path) -> None:
    (question,) = questions(
        built(tmp_path, FORMAT + NO_SOLUTIONS + '[[problem]]\nfamily = "spool"\n', 3, language="ru")
    )
    data = question.generated(1)
    right = {name: repr(value) for name, value in data["correct_answers"].items()}
    assert question.score(data, right) == (1.0, {})
    commas = {name: text.replace(".", ",").replace("-", "\N{MINUS SIGN}") for name, text in right.items()}
    assert any("," in text for text in commas.values())
    assert question.score(data, commas) == (1.0, {})
    wrong = {**right, "a1": "1e6"}
    assert question.score(data, wrong)[0] == pytest.approx((len(right) - 1) / len(right))
    for text in ("1,2,3", "1,2.3", "x,y", "nan,", "", ","):
        assert list(question.score(data, {**right, "a1": text})[1]) == ["a1"], text


def test_what_stands_at_the_end_of_the_tolerance_is_right(tmp_path: Path) -> None:
    out = built(tmp_path, FORMAT + NO_SOLUTIONS + TWO, 12)
    key, count = key_rows(out), 0
    for question in questions(out):
        for seed in range(len(json.loads((question.folder / "variants.json").read_text("utf-8")))):
            data = question.generated(seed)
            rows = key[data["params"]["code"], number_of(question)]
            for side in (-1, 1):
                ends = [Decimal(row["value"]) + side * Decimal(row["tolerance"]) for row in rows]
                beyond = [Decimal(row["value"]) + side * Decimal("1.0001") * Decimal(row["tolerance"]) for row in rows]
                answers = list(data["correct_answers"])
                assert question.score(data, dict(zip(answers, map(str, ends), strict=True))) == (1.0, {})
                assert question.score(data, dict(zip(answers, map(str, beyond), strict=True))) == (0.0, {})
                count += len(rows)
    assert count > 40


def test_an_angle_at_180_degrees_may_have_either_sign(tmp_path: Path) -> None:
    body = '[[problem]]\nfamily = "slider_crank"\nform = ["central"]\nask = ["v_B.angle", "v_B"]\n'
    (question,) = questions(built(tmp_path, FORMAT + NO_SOLUTIONS + body, 24))
    found = [question.generated(seed) for seed in range(24)]
    turned = [data for data in found if abs(data["correct_answers"]["a1"]) == 180]
    assert len(turned) > 2
    for data in turned:
        speed = repr(data["correct_answers"]["a2"])
        for text in ("180", "-180", "179.8", "-179,8", "180.2"):
            assert question.score(data, {"a1": text, "a2": speed}) == (1.0, {}), text
        for text in ("178", "-178", "0", "90"):
            assert question.score(data, {"a1": text, "a2": speed}) == (0.5, {}), text
        assert question.score(data, {"a1": "-180", "a2": "1e6"}) == (0.5, {})
        assert question.score(data, {"a1": "180", "a2": "1e6"}) == (0.5, {})


def test_text_from_outside_is_text(tmp_path: Path) -> None:
    hostile_family(tmp_path)
    students = [Student("1", f"Name {HOSTILE}", "Group 7"), Student("2", "Name 2", "Group 7")]
    body = '[[problem]]\nfamily = "strange"\n'
    out = built(tmp_path, FORMAT + body, title=f"T {HOSTILE}", students=students)
    (question,) = questions(out)
    assert re.fullmatch(r"strange-1-[0-9a-f]{8}", question.folder.name)
    for seed in (0, 1):
        page = question.page(question.generated(seed))
        assert page.find(".//script") is None
        output = "".join(page.itertext())
        assert HOSTILE in output
        assert len(list(page.iter("pl-number-input"))) == 6
    info = json.loads((question.folder / "info.json").read_text("utf-8"))
    assert (info["title"], info["topic"]) == (HOSTILE, f"T {HOSTILE}")
    for path in (out / "prairielearn").rglob("*"):
        assert path.is_dir() or b"Name" not in path.read_bytes()


def test_info_is_complete_and_the_folder_is_explained(tmp_path: Path) -> None:
    out = built(tmp_path, FORMAT + NO_SOLUTIONS + TWO, 12, title="Test 1")
    infos = [json.loads((question.folder / "info.json").read_text("utf-8")) for question in questions(out)]
    assert [info["title"] for info in infos] == [
        "Four-bar linkage",
        "Wheel rolling on a straight rail",
        "Spool pulled by a cord",
    ]
    for info in infos:
        assert info.keys() == {"uuid", "title", "topic", "tags", "type"}
        assert (info["topic"], info["type"]) == ("Test 1", "v3")
        assert uuid.UUID(info["uuid"]).version == 5
    assert len({info["uuid"] for info in infos}) == 3
    assert "questions/" in (out / "prairielearn" / "README.md").read_text("utf-8")


def test_the_same_bytes_for_any_number_of_processes(tmp_path: Path) -> None:
    body = FORMAT + '[[problem]]\nfamily = "spool"\n'
    one, two = (content(built(tmp_path / str(jobs), body, 10, jobs=jobs)) for jobs in (1, 2))
    assert one == two


def test_mistakes_in_options_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(
        f'title = "T"\nlanguage = "en"\n{FORMAT}[prairielearn]\nfigures = "pdf"\ncolour = 1\n{TWO}', "utf-8"
    )
    assert main(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    output = capsys.readouterr().err
    assert 'prairielearn.figures: expected one of "svg", "png" (got pdf)' in output
    assert "prairielearn.colour: unknown key" in output


def test_force_replaces_an_earlier_output(tmp_path: Path) -> None:
    out = built(tmp_path, FORMAT + NO_SOLUTIONS + TWO, 2)
    before = content(out)
    arguments = ["build", str(tmp_path / "exam.toml"), "--variants", "3", "--out", str(out)]
    assert main(arguments) == 2
    assert main([*arguments, "--force"]) == 0
    assert content(out) != before
    assert len(content(out / "prairielearn")) > 6
    (out / "mine.txt").write_text("mine")
    assert main([*arguments, "--force"]) == 2
