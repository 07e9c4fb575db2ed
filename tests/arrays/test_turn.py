"""The motion over a turn as columns and CSV, against closed forms written here."""

from __future__ import annotations

import csv
import io
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import variantgen
from variantgen.errors import InputError


def test_a_slider_crank_over_a_turn() -> None:
    variant = variantgen.batch("slider_crank", 1, seed=8, form="offset", set={"sense": "counter_clockwise"})[0]
    a, b, omega = (variant.si(name) for name in ("OA", "AB", "omega_OA"))
    e = float(variant.printed["above"]) * variant.si("e")
    found = variantgen.turn(variant, samples=73)
    assert (found.name, found.unit, len(found)) == ("phi", "deg", 73)
    assert (found.values[0], found.values[-1]) == pytest.approx((0, 360))
    assert found.values[found.instant] == pytest.approx(float(variant.printed["phi"]))
    phi = np.radians(found.values)
    root = np.sqrt(b**2 - (e - a * np.sin(phi)) ** 2)
    slope = -a * np.sin(phi) + (e - a * np.sin(phi)) * a * np.cos(phi) / root
    motion = found.motion
    assert np.abs(motion.z["B"] - motion.z["O"]) == pytest.approx(np.abs(a * np.cos(phi) + root + 1j * e))
    assert np.abs(motion.v["B"]) == pytest.approx(np.abs(slope * omega), abs=1e-12)
    rows = list(csv.DictReader(io.StringIO(found.csv())))
    assert [float(row["phi [deg]"]) for row in rows] == found.values.tolist()
    speed = [np.hypot(float(row["v_B.x [cm/s]"]), float(row["v_B.y [cm/s]"])) for row in rows]
    assert speed == pytest.approx((100 * np.abs(slope * omega)).tolist(), abs=1e-9)


def test_where_velocities_have_no_meaning_there_are_none() -> None:
    whole = variantgen.turn(variantgen.batch("four_bar", 1, seed=1, form="rocker")[0], samples=50)
    assert {end.value for end in whole.ends} == {"dead_point"}
    clear = np.arange(len(whole)) < len(whole) - 1
    found = replace(whole, clear=clear)
    table = found.table()
    assert np.isnan(table["v_B.x"]).tolist() == np.isnan(table["epsilon_AB"]).tolist() == (~clear).tolist()
    assert not np.isnan(table["x_B"]).any()
    last = list(csv.DictReader(io.StringIO(found.csv())))[-1]
    assert last["v_B.x [cm/s]"] == ""
    assert float(last["x_B [cm]"]) == table["x_B"][-1]


def test_a_way_is_in_the_unit_of_the_family() -> None:
    found = variantgen.turn(variantgen.batch("spool", 1)[0])
    assert (found.name, found.unit) == ("way", "cm")
    moved = 100 * np.abs(np.diff(found.motion.z["B"]))
    assert np.abs(np.diff(found.values)) == pytest.approx(moved)
    assert found.values[found.instant] == 0


def test_motion_of_a_variant_at_the_instant() -> None:
    variant = variantgen.batch("four_bar", 1, seed=2)[0]
    motion, turn = variant.motion(), variantgen.turn(variant)
    for name in motion.z:
        assert turn.motion.z[name][turn.instant] == pytest.approx(motion.z[name][0])
        assert turn.motion.a[name][turn.instant] == pytest.approx(motion.a[name][0])
    # The crank: |v_A| = OA omega.
    assert abs(motion.v["A"][0]) == pytest.approx(variant.si("OA") * variant.si("omega_OA"))
    assert variant.motion(order=1).a == {}


def test_what_does_not_move_has_no_turn() -> None:
    variant = variantgen.batch("four_bar", 1, set={"omega_OA": 2, "OA": 30, "AB": 60, "BC": 60, "OC": 60})[0]
    still = {**variant.printed, "OA": variant.printed["OC"] * 9}
    broken = type(variant)(variant.family, variant.form, still)
    with pytest.raises(InputError, match="does not assemble"):
        variantgen.turn(broken)


@pytest.mark.parametrize("samples", [-5, 0, 1, 2.5, "90", True, 10**9])
def test_a_turn_has_two_positions_or_more(samples: Any) -> None:
    with pytest.raises(InputError, match="samples: expected a whole number from 2 to 1000000"):
        variantgen.turn(variantgen.batch("four_bar", 1, seed=2)[0], samples)


def test_a_turn_is_of_one_variant() -> None:
    found = variantgen.batch("four_bar", 1, seed=2)
    with pytest.raises(InputError, match=r"expected a variant \(got Batch\)\n.*turn\(found\[0\]\)"):
        variantgen.turn(found)  # type: ignore[arg-type]
    least = variantgen.turn(found[0], np.int64(2))
    assert np.isfinite(least.values).all()
    assert len(least) >= 2
