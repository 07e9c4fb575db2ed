"""The self-check fails when it must."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

import variantgen.check.draws
import variantgen.check.family
from variantgen.check.family import check_family
from variantgen.errors import InputError
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.verification.verify import Recomputed, recompute
from variantgen.skeletons import new_exam, new_family
from variantgen.variants.counting import variety


@pytest.mark.parametrize("error", [1e-3, float("nan"), float("inf")])
def test_a_deviation_is_a_failure_also_when_it_is_no_number(error: float, monkeypatch: pytest.MonkeyPatch) -> None:
    def spoiled(motion: Motion) -> Recomputed:
        again = recompute(motion)
        errors = again.velocity_error.copy()
        errors[3] = error
        return replace(again, velocity_error=errors)

    monkeypatch.setattr(variantgen.check.draws, "recompute", spoiled)
    report = check_family("rolling_wheel", seeds=10)
    assert any("independent computation differ" in failure and "seed 3" in failure for failure in report.failures)
    assert not report.as_json()["ok"]


def test_a_wrong_worked_case_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    cases = variantgen.check.family.load_cases(variantgen.load_family("spool"))
    wrong = [replace(case, exact={**case.exact, "v_O": 51.0}) for case in cases]
    monkeypatch.setattr(variantgen.check.family, "load_cases", lambda family: wrong)
    report = check_family("spool", seeds=5)
    assert any("M34" in failure and "v_O" in failure for failure in report.failures)
    assert np.isfinite(report.forms[0].deviation)


def broken(folder: Path, file: str, old: str, new: str) -> list[str]:
    """Failures of a new family after one change."""
    path = new_family("own", folder)
    target = path / file
    content = target.read_text("utf-8")
    assert old in content
    target.write_text(content.replace(old, new), "utf-8")
    return check_family(str(path), seeds=30).failures


@pytest.mark.parametrize(
    ("file", "old", "new", "said"),
    [
        (
            "statement.ru.j2",
            "положении, заданном углом {{ phi }} между кривошипом и прямой {{ OB }},",
            "положении",
            "phi",
        ),
        ("statement.en.j2", "{{ omega_OA }}", "", "the text does not say what omega_OA is"),
        ("family.toml", 'angles = [{ name = "phi", at = "O", from = "B", to = "A" }]', "", "does not show phi"),
        ("family.toml", ', ru = "own"', "", "title: none in the language ru"),
        ("family.toml", "from = 10, to = 40, step = 2", "from = 36, to = 2400, step = 2", "of the draws are valid"),
        ("family.toml", "from = 10, to = 40, step = 2", "from = 500, to = 600, step = 2", "no valid variant found"),
        ("cases.toml", "v_B = 40", "v_B = 41", "case hand-1"),
    ],
)
def test_what_an_author_may_get_wrong_is_a_failure(file: str, old: str, new: str, said: str, tmp_path: Path) -> None:
    assert any(said in failure for failure in broken(tmp_path, file, old, new))


def test_an_answer_that_all_students_share_is_a_failure(tmp_path: Path) -> None:
    # The speed of the pin A depends on the crank alone, and that is now the same for everybody.
    path = new_family("own", tmp_path)
    text = (path / "family.toml").read_text("utf-8")
    text = text.replace("from = 10, to = 40, step = 2", "values = [20]").replace(
        "from = 1, to = 8, step = 0.5", "values = [3]"
    )
    (path / "family.toml").write_text(text.replace('ask = ["v_B",', 'ask = ["v_A", "v_B",'), "utf-8")
    assert any("v_A is the same for 100 %" in failure for failure in check_family(str(path), seeds=30).failures)


def test_a_silent_parameter_must_not_matter(tmp_path: Path) -> None:
    found = broken(tmp_path, "family.toml", 'phi = { unit = "deg",', 'phi = { silent = true, unit = "deg",')
    assert any("depends on a parameter that is not printed" in failure for failure in found)


@pytest.mark.parametrize("name", ["con", "lpt1", "com9"])
def test_a_new_family_or_exam_has_no_name_that_windows_keeps(name: str, tmp_path: Path) -> None:
    for begin in (new_family, new_exam):
        with pytest.raises(InputError, match="Windows keeps this name"):
            begin(name, tmp_path)
    assert not list(tmp_path.iterdir())


def test_a_new_family_passes_its_check(tmp_path: Path) -> None:
    report = check_family(str(new_family("own", tmp_path)), seeds=50)
    assert report.failures == report.remarks == []  # its words are those of the glossary, too
    assert report.cases == ["hand-1"]
    (form,) = report.forms
    assert form.blocks == [1, 1]
    assert form.variants == form.distinct == 50
    assert {item.quantity for item in form.spread} == {"v_B", "omega_AB", "a_B", "epsilon_AB"}
    assert all(item.low <= item.middle <= item.high for item in form.spread)


def test_small_grids_are_counted_exactly() -> None:
    # Only the required ratio of the radii can reject one of these.
    family = restrict(load_family("spool"), {"thread": "above", "a_B": 100, "v_B": 40}, {"r": [20, 24], "R": [40, 44]})
    form = family.forms[""]
    asked = [parse_quantity("v_O", form.sample)]
    found = variety(family, form, asked, 1, 1)
    by_hand = sum(0.35 * R < r < 0.75 * R for r in (20, 22, 24) for R in (40, 42, 44))
    assert (found.grid, found.valid, found.exact) == (9, by_hand, True)


def test_hand_friendly_variants_are_told() -> None:
    (straight, _) = check_family("scotch_yoke", seeds=5).forms
    # Two of the seven angles are left; velocities are simple where the product of two data has three digits at most.
    assert 0.1 * straight.grid * 2 / 7 < straight.nice < 0.6 * straight.grid * 2 / 7
    assert f"hand-friendly: about {straight.nice:.2g}, " in "\n".join(straight.as_text())
    (without,) = check_family("guided_plate", seeds=5).forms
    assert without.nice == 0
    assert "        hand-friendly: none" in without.as_text()


def test_a_family_that_promises_hand_friendly_variants_has_them(tmp_path: Path) -> None:
    path = new_family("own", tmp_path)
    table = '\n[nice]\nrequire = ["1 < 0"]\n'
    (path / "family.toml").write_text((path / "family.toml").read_text("utf-8") + table, "utf-8")
    failures = check_family(str(path), seeds=5).failures
    assert any("hand-friendly variants" in failure and "require 1 < 0" in failure for failure in failures)
