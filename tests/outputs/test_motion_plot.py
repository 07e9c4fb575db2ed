"""Plots of the motion: what they show, in which words and numbers, the same bytes each time."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from decimal import Decimal
from io import BytesIO
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest
from PIL import Image

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.outputs.motion.caption import caption_lines
from variantgen.outputs.motion.film import film_indices
from variantgen.outputs.motion.plotted_curves import panels
from variantgen.outputs.motion.ranges import round_ticks, tick_texts, visible_range
from variantgen.outputs.motion.subject import Subject
from variantgen.outputs.single.motion_plot import motion_bytes
from variantgen.single import answers, asked_quantities, one_variant
from variantgen.variants.driver_sweep import driver_sweep
from variantgen.wording.formula import to_plain
from variantgen.wording.language import load_language
from variantgen.wording.mathtext import to_mathtext

STARTS = {"pdf": b"%PDF", "png": b"\x89PNG", "svg": b"<?xml", "gif": b"GIF89a"}


def subject(family: str, language: str = "en", form: str = "", ask: Sequence[str] = (), **fixed: str) -> Subject:
    variant = one_variant(family, fixed, "plot", form, ask)
    asked = asked_quantities(variant, ask)
    return Subject(variant, driver_sweep(variant, asked), asked, load_language(language))


def caption(of: Subject) -> str:
    shown, constants = panels(of.variant, of.driver_sweep, of.asked, of.language)
    clipped = any(of.range_of(panel)[2] for panel in shown)
    return " ".join(caption_lines(of, constants, clipped, 6.0))


@pytest.mark.parametrize("form", STARTS)
def test_same_bytes_twice(form: str) -> None:
    variant = one_variant("slider_crank", seed="plot")
    asked = asked_quantities(variant)
    before = dict(mpl.rcParams)
    made = [motion_bytes(variant, asked, load_language("ru"), form, "remark") for _ in range(2)]
    assert made[0].startswith(STARTS[form])
    assert made[0] == made[1]
    assert dict(mpl.rcParams) == before
    for date in (b"CreationDate", b"<dc:date>"):
        assert date not in made[0]


def test_a_pdf_has_its_words(tmp_path: Path) -> None:
    path = tmp_path / "motion.pdf"
    variant = one_variant("hydraulic_hoist", seed="plot", form="boom")
    path.write_bytes(motion_bytes(variant, asked_quantities(variant), load_language("ru"), "pdf", "seed plot"))
    text = " ".join(page_texts(path))
    assert "Стрела, поворачиваемая гидроцилиндром" in text
    assert "мёртвым положением" in text
    assert "seed plot" in text


def test_panels_are_grouped_by_units() -> None:
    of = subject("four_bar", form="crank")
    shown, constants = panels(of.variant, of.driver_sweep, of.asked, of.language)
    assert [panel.unit.name for panel in shown] == ["cm", "cm/s", "rad/s", "cm/s^2", "rad/s^2"]
    assert shown[0].letters == ("x", "y")
    assert [[to_plain(curve.formula) for curve in panel.curves] for panel in shown] == [
        ["x_B", "y_B"],
        ["v_B"],
        ["ω_AB", "ω_BC"],
        ["a_B"],
        ["α_AB", "α_BC"],
    ]
    assert constants == []


def test_curves_pass_through_the_answers() -> None:
    of = subject("quick_return_shaper")
    shown, _ = panels(of.variant, of.driver_sweep, of.asked, of.language)
    curves = {to_plain(curve.formula): curve for panel in shown for curve in panel.curves}
    for answer in answers(of.variant):
        curve = curves[to_plain(of.language.quantity(answer.quantity, of.variant.form.symbols))]
        assert curve.now == answer.value
        assert curve.values[of.driver_sweep.sweep.instant] == pytest.approx(answer.value, rel=1e-7)


def test_what_does_not_change_is_said_and_not_plotted() -> None:
    of = subject("planetary_train", form="two_suns")
    shown, constants = panels(of.variant, of.driver_sweep, of.asked, of.language)
    assert [panel.unit.name for panel in shown] == ["cm"]
    assert len(constants) == len(of.asked)
    omega = next(answer for answer in answers(of.variant) if answer.quantity.name == "omega_gear2")
    assert (
        f"Constant: ${to_mathtext(of.language.quantity(omega.quantity, of.variant.form.symbols)).strip('$')}="
        in caption(of)
    )


def test_an_angle_does_not_jump() -> None:
    of = subject("four_bar", form="crank", ask=["v_A.angle", "a_A"], OA="20", OC="60", AB="50", BC="50", phi="75")
    shown, _ = panels(of.variant, of.driver_sweep, of.asked, of.language)
    angle = next(panel for panel in shown if panel.unit.name == "deg").curves[0]
    assert np.max(np.abs(np.diff(angle.values))) < 2
    assert abs(angle.values[-1] - angle.values[0]) == pytest.approx(360)


def test_dead_points_do_not_swallow_the_rest() -> None:
    of = subject("hydraulic_hoist", form="boom")
    shown, _ = panels(of.variant, of.driver_sweep, of.asked, of.language)
    rate = next(panel for panel in shown if panel.unit.name == "rad/s")
    low, high, clipped = of.range_of(rate)
    values = rate.curves[0].values
    assert clipped
    assert np.ptp(values) > 20 * (high - low)
    assert low < values[of.driver_sweep.sweep.instant] < high
    assert np.mean((values > low) & (values < high)) > 0.8
    assert "leave the frame" in caption(of)


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("en", ("instant of the problem", "both sides at a dead position")),
        ("ru", ("момент", "обеих сторон", "мёртвым")),
    ],
)
def test_the_caption_says_what_is_seen(language: str, words: tuple[str, ...]) -> None:
    said = caption(subject("hydraulic_hoist", language, "boom"))
    for word in words:
        assert word in said
    assert "{" not in said.replace("_{", "").replace(r"\mathrm{", "").replace("^{", "").replace("{,}", "")


def test_ranges() -> None:
    wave = np.sin(np.linspace(0, 2 * np.pi, 361))
    low, high, clipped = visible_range([wave], 30)
    assert (low, high) == pytest.approx((-1.14, 1.14))
    assert not clipped
    spike = wave.copy()
    spike[200] = 1e6
    assert visible_range([spike], 30)[1:] == (pytest.approx(2.0, abs=0.5), True)
    # The instant is always in sight.
    assert visible_range([spike], 200)[1] > 1e6
    missing = np.where(np.arange(361) < 100, np.nan, wave)
    assert visible_range([missing], 200)[2] is False


@pytest.mark.parametrize(
    ("low", "high", "angles", "ticks"),
    [
        (0, 360, True, ["0", "60", "120", "180", "240", "300", "360"]),
        (-139.7, 139.7, True, ["−135", "−90", "−45", "0", "45", "90", "135"]),
        (-0.3, 1.1, False, ["−0,2", "0,0", "0,2", "0,4", "0,6", "0,8", "1,0"]),
        (0.0, 12345.0, False, ["0", "2000", "4000", "6000", "8000", "10000", "12000"]),
        (0.2, 0.2004, False, ["0,2000", "0,2001", "0,2002", "0,2003", "0,2004"]),
    ],
)
def test_ticks(low: float, high: float, angles: bool, ticks: list[str]) -> None:
    found = round_ticks(low, high, 8 if angles else 7, angles)
    assert tick_texts(found, load_language("ru")) == ticks
    assert all(isinstance(tick, Decimal) for tick in found)


def test_a_film_of_a_turn_and_one_to_and_fro() -> None:
    turn = subject("slider_crank", form="central")
    indices = film_indices(turn)
    assert indices[0] == turn.driver_sweep.sweep.instant
    assert len(set(indices)) == len(indices) == 60
    swing = subject("hydraulic_hoist", form="boom")
    indices = film_indices(swing)
    assert indices[0] == swing.driver_sweep.sweep.instant
    assert 55 <= len(indices) <= 65
    assert max(abs(a - b) for a, b in zip(indices, [*indices[1:], indices[0]], strict=True)) < 30
    made = motion_bytes(swing.variant, swing.asked, swing.language, "gif")
    film = Image.open(BytesIO(made))
    assert 50 <= film.n_frames <= 65
    assert film.info["loop"] == 0
    assert len(made) < 1_000_000


@pytest.mark.parametrize("ending", STARTS)
def test_the_command_writes_a_plot(ending: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / f"motion.{ending}"
    arguments = ["--set", "omega_OA=2", "--form", "central", "--ask", "v_B", "--lang", "ru", "--seed", "5"]
    assert main(["show", "slider_crank", *arguments, "--motion", str(out)]) == 0
    assert out.read_bytes().startswith(STARTS[ending])
    assert "written" in capsys.readouterr().err


def test_the_command_refuses_what_it_cannot_write(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", "four_bar", "--motion", str(tmp_path / "motion.docx")]) == 2
    assert "unknown format" in capsys.readouterr().err
    assert main(["show", "four_bar", "--motion", str(tmp_path / "missing" / "motion.pdf")]) == 2
    assert "cannot be written" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_without_matplotlib(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert main(["show", "four_bar", "--motion", str(tmp_path / "motion.pdf")]) == 3
    assert 'pip install ".[plots]"' in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
    assert main(["show", "four_bar"]) == 0
