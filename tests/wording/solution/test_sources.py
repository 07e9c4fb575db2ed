"""Solutions of the worked examples of the two sources, read beside them: same law, same intermediate numbers.

K is Kirsanov, section 2.5; M the guide to kinematics. Numbers are those that the sources print, where these are right,
and the exact ones where an erratum is known (noted beside them); tolerances are half a unit of the last digit that the
source prints. Points bear the names that the families give them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from math import pi, sqrt

import pytest

from tests.calculator import last_unit
from tests.solved_cases import case_of, quantities, variant_of
from tests.wording.solution.test_recomputed import lines_of
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.solution_options import SolutionOptions
from variantgen.methods.steps.step import Sentence
from variantgen.wording.formula import Measured, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import explain


@dataclass(frozen=True)
class Reading:
    """One example: family, case, method, what is asked, laws in order (keys of sentences), the numbers it prints."""

    family: str
    case: str
    method: str
    ask: tuple[str, ...]
    laws: tuple[str, ...]
    numbers: dict[str, tuple[float, float]] = field(default_factory=dict)  # symbol: value, tolerance
    vectors: tuple[str, ...] = ()
    projections: tuple[str, ...] = ()


READINGS = [
    Reading(
        "four_bar",
        "K26",
        "three_rates",
        ("omega_AB", "omega_BC", "epsilon_AB", "epsilon_BC"),
        ("three_rates.equations_omega", "three_rates.equations_epsilon"),
        {"ω_AB z": (3, 5e-4), "ω_BC z": (-4, 5e-4), "α_AB z": (32, 5e-3), "α_BC z": (3, 5e-3)},
    ),
    # v_rel = 2/sqrt(5), v_C′/B = 1/sqrt(5), omega = 1/5, (a_C′/B)_n = (1/5)^2 sqrt(5), a_rel = 6 sqrt(5)/25; l = 1 m.
    Reading(
        "sleeve_on_crank",
        "K27",
        "relative_motion",
        ("v_rel_C", "omega_BD", "a_rel_C"),
        ("relative.compound", "relative.zhukovsky", "relative.coriolis_not_needed"),
        {
            "v_A": (200, 0.01),
            "v_B": (200, 0.01),
            "v_C": (100, 0.01),
            "CB": (100 * sqrt(5), 0.01),
            "v_rel C": (200 / sqrt(5), 0.01),
            "v_C′/B": (100 / sqrt(5), 0.01),
            "ω_BD": (0.2, 1e-4),
            "(a_C′/B)_n": (4 * sqrt(5), 0.01),
            "a_B": (0, 0.01),
            "a_rel C": (24 * sqrt(5), 0.01),
        },
        ("v⃗_C = v⃗_B + v⃗_C′/B + v⃗_rel C",),
    ),
    # The source rounds OD = 19.95 to 20; what follows from it (v_rel, omega_DB, a_rel, epsilon_DB) is exact here.
    Reading(
        "four_bar_with_sleeve",
        "K28",
        "velocity_pole",
        (
            "v_B",
            "omega_AB",
            "omega_BC",
            "v_rel_D",
            "omega_DB",
            "a_B",
            "epsilon_AB",
            "epsilon_BC",
            "a_rel_D",
            "epsilon_DB",
        ),
        ("pole.choose_v", "relative.compound", "pole.choose_a", "relative.zhukovsky"),
        {
            "v_A": (120, 0.5),
            "v_B": (109.7, 0.05),
            "v_B/A": (137.2, 0.05),
            "ω_AB": (1.236, 5e-4),
            "ω_BC": (2.552, 5e-4),
            "DO": (19.951603, 1e-4),
            "v_rel D": (58.557863, 1e-3),
            "v_D/B": (54.4, 0.15),
            "ω_DB": (0.54685059, 1e-5),
            "(a_A)_n": (360, 0.5),
            "(a_B)_n": (280, 0.5),
            "(a_B)_t": (257, 0.5),
            "a_B": (380, 0.5),
            "α_AB": (0.895, 5e-4),
            "α_BC": (5.975, 5e-4),
            "(a_D/B)_n": (29.7, 0.2),
            "a_rel D": (465.93779, 1e-2),
            "α_DB": (3.5662973, 1e-4),
        },
        (
            "v⃗_B = v⃗_A + v⃗_B/A",
            "v⃗_B + v⃗_D/B = v⃗_D′ + v⃗_rel D",
            "(a⃗_B)_n + (a⃗_B)_t = (a⃗_A)_n + (a⃗_B/A)_n + (a⃗_B/A)_t",
            "(a⃗_B)_n + (a⃗_B)_t + (a⃗_D/B)_n + (a⃗_D/B)_t = (a⃗_D′)_n + a⃗_Cor D + a⃗_rel D",
        ),
    ),
    # The source prints 19.33 and 19.85.
    Reading(
        "falling_rod",
        "M22",
        "velocity_pole",
        ("v_A", "v_B"),
        ("points.sum_v",),
        {
            "φ": (math.pi / 3, 1e-3),  # rad, before it is turned into the 60 degrees of the source
            "v_C": (19.6, 0.05),
            "v_A/C": (pi / 6, 1e-4),
            "v_A": (19.343516, 1e-3),
            "v_B": (19.866975, 1e-3),
        },
        ("v⃗_A = v⃗_C + v⃗_A/C", "v⃗_B = v⃗_C + v⃗_B/C"),
    ),
    Reading(
        "ladder",
        "M23",
        "projections",
        ("v_B",),
        ("projections.theorem",),
        {"v_B": (5 / sqrt(3), 1e-3)},
        projections=("v_A sin φ = v_B cos φ",),
    ),
    Reading(
        "rolling_wheel",
        "M24",
        "velocity_centre",
        ("omega_wheel", "v_A", "v_B", "v_D"),
        ("rolling.omega",),
        {"ω": (4, 1e-4), "v_B": (4, 1e-4), "v_A": (2 * sqrt(2), 1e-3), "v_D": (2 * sqrt(2), 1e-3)},
    ),
    Reading(
        "ladder",
        "M23",
        "velocity_centre",
        ("v_B", "omega_AB", "v_C"),
        ("perpendiculars.meet",),
        {
            "AP": (sqrt(3), 1e-3),
            "BP": (1, 1e-3),
            "ω_AB": (5 / sqrt(3), 1e-3),
            "v_B": (5 / sqrt(3), 1e-3),
            "CP": (1, 1e-3),
            "v_C": (5 / sqrt(3), 1e-3),
        },
    ),
    Reading(
        "four_bar",
        "M26",
        "velocity_centre",
        ("v_B", "omega_AB", "omega_BC"),
        ("perpendiculars.meet",),
        {"v_A": (40, 0.01), "AP": (40, 0.01), "ω_AB": (1, 1e-4), "v_B": (40, 0.01), "ω_BC": (1, 1e-4)},
    ),
    Reading(
        "planetary_pair",
        "M27",
        "velocity_centre",
        ("omega_gear1", "v_A", "v_B"),
        ("contact.omega",),
        {"v_A": (50, 0.01), "ω_1": (10, 1e-3), "v_B": (50 * sqrt(2), 0.01)},
    ),
    Reading(
        "slider_crank_with_second_rod",
        "M28",
        "velocity_centre",
        ("v_B", "omega_AB", "omega_BC", "v_C"),
        ("perpendiculars.infinite", "perpendiculars.meet"),
        {
            "v_A": (40, 0.01),
            "v_B": (40, 0.01),
            "BP_BC": (30, 0.01),
            "CP_BC": (10 * sqrt(3), 0.01),
            "ω_BC": (4 / 3, 1e-4),
            "v_C": (40 * sqrt(3) / 3, 0.01),
        },
    ),
    Reading(
        "movable_pulley",
        "M29",
        "velocity_centre",
        ("v_C", "omega_pulley"),
        (),
        {"v_D": (8, 1e-3), "v_G": (4, 1e-3), "ω": (20, 1e-3), "v_C": (6, 1e-3)},
    ),
    # The source prints a wrong sign of a_Bx on the way to the right result.
    Reading(
        "triangle_plate",
        "M30",
        "acceleration_pole",
        ("a_B",),
        ("points.sum_a",),
        {"(a_B/A)_n": (3, 1e-3), "(a_B/A)_t": (1, 1e-3), "a_B": (sqrt(2), 1e-3)},
        ("a⃗_B = a⃗_A + (a⃗_B/A)_n + (a⃗_B/A)_t",),
    ),
    Reading(
        "rolling_wheel",
        "M31",
        "acceleration_pole",
        ("omega_wheel", "epsilon_wheel", "a_A"),
        ("points.sum_wheel",),
        {
            "ω": (2, 1e-3),
            "α": (4, 1e-3),
            "(a_A/O)_n": (2, 1e-3),
            "(a_A/O)_t": (2, 1e-3),
            "a_A": (2 * sqrt(5), 1e-3),
        },
        ("a⃗_A = a⃗_O + (a⃗_A/O)_n + (a⃗_A/O)_t",),
    ),
    Reading(
        "ladder",
        "M32",
        "velocity_centre",
        ("omega_AB", "a_B", "epsilon_AB"),
        ("perpendiculars.meet", "pole.choose_a"),
        {
            "ω_AB": (2 * sqrt(3), 1e-3),
            "(a_B/A)_n": (120, 0.05),
            "a_B": (60, 0.05),
            "(a_B/A)_t": (80 * sqrt(3), 0.05),
            "α_AB": (8 * sqrt(3), 0.005),
        },
        ("a⃗_B = a⃗_A + (a⃗_B/A)_n + (a⃗_B/A)_t",),
    ),
    # The source calls D what is B; its statement prints a_A = 1, its solution uses sqrt(2).
    Reading(
        "plate_acceleration_centre",
        "M33",
        "acceleration_centre",
        ("mu_ABDE", "Q_ABDE.A", "a_D"),
        (),
        {"μ": (45, 1e-3), "AQ": (1, 1e-3), "a_D": (sqrt(2), 1e-3)},
    ),
    Reading(
        "spool",
        "M34",
        "acceleration_pole",
        ("omega_spool", "v_O", "epsilon_spool", "a_O", "a_A"),
        ("points.sum_wheel",),
        {
            "ω": (1, 1e-3),
            "v_O": (50, 0.01),
            "α": (2, 1e-3),
            "a_O": (100, 0.01),
            "(a_A/O)_n": (50, 0.01),
            "(a_A/O)_t": (100, 0.01),
            "a_A": (50 * sqrt(13), 0.01),
        },
        ("a⃗_A = a⃗_O + (a⃗_A/O)_n + (a⃗_A/O)_t",),
    ),
    # One projection of the source has a wrong sign: epsilon_BC, a_B and a_M (its C) are exact here.
    Reading(
        "four_bar",
        "M35",
        "velocity_centre",
        ("omega_AB", "omega_BC", "epsilon_AB", "epsilon_BC", "a_B", "a_M"),
        ("perpendiculars.", "pole.choose_a"),
        {
            "v_A": (20, 0.01),
            "ω_AB": (1, 1e-4),
            "v_B": (20, 0.01),
            "ω_BC": (1, 1e-4),
            "(a_A)_n": (40, 0.01),
            "(a_A)_t": (20 * sqrt(3), 0.01),
            "(a_B)_n": (20, 0.01),
            "(a_B/A)_n": (20, 0.01),
            "(a_B/A)_t": (0, 0.01),
            "(a_B)_t": (40 * sqrt(3), 0.01),
            "a_B": (20 * sqrt(13), 0.01),
            "α_BC": (2 * sqrt(3), 1e-3),
            "a_M": (10 * sqrt(39), 0.01),
        },
        ("(a⃗_B)_n + (a⃗_B)_t = (a⃗_A)_n + (a⃗_A)_t + (a⃗_B/A)_n + (a⃗_B/A)_t",),
    ),
    # (a_A)_n is printed as 16 (is 1.6), (a_B/A)_n as 0.46 (is 0.61).
    Reading(
        "two_loop_mechanism",
        "M36",
        "projections",
        ("v_B", "v_E", "omega_DE", "a_B", "epsilon_AB"),
        ("projections.theorem", "pole.choose_a"),
        {
            "v_A": (0.8, 1e-4),
            "v_B": (0.46, 5e-3),
            "v_E": (0.46, 5e-3),
            "ω_DE": (0.67, 5e-3),
            "ω_AB": (0.66, 5e-3),
            "(a_A)_t": (2.8, 1e-3),
            "(a_A)_n": (1.6, 1e-3),
            "(a_B/A)_n": (0.6095, 1e-3),
            "a_B": (0.72, 5e-3),
            "(a_B/A)_t": (3.58, 6e-3),
            "α_AB": (2.56, 5e-3),
        },
        ("a⃗_B = (a⃗_A)_n + (a⃗_A)_t + (a⃗_B/A)_n + (a⃗_B/A)_t",),
        ("v_A sin β = v_B cos ψ",),  # beta = 30 degrees, the source has the cosine of 60; psi = 30
    ),
]


@pytest.mark.parametrize("reading", READINGS, ids=lambda r: f"{r.case}-{r.method}")
def test_same_laws_and_same_numbers_as_the_source(reading: Reading) -> None:
    family, case = case_of(reading.family, reading.case)
    variant, asked = variant_of(family, case), quantities(case, reading.ask)
    text = explain(variant, case.motion(), 0, asked, load_language("en"), SolutionOptions((reading.method,)))
    lines = [[to_plain(formula) for _, formula in line.pieces] for line in lines_of(text)]
    printed: dict[str, float] = {}
    for pieces, line in zip(lines, lines_of(text), strict=True):
        # The check at the end repeats names; what counts is where a number is first found.
        if isinstance(line.pieces[-1][1], Measured):
            printed.setdefault(pieces[0], float(line.pieces[-1][1].number.text.replace("−", "-")))
    for symbol, (value, tolerance) in reading.numbers.items():
        assert symbol in printed, (symbol, sorted(printed))
        # Four significant digits are printed.
        half = 0.5 * last_unit(f"{abs(printed[symbol]):g}", fewest=4)
        assert printed[symbol] == pytest.approx(value, abs=max(tolerance, 1.001 * half)), symbol
    equations = {" = ".join(pieces).replace("\u00a0", " ") for pieces in lines}
    assert set(reading.vectors) <= equations
    assert set(reading.projections) <= equations


@pytest.mark.parametrize("reading", [r for r in READINGS if r.laws], ids=lambda r: f"{r.case}-{r.method}")
def test_laws_come_in_the_order_of_the_source(reading: Reading) -> None:
    family, case = case_of(reading.family, reading.case)
    task = task_of(variant_of(family, case), case.motion(), 0, quantities(case, reading.ask))
    found = solution(task, (reading.method,))
    keys = [item.key for step in found.steps for item in (step.heading, *step.items) if isinstance(item, Sentence)]
    places = []
    for law in reading.laws:
        later = [i for i, key in enumerate(keys) if key.startswith(law) and i >= (places[-1] if places else 0)]
        assert later, (law, keys)
        places.append(later[0])
