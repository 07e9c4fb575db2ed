"""An instant that is found by what happens at it: what its sheet says, and what cannot be stated."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.families.reading.load import load_family

SCENE = Path(__file__).parents[1] / "kind_scenes" / "crank_turned.toml"
_LAW = 'phi = "0.5*t^2 + t"'
_EVENT = 'instant = "phi = 120 deg"'


def _changed(folder: Path, *changes: tuple[str, str]) -> str:
    text = SCENE.read_text("utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return str(scene_file(folder, text))


def _shown(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert main(["show", *arguments]) == 0
    return re.sub(r"\s+", " ", capsys.readouterr().out)


@pytest.mark.parametrize(
    ("language", "event", "number"),
    [
        ("en", "at the first instant after the beginning at which φ = 120°;", "120° for the first time after the"),
        ("ru", "в первый после начала момент времени, когда φ = 120°;", "значение 120° при t = 1,278 с"),
    ],
)
def test_the_sheet_says_what_happens_and_not_when(
    language: str, event: str, number: str, capsys: pytest.CaptureFixture[str]
) -> None:
    out = _shown(capsys, str(SCENE), "--lang", language, "--explain")
    sheet, solution = re.split(r"Determine:|Найти:", out)
    assert event in sheet
    assert not re.search(r"\bt = ", sheet)
    assert number in solution


def test_a_corner_that_is_reached(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The crank stands across its rod: tan(phi) = 60 / 20, phi = t^2 / 2 + t = 71.565 degrees."""
    path = _changed(tmp_path, (_EVENT, 'instant = "angle_O.A.B = 90"'))
    assert "t = 0.8703 s" in _shown(capsys, path)  # sqrt(1 + 2 * 1.249046) - 1


@pytest.mark.parametrize(
    ("law", "interval", "instant"),
    [
        # Touched at 0.70003 s, crossed at 2 s.
        ("2 + (t - 0.70003)^2 * (2 - t)", "[0, 3]", 0.70003),
        # The largest value, reached between two of the instants that are looked at.
        ("2 - 3*(t - 1.00001)^2", "[0, 3]", 1.00001),
        # So early that it comes before the first of them: 0.01 / 3000 s.
        ("1.99 + 3000*t", "[0, 3]", 0.01 / 3000),
        # Its value at the beginning does not count.
        ("2 + t * (1.3 - t)", "[0, 3]", 1.3),
    ],
)
def test_a_law_that_touches_a_value_reaches_it(law: str, interval: str, instant: float, tmp_path: Path) -> None:
    changes = (_LAW, f'phi = "{law}"'), ("[0, 3]", interval), (_EVENT, 'instant = "phi = 2 rad"')
    form = load_family(_changed(tmp_path, *changes)).forms[""]
    assert float(form.parameters["t"].printed[0]) == pytest.approx(instant, rel=1e-9)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ([(_EVENT, 'instant = "phi"')], "expected a quantity or a law and its value"),
        ([(_EVENT, "instant = 3")], "expected a quantity or a law and its value"),
        ([(_EVENT, 'instant = "phy = 2 rad"')], "neither a law nor a quantity"),
        ([(_EVENT, 'instant = "phi = 2 m"')], "m measures length, angle is due"),
        ([(_EVENT, 'instant = "phi = 2 parsec"')], "unknown unit"),
        ([(_EVENT, 'instant = "phi = "')], "expected a quantity or a law and its value"),
        ([(_EVENT, 'instant = "phi = 2 parsec"')], "laws.instant"),
        ([(_EVENT, 'instant = "way_B = 2 cm"')], "has no value at an instant"),
        ([(_EVENT, 'instant = "omega_AB.sense = 1"')], "has no value at an instant"),
        ([(_EVENT, 'instant = "y_B = 0"')], "is so from the beginning on"),
        ([(_EVENT, 'instant = "v_B.angle = 180 deg"')], "is so from the beginning on"),
        # The rod is shorter than the crank: the mechanism comes apart on the way.
        ([(_EVENT, 'instant = "v_B = 0.1 m/s"'), ("= 60,", "= 10,")], "does not move all through the interval"),
        ([(_EVENT, 'instant = "phi = 900 deg"')], "does not come in the interval of time"),
        ([("interval = [0, 3]\n", "")], "an instant is found in an interval of time"),
        ([("[laws]", '[parameters]\nt = { unit = "s", values = [1] }\n[laws]')], "is found and cannot be given"),
        (
            [("[laws]", '[parameters]\nr = { unit = "cm", values = [20, 25] }\n[laws]'), ("= 20,", '= "r",')],
            "is found only where nothing varies",
        ),
        ([('"t", ', '"t in m", ')], "m measures no time"),
    ],
)  # fmt: skip
def test_what_cannot_be_found_is_refused(changes: list[tuple[str, str]], said: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=said):
        load_family(_changed(tmp_path, *changes))


def test_the_instant_follows_what_is_set(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Half the crank and half the rod have half the speed at the same angle; at the same speed it is later."""
    parameter = ("[laws]", '[parameters]\nr = { unit = "cm", values = [20] }\n[laws]')
    path = _changed(
        tmp_path, parameter, ("= 20,", '= "r",'), ("= 60,", '= "3*r",'), (_EVENT, 'instant = "v_B = 0.3 m/s"')
    )
    first, second = (_shown(capsys, path, "--set", f"r={r}") for r in (20, 10))
    assert first != second
    assert "v_B = 30 cm/s" in first
    assert "v_B = 30 cm/s" in second
    assert main(["show", path, "--set", "t=1"]) == 2
    assert "the instant is found and cannot be set" in capsys.readouterr().err


def test_a_time_that_is_given_is_no_quantity(tmp_path: Path) -> None:
    parameter = ("[laws]", '[parameters]\nt = { unit = "s", values = [1] }\n[laws]')
    with pytest.raises(InputError, match="is given, so it cannot be asked"):
        load_family(_changed(tmp_path, parameter, (f"{_EVENT}\n", "")))


def test_an_exam_has_the_instant_in_its_key(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "crank_turned.toml").write_text(SCENE.read_text("utf-8"), "utf-8")
    exam, out = tmp_path / "exam.toml", tmp_path / "exam"
    exam.write_text('title = "T"\nseed = 1\nlanguage = "en"\n[[problem]]\nfamily = "crank_turned.toml"\n', "utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path)
        assert (
            main(["build", "exam.toml", "--variants", "1", "--format", "html", "--out", str(out), "--jobs", "1"]) == 0
        )
        assert main(["verify", str(out)]) == 0
    capsys.readouterr()
    key = (out / "key.csv").read_text("utf-8")
    assert "instant_t" in key
    assert "1.27789" in key  # sqrt(1 + 4 pi / 3) - 1
