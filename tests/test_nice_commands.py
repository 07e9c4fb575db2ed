"""``--nice`` and closed forms on the command line."""

from __future__ import annotations

import json
from math import sqrt
from pathlib import Path

import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main

# Example 23 of the guide.
LADDER = ["ladder", "--form", "driven_at_wall", "--ask", "v_B", "--ask", "omega_AB"]
DATA = ["AB=2", "phi=30", "v_A=5", "a_A=0", "way=towards_the_corner"]
SET = [part for text in DATA for part in ("--set", text)]


def test_solve_prints_roots_and_its_document_decimals(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", *LADDER, *SET]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "v_B = 5√3/3 ≈ 2.88675 m/s" in lines
    assert "omega_AB = 5√3/3 ≈ 2.88675 rad/s" in lines
    assert main(["solve", *LADDER, *SET, "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)["answers"][0]
    assert list(answer) == ["quantity", "value", "unit", "tolerance"]
    assert answer["value"] == pytest.approx(5 / sqrt(3), rel=1e-7)


def test_solve_prints_plain_minus_signs(capsys: pytest.CaptureFixture[str]) -> None:
    # omega_AB = 5 / sqrt(3), clockwise where the end A goes up the wall.
    up = [part.replace("towards_the_corner", "away_from_the_corner") for part in SET]
    assert main(["solve", *LADDER, *up]) == 0
    assert "omega_AB = -5√3/3 ≈ -2.88675 rad/s" in capsys.readouterr().out.splitlines()


@pytest.mark.parametrize(("language", "said"), [("en", "v_B = 5√3/3 ≈ 2.887 m/s"), ("ru", "v_B = 5√3/3 ≈ 2,887 м/с")])
def test_show_prints_them_in_its_language(language: str, said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", *LADDER, *SET, "--lang", language]) == 0
    assert said in " ".join(capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ").split())


def test_a_page_shows_them(tmp_path: Path) -> None:
    page = tmp_path / "page.pdf"
    assert main(["show", *LADDER, *SET, "--out", str(page)]) == 0
    (text,) = page_texts(page)
    assert text.count("√") == 2
    assert text.count("≈ 2.887") == 2


def test_nice_draws_hand_friendly_variants(capsys: pytest.CaptureFixture[str]) -> None:
    angles = set()
    for seed in range(8):
        assert main(["solve", "ladder", "--form", "driven_at_wall", "--nice", "--seed", str(seed), "--json"]) == 0
        angles.add(json.loads(capsys.readouterr().out)["parameters"]["phi"]["value"])
    assert angles <= {30, 45, 60}
    assert len(angles) > 1
    assert main(["solve", "three_rod_plate", "--nice"]) == 2
    assert "three_rod_plate" in capsys.readouterr().err


def test_nothing_drawn_is_nothing_to_choose(capsys: pytest.CaptureFixture[str]) -> None:
    scene = Path(__file__).parent / "textbook_kinds" / "bar_on_disc.toml"
    for problem in ([str(scene)], [*LADDER, *SET]):
        assert main(["show", *problem, "--nice"]) == 2
        assert "nice: no value is drawn" in capsys.readouterr().err


def test_gallery_of_hand_friendly_variants(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "gallery"
    wanted = ["wheel_with_rod", "three_rod_plate", "ladder"]
    assert main(["gallery", *wanted, "--nice", "--each", "1", "--out", str(out)]) == 0
    names = sorted(path.name for path in (out / "figures").iterdir())
    assert names == [
        "ladder-driven_at_floor-1.svg", "ladder-driven_at_wall-1.svg", "ladder-oblique-1.svg",
        "wheel_with_rod-central-1.svg", "wheel_with_rod-offset-1.svg",
    ]  # fmt: skip
    assert "show ladder --form oblique --nice --seed 1" in (out / "index.html").read_text("utf-8")
    capsys.readouterr()
    assert main(["gallery", "three_rod_plate", "--nice", "--out", str(tmp_path / "none")]) == 2
    assert "no hand-friendly variants" in capsys.readouterr().err
    assert not (tmp_path / "none").exists()
