"""Which links can revolve: Grashof's condition worked by hand, and cranks of sliders."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

from variantgen.families.reading.load import load_family
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.turn.revolution import can_revolve
from variantgen.single import one_variant
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant, solve_variants

RATES = {"omega_OA": 2, "epsilon_OA": 2, "sense": "counter_clockwise"}


def four_bar(oa: int, ab: int, bc: int, oc: int, phi: int = 90) -> Motion:
    lengths = {"OA": oa, "AB": ab, "BC": bc, "OC": oc, "phi": phi, "side": "left"}
    return solve_variants([one_variant("four_bar", {**RATES, **lengths}, form="crank")], 2)


@pytest.mark.parametrize(
    ("lengths", "crank", "rocker"),
    [
        # Shortest OA beside the frame, 20 + 40 < 40 + 32: crank and rocker.
        ((20, 40, 32, 40), True, False),
        # Shortest BC, 20 + 60 < 50 + 40: BC goes round, OA swings.
        ((50, 40, 20, 60), False, True),
        # The frame is shortest, 20 + 60 < 40 + 50: both go round.
        ((40, 60, 50, 20), True, True),
        # The coupler is shortest, 20 + 60 < 50 + 55: both swing.
        ((50, 20, 60, 55), False, False),
        # Shortest and longest together are more than the others, 26 + 70 > 50 + 40: all swing.
        ((50, 40, 26, 70), False, False),
    ],
)
def test_grashof(lengths: tuple[int, int, int, int], crank: bool, rocker: bool) -> None:
    motion = four_bar(*lengths, phi=60)
    assert motion.solved.all()
    assert (can_revolve(motion, "OA"), can_revolve(motion, "BC")) == (crank, rocker)


@pytest.mark.parametrize(("offset", "revolves"), [(14, True), (16, False)])
def test_the_crank_of_a_slider_needs_a_rod_longer_than_crank_and_offset(offset: int, revolves: bool) -> None:
    data = {**RATES, "OA": 20, "AB": 35, "e": offset, "phi": 30, "above": "above"}
    motion = solve_variants([one_variant("slider_crank", data, form="offset")], 2)
    assert can_revolve(motion, "OA") is revolves


def test_with_several_drivers_the_others_are_held() -> None:
    # B is held at (100, 20), 102 cm from O, so 72 to 132 cm from A (OA = 30): rods of 80 and 60 cm close the gap
    # everywhere (from 20 to 140 cm), two of 60 cm do not.
    data = {"OA": 30, "BC": 20, "OC": 100, "phi": 90, "psi": 90, "omega_BC": 2, "epsilon_BC": 2, **RATES}
    data |= {"other_sense": "clockwise"}
    for rods, revolves in (((80, 60), True), ((60, 60), False)):
        fixed = {**data, "AM": rods[0], "BM": rods[1]}
        motion = solve_variants([one_variant("two_cranks_and_rod", fixed)], 2)
        assert can_revolve(motion, "OA") is revolves


def test_what_cannot_be_turned_is_refused() -> None:
    motion = four_bar(20, 40, 32, 40)
    both = replace(motion, outcome=np.zeros(2, dtype=np.int8))
    with pytest.raises(ValueError, match="one solved variant"):
        can_revolve(both, "OA")
    wedge = solve_variants(draw_one("wedge_and_rod"), 2)
    with pytest.raises(ValueError, match="cannot drive"):
        can_revolve(wedge, next(iter(wedge.scene.bodies)))


def draw_one(name: str) -> list[Variant]:
    return draw(load_family(name), None, [("one", 0)])
