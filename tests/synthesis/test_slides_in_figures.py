"""Figures of composed mechanisms show along what a slider moves, and where the foot of a yoke is that lengths tell."""

from __future__ import annotations

from pathlib import Path

import pytest

from variantgen.cli.app import main
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Arc, Drawing
from variantgen.figure.drawing import Path as Line
from variantgen.mechanism.motion import Motion
from variantgen.variants.draw import draw
from variantgen.wording.language import load_language


def _figure(code: str, seed: int, folder: Path) -> tuple[Drawing, Motion]:
    assert main(["compose", "--structure", code, "--seed", str(seed), "--out", str(folder)]) == 0
    variant = draw(load_family(folder), None, [("slides", 1)])[0]
    motion = variant.motion()
    return statement_figure(variant, motion, 0, read_ask(variant.form), load_language("en")), motion


def _on_paper(drawing: Drawing, motion: Motion, point: str) -> complex:
    return complex(drawing.scale * motion.z[point][0] + drawing.origin)


@pytest.mark.parametrize("seed", [6, 10])
def test_the_line_of_motion_through_a_fixed_point_is_drawn(seed: int, tmp_path: Path) -> None:
    drawing, motion = _figure("RRP10", seed, tmp_path / "made")
    assert "through {{ O }}" in (tmp_path / "made" / "statement.en.j2").read_text("utf-8")
    ends = [_on_paper(drawing, motion, point) for point in "OB"]
    (line,) = (line for line in drawing.lines if isinstance(line, Line) and line.dash == "dashdot")
    assert line.points == pytest.approx(tuple(ends), abs=1e-6)


def test_the_foot_of_a_yoke_that_lengths_tell_has_a_dot(tmp_path: Path) -> None:
    drawing, motion = _figure("RPP10-RRR23", 1, tmp_path / "made")
    dots = [line for line in drawing.lines if isinstance(line, Arc) and line.fill == "ink"]
    (dot,) = dots
    assert dot.centre == pytest.approx(_on_paper(drawing, motion, "C"), abs=1e-6)
