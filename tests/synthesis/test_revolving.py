"""Cranks and rockers of composed statements: hand formulas, and what turns where a mechanism is moved."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from variantgen.check.family import check_family
from variantgen.exam.composed import write
from variantgen.families.reading.load import load_family
from variantgen.mechanism.turn.revolution import can_revolve
from variantgen.synthesis.revolving import four_bar_turns, slider_crank_turns
from variantgen.synthesis.structures import parse_code
from variantgen.variants.draw import draw


@pytest.mark.parametrize(
    ("lengths", "turns"),
    [
        ((2, 5, 4, 6), True),  # crank and rocker: 2 + 6 < 4 + 5, the crank is the shortest
        ((4, 5, 2, 6), False),  # the same seen from the rocker
        ((5, 4, 6, 2), True),  # double crank: the frame is the shortest
        ((5, 2, 4, 6), False),  # double rocker: the rod is the shortest
        ((3, 4, 4, 6), False),  # 3 + 6 > 4 + 4: nothing turns
        ((2, 4, 5, 7), False),  # 2 + 7 = 4 + 5: stretched into one line
    ],
)
def test_four_bars_by_grashof(lengths: tuple[float, ...], turns: bool) -> None:
    assert bool(four_bar_turns(*(np.array([value], dtype=float) for value in lengths))[0]) is turns


@pytest.mark.parametrize(("offset", "turns"), [(0, True), (2, True), (-2, True), (3, False), (-4, False)])
def test_a_slider_crank_with_an_offset(offset: float, turns: bool) -> None:
    """Crank 3, rod 6: the farthest that the pin A comes from the guide is 3 and the offset together."""
    found = slider_crank_turns(np.array([3.0]), np.array([6.0]), np.array([float(offset)]))
    assert bool(found[0]) is turns


@pytest.mark.parametrize(
    ("code", "seed", "said"),
    [
        ("RRR01", "2", ""),
        ("RRR01-RRR23", "2", "rocker {{ BC }}"),
        ("RPP10", "1", "crank {{ OA }}"),
        ("RPR01", "1", "crank {{ OA }}"),
    ],
)
def test_links_are_called_what_they_are(code: str, seed: str, said: str, tmp_path: Path) -> None:
    """The words are held against motions by continuation, which know no formula; ``check`` reads both languages."""
    write(parse_code(code), seed, tmp_path / "made", with_case=False)
    text = (tmp_path / "made" / "statement.en.j2").read_text("utf-8")
    assert said in text
    family = load_family(tmp_path / "made")
    motions = [variant.motion() for variant in draw(family, None, [(str(k), "turned", 0) for k in range(6)])]
    for noun, turns in (("crank", True), ("rocker", False)):
        for body in motions[0].scene.bodies:
            if f"{noun} {{{{ {body} }}}}" in text:
                assert [can_revolve(motion, body) for motion in motions] == [turns] * 6
    assert not check_family(str(tmp_path / "made"), seeds=8).failures
