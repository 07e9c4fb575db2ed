"""Screens and the rule that an unverified variant never reaches paper."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from variantgen.builder import build
from variantgen.exam.roster import numbered
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.load import load_family
from variantgen.mechanism.joints.slot import Slot
from variantgen.variants.attempts import VerificationError
from variantgen.variants.draw import draw
from variantgen.variants.screening import sensitivity
from variantgen.variants.variant import parameter_arrays, solve_variants

CATALOG_EXAM = 'title = "T"\nlanguage = "en"\n[[problem]]\nfamily = "sleeve_on_crank"\n'


def test_a_wrong_solver_stops_the_build_and_writes_nothing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    # The Coriolis term is forgotten; the independent computation does not know the rows and notices.
    monkeypatch.setattr(Slot, "quadratic", lambda self, at, speeds: (0.0,))
    exam = tmp_path / "exam.toml"
    exam.write_text(CATALOG_EXAM, "utf-8")
    with pytest.raises(VerificationError, match=r"sleeve_on_crank.*seed, student, problem: 0, \d, 1\) for"):
        build(exam, numbered(3), tmp_path / "out")
    assert [path.name for path in tmp_path.iterdir()] == ["exam.toml"]


def test_accepted_variants_keep_what_the_screens_promise() -> None:
    variants = draw(load_family("four_bar"), None, [("screen", i) for i in range(300)])
    for form in load_family("four_bar").forms.values():
        members = [variant for variant in variants if variant.form.name == form.name]
        motion = solve_variants(members, 2)
        # Angle between coupler and rocker (or crank), from the definition.
        one, other = ("A", "O") if form.name == "rocker" else ("B", "C")
        coupler = motion.z["B"] - motion.z["A"]
        link = motion.z[one] - motion.z[other]
        sine = np.abs(np.imag(np.conj(coupler) * link)) / np.abs(coupler) / np.abs(link)
        assert np.all(sine >= math.sin(math.radians(30)) * (1 - 1e-6))
        places = np.array([motion.z[p] for p in ("O", "A", "B", "C")])
        size = np.maximum(np.ptp(places.real, axis=0), np.ptp(places.imag, axis=0))
        for i in range(4):
            for j in range(i):
                assert np.all(np.abs(places[i] - places[j]) >= 0.11 * size * (1 - 1e-6))


def test_sensitivity_of_a_wheel_by_hand() -> None:
    # omega = v/R: d ln omega / d ln v = 1, / d ln R = -1, so sqrt(2); epsilon likewise.
    variants = draw(load_family("rolling_wheel"), None, [("s", i) for i in range(5)])
    form = variants[0].form
    asked = [parse_quantity(text, form.sample) for text in ("omega_wheel", "epsilon_wheel")]
    motion = solve_variants(variants, 2)
    gain = sensitivity(form, parameter_arrays(variants), motion.frame, asked, motion)
    assert gain == pytest.approx(math.sqrt(2), rel=1e-4)
