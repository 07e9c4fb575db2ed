"""The command, its folder, and the summary in docs/accuracy.md."""

from __future__ import annotations

import builtins
import csv
from pathlib import Path

import pytest
from msgspec.structs import replace

from variantgen.accuracy import summary
from variantgen.accuracy.cases import dead_points, length_ratios, scales
from variantgen.accuracy.measure import discovered
from variantgen.accuracy.report.docs_summary import summary as short
from variantgen.accuracy.report.findings import findings
from variantgen.accuracy.report.report_files import FILES, write
from variantgen.accuracy.run import QUICK, Measurement, run
from variantgen.cli import main
from variantgen.resources import catalog_dir

TINY = replace(QUICK, count=6, timed=1, rounds=1, turns=(1,), gaps=(1e-3,), checks=6, tolerances=(1e-3, 1e-5), most=600)


@pytest.fixture(scope="module")
def measured() -> Measurement:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("variantgen.accuracy.run.case_modules", lambda: [scales, dead_points, length_ratios])
        return run(TINY)


def test_folder_is_whole(measured: Measurement, tmp_path: Path) -> None:
    write(measured, tmp_path)
    names = {path.name for path in tmp_path.iterdir()}
    assert {
        "report.md",
        "summary.md",
        "instants.csv",
        "motion.csv",
        "work_precision.pdf",
        "work_precision.png",
    } <= names
    assert {name for name in names if not name.endswith((".pdf", ".png"))} <= FILES
    with (tmp_path / "instants.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["way"] for row in rows} == set(discovered())
    assert {row["class"] for row in rows} == {module.TITLE for module in (scales, dead_points, length_ratios)}
    text = (tmp_path / "report.md").read_text("utf-8")
    for case in measured.classes:
        assert f"### {case.title}" in text
    assert all(str(value) in text for value in measured.machine.values())


def test_findings_are_sentences_with_numbers(measured: Measurement) -> None:
    found = findings(measured)
    assert len(found) > 5
    assert all(sentence.endswith(".") and "nan" not in sentence for sentence in found)
    assert any("No exception, no NaN and no wrong branch" in sentence for sentence in found)


def test_summary_replaces_the_marked_part_only(measured: Measurement) -> None:
    text = "before\n<!-- accuracy -->\nold\n<!-- end of accuracy -->\nafter\n"
    new = summary.refreshed(text, short(measured))
    assert new.startswith("before\n<!-- accuracy -->\n| class of cases")
    assert new.endswith("<!-- end of accuracy -->\nafter\n")
    assert "old" not in new
    assert summary.refreshed(new, short(measured)) == new


def test_docs_have_the_summary_and_its_diagrams() -> None:
    checkout = catalog_dir().parent
    text = (checkout / "docs" / "accuracy.md").read_text("utf-8")
    marked = text.split("<!-- accuracy -->")[1].split("<!-- end of accuracy -->")[0]
    assert marked.count("\n| ") > 10
    for name in summary.PICTURES:
        assert f'src="pictures/{name}"' in text
        assert (checkout / "docs" / "pictures" / name).is_file()


def test_command_refuses_a_foreign_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "precious.txt").write_text("x", "utf-8")
    assert main(["accuracy", "--quick", "--out", str(tmp_path), "--force"]) == 2
    assert "precious.txt" in capsys.readouterr().err
    assert main(["accuracy", "--quick", "--out", str(tmp_path / "no" / "where")]) == 2


def test_missing_packages_are_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    real = builtins.__import__

    def without(name: str, *arguments: object, **keywords: object) -> object:
        if name == "mpmath":
            raise ImportError
        return real(name, *arguments, **keywords)

    monkeypatch.setattr(builtins, "__import__", without)
    assert main(["accuracy", "--quick", "--out", str(tmp_path / "out")]) == 3
    assert 'pip install ".[accuracy]"' in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
