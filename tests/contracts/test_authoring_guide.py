"""The authoring guide cannot rot: its example passes the check, its tables are those of the code."""

from __future__ import annotations

import json
import re
from collections import defaultdict
from pathlib import Path

import pytest

from tests.joint_scenes import SCENES
from variantgen.check.family import check_family
from variantgen.cli import main
from variantgen.families.quantities import quantity_names, split_name
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import parse_family
from variantgen.reference import refreshed
from variantgen.resources import catalog_dir
from variantgen.single import one_variant
from variantgen.tables import Table, read_toml
from variantgen.wording import statement as statement_module
from variantgen.wording.language import load_language

GUIDE = (catalog_dir() / "README.md").read_text("utf-8")
BLOCKS = dict(re.findall(r"^```\w+ ([\w.]+)\n(.*?)^```", GUIDE, re.DOTALL | re.MULTILINE))


def test_tables_are_those_of_the_code() -> None:
    assert refreshed(GUIDE) == GUIDE, "run python -m variantgen.reference"
    assert GUIDE.count("<!-- table:") == 7


def test_the_scene_of_the_example_is_solved(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "wheel_and_rod.toml"
    path.write_text(BLOCKS["scene"], "utf-8")
    assert main(["solve", str(path), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["outcome"] == "solved"
    # v_B = v_O cot(40 degrees), omega of the wheel = v_O / R.
    answers = {answer["quantity"]: answer["value"] for answer in document["answers"]}
    assert answers["v_B"] == pytest.approx(30 / 0.8390996, rel=1e-6)
    assert answers["omega_wheel"] == pytest.approx(-1.5)


def test_the_family_of_the_example_passes_its_check(tmp_path: Path) -> None:
    folder = tmp_path / "wheel_and_rod"
    folder.mkdir()
    for name in ("family.toml", "statement.en.j2", "statement.ru.j2", "cases.toml"):
        (folder / name).write_text(BLOCKS[name], "utf-8")
    report = check_family(str(folder), seeds=100)
    assert report.failures == []
    assert report.cases == ["hand-1"]
    assert report.forms[0].acceptance > 0.1
    assert report.forms[0].valid > 10_000


def keys_read(monkeypatch: pytest.MonkeyPatch) -> dict[str, set[str]]:
    """All keys that the readers ask for, by section, while they read the catalogue."""
    asked: dict[str, set[str]] = defaultdict(set)
    finish = Table.finish

    def watched(table: Table) -> None:
        section = re.sub(r"^forms\.\w+\.?", "", table.path).partition(".")[0].partition("[")[0] or "(top)"
        asked[section] |= table._seen
        finish(table)

    monkeypatch.setattr(Table, "finish", watched)
    for name in family_names():
        path = catalog_dir() / name / "family.toml"
        parse_family(read_toml(path), path)  # read anew, whatever has been read before
    return asked


def test_every_key_that_is_read_is_explained(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = keys_read(monkeypatch)
    rows = dict(re.findall(r"^\| (`\[+\w+\]+`|\(top\)) .*?\| (.*) \|$", GUIDE, re.MULTILINE))
    for section in ("parameters", "screens", "pose", "figure", "laws"):
        row = rows[f"`[{section}]`"]
        names = {key for key in asked[section] if section != "laws" or key == "time"}
        assert names
        missing = {key for key in names if f"`{key}`" not in row}
        assert not missing, (section, missing)


def test_every_quantity_and_every_name_of_a_statement_is_explained() -> None:
    kinds = {split_name(name).kind for scene in SCENES.values() for name in quantity_names(scene)}
    section = GUIDE[GUIDE.index("## Quantities") :]
    assert all(re.search(rf"\b{kind}_[A-Z]", section) for kind in kinds), kinds
    variant = one_variant("spool")
    context = statement_module._context(statement_module._case(variant, [], load_language("en")))
    names = set(context) - set(variant.family.names)
    text = GUIDE[GUIDE.index("In a statement:") : GUIDE.index("In cases.toml")]
    assert all(re.search(rf"`{name}\b", text) for name in names), names
