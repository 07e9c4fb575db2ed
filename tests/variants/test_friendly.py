"""Which answers are hand-friendly."""

from __future__ import annotations

from math import inf, nan, pi, sqrt

import numpy as np
import pytest

from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.load import load_family
from variantgen.mechanism.solving.solve import solve
from variantgen.variants.draw import draw
from variantgen.variants.friendly import are_hand_friendly, friendly_answers
from variantgen.variants.variant import solve_variants


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (0.0, True),
        (120.0, True),
        (-0.375, True),
        (1230.0, True),
        (1234.0, False),  # four digits
        (0.1234, False),
        (4 / 3, True),
        (400 / 3, False),
        (-36 / 7, False),
        (17 / 16, False),  # 1.0625: neither short nor a third
        (3 / 13, False),
        (40 * sqrt(3) / 3, True),
        (120 * sqrt(3), True),
        (20 * sqrt(7), True),
        (-sqrt(5) / 4, True),
        (0.35 * sqrt(3), False),  # 7 sqrt(3) / 20
        (135 * sqrt(3), False),
        (20 * sqrt(13), False),
        (sqrt(97), False),
        (sqrt(2) + 1, False),
        (pi, False),
        (inf, False),
        (nan, False),
    ],
)
def test_values(value: float, expected: bool) -> None:
    assert are_hand_friendly(np.array([value, value])).tolist() == [expected, expected]
    assert are_hand_friendly(np.array([-value])).tolist() == [expected]


def test_all_velocities_and_half_of_the_answers() -> None:
    # The ladder of the guide: AB = 2 m at 30 degrees, v_A = 5 m/s; v_B = omega = v_C = 5 / sqrt(3).
    family = load_family("ladder")
    form = family.forms["driven_at_wall"]
    asked = {name: parse_quantity(name, form.sample) for name in ("v_B", "omega_AB", "a_B", "epsilon_AB")}
    exact = {"AB": 2.0, "way": -1.0, "v_A": 5.0, "a_A": 0.0}
    angles = np.radians([30.0, 40.0])
    values = form.values({**{name: np.full(2, value) for name, value in exact.items()}, "phi": angles})
    motion = solve(form.scene(values), 2, form.plan)
    every = friendly_answers(motion, list(asked.values()), "m").tolist()
    assert every == [True, False]
    assert friendly_answers(motion, [asked["v_B"]], "m").tolist() == [True, False]
    # omega^2 = 25/3 at 30 degrees: epsilon = omega^2 tan 30 = 25 sqrt(3) / 9, a denominator that nobody would write.
    assert friendly_answers(motion, [asked["epsilon_AB"]], "m").tolist() == [False, False]
    # Directions count in degrees: v_C is perpendicular to PC, at -60 and -50 degrees to the floor.
    angle = parse_quantity("v_C.angle", form.sample)
    assert friendly_answers(motion, [angle], "m").tolist() == [True, True]


def test_an_unfriendly_velocity_is_not_made_up_for_by_others() -> None:
    family = load_family("four_bar")
    variants = draw(family, ["v_A", "v_B"], [("f", i) for i in range(40)])
    crank = [variant for variant in variants if variant.form.name == "crank"]
    motion = solve_variants(crank, 1)
    form = crank[0].form
    first, second = parse_quantity("v_A", form.sample), parse_quantity("v_B", form.sample)
    alone = are_hand_friendly(first.value(motion) * 100)
    other = are_hand_friendly(second.value(motion) * 100)
    assert alone.any()
    assert not other.all()
    both = friendly_answers(motion, [first, second], "cm")
    assert (both == (alone & other)).all()
