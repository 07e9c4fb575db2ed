"""Batches of variants: valid as those of sheets, with the numbers of a closed form that is written here."""

from __future__ import annotations

import csv
import io
import time
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

import variantgen
from variantgen.arrays.batch import Batch
from variantgen.errors import InputError
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.mechanism.verification.verify import recompute
from variantgen.single import one_variant
from variantgen.variants import attempts
from variantgen.variants.attempts import FormSampler
from variantgen.variants.batch import RejectionCounts
from variantgen.variants.examined import examined
from variantgen.variants.seeding import Stream


def test_a_slider_crank_has_the_numbers_of_its_closed_form() -> None:
    found = variantgen.batch("slider_crank", 200, seed="closed form", form="offset", ask=["v_B", "a_B", "omega_AB"])
    p = found.parameters
    a, b, phi = p["OA"] / 100, p["AB"] / 100, np.radians(p["phi"])
    e, w, alpha = p["above"] * p["e"] / 100, p["sense"] * p["omega_OA"], p["epsilon_OA"]
    sine = (e - a * np.sin(phi)) / b
    cosine = np.sqrt(1 - sine**2)
    rod = -a * w * np.cos(phi) / (b * cosine)
    turning = (a * (w**2 * np.sin(phi) - alpha * np.cos(phi)) + b * rod**2 * sine) / (b * cosine)
    v = -a * w * np.sin(phi) - b * rod * sine
    acceleration = -a * (alpha * np.sin(phi) + w**2 * np.cos(phi)) - b * (turning * sine + rod**2 * cosine)
    assert found.answers["v_B"] == pytest.approx(100 * np.abs(v))
    assert found.answers["a_B"] == pytest.approx(100 * np.abs(acceleration))
    assert found.answers["omega_AB"] == pytest.approx(found.sense * rod)
    place = a * np.cos(phi) + b * cosine + 1j * e
    assert np.abs(found.positions["B"] - found.positions["O"]) == pytest.approx(np.abs(place))
    assert np.abs(found.velocities["B"]) == pytest.approx(np.abs(v))
    assert np.abs(found.accelerations["B"]) == pytest.approx(np.abs(acceleration))
    assert {found.units[name] for name in ("OA", "phi", "v_B", "a_B", "omega_AB")} == {
        "cm", "deg", "cm/s", "cm/s^2", "rad/s"
    }  # fmt: skip


def test_every_variant_has_the_answers_that_it_has_alone() -> None:
    found = variantgen.batch("sleeve_on_crank", 40, seed=5, ask=["v_rel_C", "a_cor_C"])
    for number in (0, 7, -1):
        alone = variantgen.answers(found[number], ["v_rel_C", "a_cor_C"])
        assert [answer.value for answer in alone] == pytest.approx(
            [found.answers["v_rel_C"][number], found.answers["a_cor_C"][number]], rel=1e-7
        )
    assert [variant.printed for variant in found][7] == found[7].printed
    with pytest.raises(IndexError):
        found[40]


@pytest.mark.parametrize("family", ["four_bar", "slotted_rocker", "planetary_train"])
def test_every_variant_is_confirmed_by_the_independent_computation(family: str) -> None:
    motion = variantgen.batch(family, 300, seed=1).motion
    again = recompute(motion)
    assert motion.solved.all()
    assert again.velocity_error.max() < 1e-7
    assert again.acceleration_error.max() < 1e-7


def test_links_of_a_batch_are_those_of_a_crank_that_revolves() -> None:
    """What the family requires of every variant; in metres a sum may be equal but for the last bit."""
    p = variantgen.batch("four_bar", 2000, seed=2).parameters
    assert np.all(p["OA"] + p["OC"] <= p["AB"] + p["BC"])
    assert np.all(np.abs(p["AB"] - p["BC"]) <= np.abs(p["OC"] - p["OA"]))


def test_first_variants_of_a_larger_batch_are_those_of_a_smaller_one(monkeypatch: pytest.MonkeyPatch) -> None:
    few, many = (variantgen.batch("four_bar", n, seed=3) for n in (7, 900))
    monkeypatch.setattr(attempts, "_MOST_AT_ONCE", 100)
    parts = variantgen.batch("four_bar", 60, seed=3)
    for name, index in many.index.items():
        assert np.array_equal(few.index[name], index[:7])
        assert np.array_equal(parts.index[name], index[:60])
    assert np.array_equal(few.attempt, many.attempt[:7])
    other = variantgen.batch("four_bar", 7, seed=4)
    assert any(not np.array_equal(few.index[name], index) for name, index in other.index.items())


def test_a_batch_for_sheets_is_the_part_of_a_batch_that_a_calculation_by_hand_keeps() -> None:
    every, sheets = (
        variantgen.batch("four_bar", 300, seed=6),
        variantgen.batch("four_bar", 100, seed=6, for_sheets=True),
    )
    kept = set(sheets.attempt.tolist())
    reached = set(every.attempt[every.attempt <= max(kept)].tolist())
    assert kept < reached
    assert len(kept) > 0.6 * len(reached)
    # What hand calculation needs is the tolerance of the key: at most the family's ceiling of 3 %.
    for variant in sheets:
        assert all(answer.relative_tolerance <= 0.03 for answer in variantgen.answers(variant))


@pytest.mark.parametrize("family", ["four_bar", "sleeve_on_crank"])
def test_a_batch_for_sheets_is_what_a_student_of_its_stream_would_be_given(family: str) -> None:
    """One after the other by the way of the sheets: the first valid attempt, the next one after it, ..."""
    found = variantgen.batch(family, 12, seed=7, for_sheets=True)
    form = found.form
    asked = examined(form, found.asked)
    used, drawn = 0, []
    for _ in range(12):
        sampler = FormSampler(found.family, form, asked, RejectionCounts(), "", AnswerTolerances())
        variant = sampler.run([Stream("batch", 7, family, form.name)], [used])[0]
        used = variant.attempt
        drawn.append((variant.attempt, variant.printed, variant.sense, variant.turns))
    assert [(v.attempt, v.printed, v.sense, v.turns) for v in found] == drawn


def test_every_point_of_the_grid_is_drawn_equally_often() -> None:
    # 9 pairs (r, R), all valid.
    found = variantgen.batch(
        "spool", 4500, seed="even", set={"thread": "above", "a_B": 100, "v_B": 40}, range={"r": [18, 22], "R": [40, 44]}
    )
    pairs = Counter(zip(found.parameters["r"].tolist(), found.parameters["R"].tolist(), strict=True))
    assert len(pairs) == 9
    # Chi-square with 8 degrees of freedom: 26.1 is exceeded once in a thousand.
    assert sum((n - 500) ** 2 / 500 for n in pairs.values()) < 26.1


def test_values_are_fixed_and_ranges_narrowed() -> None:
    found = variantgen.batch(
        "four_bar", 50, form="rocker", set={"side": "left"}, range={"phi": (60, 90)}, ask="velocities"
    )
    assert found.form.name == "rocker"
    assert set(found.parameters["phi"]) <= {60, 65, 70, 75, 80, 85, 90}
    assert set(found.table()["side"]) == {"left"}
    assert found.answers.keys() and all(name.startswith(("v", "omega")) for name in found.answers)
    fixed = variantgen.batch("four_bar", 20, set={"OA": "0.3 m"})
    assert set(fixed.parameters["OA"]) == {30}


def test_without_a_form_the_first_that_fits_is_taken() -> None:
    family = variantgen.load_family("four_bar")
    assert variantgen.batch(family, 3).form.name == next(iter(family.forms)) == "crank"
    assert variantgen.batch(family, 3, set={"omega_BC": 2}).form.name == "rocker"
    assert variantgen.batch(family, 3, range={"beta": [10, 40]}).form.name == "directions"
    nice = variantgen.batch(family, 3, nice=True)
    assert nice.form.name in family.nice_forms


SCENE = """
schema = 1
title = { en = "Crank and slider" }
length_unit = "m"
ask = ["v_B", "a_B"]
bodies = { OA = ["O", "A"], AB = ["A", "B"] }
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { coordinates = { x = 0, y = 0.3 } }
B = { coordinates = { x = 0.4, y = 0 } }
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B", angle = 0 }
[[drivers]]
rotation = { body = "OA", omega = 2, epsilon = 0 }
"""


def test_a_scene_of_ones_own_without_parameters(tmp_path: Path) -> None:
    path = tmp_path / "crank.toml"
    path.write_text(SCENE, "utf-8")
    found = variantgen.batch(str(path), 2)
    # A is at the top: the rod is in translation with v = 2 * 0.3 m/s.
    assert found.answers["v_B"] == pytest.approx([0.6, 0.6])
    assert repr(found[0]) == "<Variant of crank>"
    assert "<svg" in found[0]._repr_html_()
    assert "Answer" in variantgen.explain(found[0], ask=["v_B"])._repr_html_()


def test_where_nothing_is_left_to_draw_there_are_no_screens_of_a_draw(tmp_path: Path) -> None:
    """Parts that lie in one place on paper are refused to a draw, and no matter to an author who wrote them so."""
    kinds = Path(__file__).parents[1] / "textbook_kinds"
    # The cylinder unwinds: its centre falls with 2 m/s from a thread 0.1 m beside it.
    yoyo = variantgen.batch(str(kinds / "yoyo.toml"), 3, ask=["v_O.y", "omega_d"])
    assert len(yoyo) == 3
    assert yoyo.answers["v_O.y"] == pytest.approx([-2] * 3)
    assert np.abs(yoyo.answers["omega_d"]) == pytest.approx([20] * 3)
    for name in ("peaucellier", "watt_six_bar", "oldham"):
        assert variantgen.batch(str(kinds / f"{name}.toml"), 2).motion.solved.all()
    with pytest.raises(InputError, match="no valid variant found"):
        variantgen.batch(str(kinds / "yoyo.toml"), 1, for_sheets=True)
    apart, twice = tmp_path / "apart.toml", tmp_path / "twice.toml"
    apart.write_text(
        SCENE.replace("x = 0.4, y = 0 }", "x = 0.4, y = 0.3 }").replace("angle = 0 ", "angle = 90 "), "utf-8"
    )
    with pytest.raises(InputError, match="dead point"):
        variantgen.batch(str(apart), 2)
    twice.write_text(SCENE.replace("x = 0.4, y = 0 }", "x = 0, y = 0.3 }"), "utf-8")
    with pytest.raises(InputError, match=r"twice\.toml: bodies\.AB: the points A and B"):
        variantgen.batch(str(twice), 2)


def test_values_that_go_together_do_so_where_one_pair_is_left() -> None:
    """Hand-friendly Scotch yokes have phi and alpha (60, 120) or (120, 150): with phi 120, alpha is 150."""
    fixed = {"OA": 10, "omega_OA": 2, "epsilon_OA": 0, "sense": "counter_clockwise", "phi": 120}
    found = variantgen.batch("scotch_yoke", 2, form="oblique", nice=True, set=fixed)
    assert found.parameters["alpha"].tolist() == [150, 150]
    assert one_variant("scotch_yoke", fixed, form="oblique", nice=True).printed["alpha"] == 150


def test_the_table_has_columns_of_one_length() -> None:
    found = variantgen.batch("four_bar", 5, ask=["v_B.x"])
    table = found.table()
    assert list(table) == [*found.form.parameters, "v_B.x"]
    wide = found.table(motion=True)
    assert {"x_A", "y_A", "v_B.x", "a_M.y", "omega_AB", "epsilon_BC"} < wide.keys()
    assert {column.shape for column in wide.values()} == {(5,)}
    assert wide["v_B.x"] == pytest.approx(100 * found.velocities["B"].real)
    assert wide["x_A"] == pytest.approx(100 * found.positions["A"].real)
    rows = list(csv.DictReader(io.StringIO(found.csv(motion=True))))
    assert len(rows) == 5
    assert float(rows[3]["v_B.x [cm/s]"]) == wide["v_B.x"][3]
    assert rows[2]["side"] == table["side"][2]


def test_a_part_of_a_batch_is_a_batch() -> None:
    found = variantgen.batch("four_bar", 6, seed=1)
    for places in (slice(0, 2), slice(None, None, -2), slice(4, 4)):
        part, expected = found[places], list(range(6))[places]
        assert len(part) == len(part.table()["OA"]) == len(expected)
        assert [variant.printed for variant in part] == [found[i].printed for i in expected]
        assert part.answers["v_B"].tolist() == [found.answers["v_B"][i] for i in expected]
        assert part.velocities["B"].tolist() == [found.velocities["B"][i] for i in expected]
        assert part._repr_html_()
    assert found[np.int64(3)].printed == found[3].printed
    with pytest.raises(TypeError):
        found["3"]  # type: ignore[call-overload]


def test_numbers_arrays_and_ranges_of_numpy_and_python_are_taken() -> None:
    found = variantgen.batch("four_bar", np.int64(3), set={"OA": np.int64(30), "omega_OA": np.float32(1.3)})
    assert (len(found), set(found.parameters["OA"]), set(found.parameters["omega_OA"])) == (3, {30}, {1.3})
    for limits in (np.array([60, 90]), np.array([60.0, 90.0]), range(60, 91), (60, 90)):
        narrowed = variantgen.batch("four_bar", 30, form="rocker", range={"phi": limits})
        assert set(narrowed.parameters["phi"]) <= {60, 65, 70, 75, 80, 85, 90}
    sides = variantgen.batch("four_bar", 2, range={"side": np.array(["left"])}, folders=[Path("nowhere")])
    assert set(sides.table()["side"]) == {"left"}


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"n": True}, r"n: expected a whole number from 1 to 10000000 \(got True\)"),
        ({"ask": 5}, r"ask: expected the name of a quantity \(got 5\)"),
        ({"ask": ["v_B", 5]}, r"ask: expected the name of a quantity \(got 5\)"),
        ({"set": ["OA=3"]}, r"set: expected names of parameters with values \(got \['OA=3'\]\)"),
        ({"range": {3: 4}}, r"range: expected names of parameters with values \(got \{3: 4\}\)"),
        ({"range": {"phi": range(30, 61, 10)}}, r"range\.phi: expected \[lowest, highest\] \(got \[30, 40, 50, 60\]\)"),
        ({"range": {"phi": np.eye(2)}}, r"range\.phi: expected a number"),
        ({"form": 5}, r"form: unknown form \(got 5\)"),
        ({"family": "four_bra"}, "did you mean four_bar"),
        ({"form": "crnk"}, "did you mean crank"),
        ({"n": 0}, "expected a whole number from 1"),
        ({"n": 2.5}, "expected a whole number from 1"),
        ({"ask": ["v_Q"]}, "unknown quantity"),
        ({"set": {"OX": 3}}, "unknown parameter"),
        ({"range": {"phi": (1, 2)}}, "no value of the family's grid"),
        ({"set": {"OA": 90, "AB": 20, "BC": 20, "OC": 30}}, "no valid variant found"),
    ],
)
def test_wrong_arguments_are_told(arguments: dict[str, object], says: str) -> None:
    with pytest.raises(InputError, match=says):
        variantgen.batch(**({"family": "four_bar", "n": 3} | arguments))  # type: ignore[arg-type]


def test_a_large_batch_is_fast() -> None:
    """Ten thousand four-bars with answers: 0.08 s where it was measured; one by one they take minutes."""

    def seconds(seed: int) -> float:
        start = time.process_time()
        assert variantgen.batch("four_bar", 10_000, seed=seed).answers["v_B"].size == 10_000
        return time.process_time() - start

    assert min(seconds(seed) for seed in range(3)) < 0.5


def test_representations_have_one_line() -> None:
    found = variantgen.batch("four_bar", 3, seed=1)
    objects = [
        found,
        found[0],
        found.motion,
        found.family,
        found.form,
        *variantgen.answers(found[0]),
        variantgen.turn(found[0]),
    ]
    for item in objects:
        assert repr(item).startswith("<")
        assert "\n" not in repr(item)
        assert len(repr(item)) < 300
    assert isinstance(found, Batch)
    assert repr(found[0]).startswith("<Variant of four_bar crank: OA = ")
