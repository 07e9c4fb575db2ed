"""Every method is evaluated for every variant on paper; one that deviates stops the build."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from variantgen.builder import build
from variantgen.exam.confirm import confirm
from variantgen.exam.roster import numbered
from variantgen.exam.sheets import solve_all
from variantgen.families.asking import read_ask
from variantgen.families.load import load_family
from variantgen.mechanism.motion import Motion
from variantgen.methods.hand import evaluation
from variantgen.variants.attempts import VerificationError
from variantgen.variants.draw import FamilySampler
from variantgen.variants.variant import Variant


@pytest.fixture(scope="module")
def drawn() -> list[Variant]:
    return FamilySampler(load_family("sleeve_on_crank"), None).after([("confirm", i) for i in range(4)], [0] * 4)


def spoiled(motion: Motion, **changes: object) -> Motion:
    tables = {key: {**getattr(motion, key), **value} for key, value in changes.items()}
    return replace(motion, **tables)


def deviating(variants: list[Variant], motion: Motion) -> str:
    asked = [read_ask(v.form) for v in variants]
    with pytest.raises(VerificationError) as caught:
        confirm(variants, asked, [(motion, i) for i in range(len(variants))], [("7", f"s{i}", 2) for i in range(4)])
    return str(caught.value)


def test_good_variants_pass(drawn: list[Variant]) -> None:
    asked = [read_ask(v.form) for v in drawn]
    confirm(drawn, asked, solve_all(drawn, asked), [("7", f"s{i}", 2) for i in range(4)])


def test_one_wrong_velocity_stops_the_build_and_names_the_seed(drawn: list[Variant]) -> None:
    motion, _ = solve_all(drawn, [read_ask(v.form) for v in drawn])[0]
    v = motion.v["B"].copy()
    v[2] *= 1 + 1e-7
    message = deviating(drawn, spoiled(motion, v={"B": v}))
    assert "sleeve_on_crank: the method" in message
    assert "(seed, student, problem: 7, s2, 2)" in message
    assert f"OA={drawn[2].printed['OA']}" in message


@pytest.mark.parametrize(
    ("table", "name"), [("omega", "AB"), ("omega", "BD"), ("epsilon", "BD"), ("a", "B"), ("a", "D"), ("v", "C")]
)
def test_whatever_is_wrong_is_noticed(drawn: list[Variant], table: str, name: str) -> None:
    motion, _ = solve_all(drawn, [read_ask(v.form) for v in drawn])[0]
    values = getattr(motion, table)[name].copy()
    values[0] *= 1 + 1e-6
    assert "(seed, student, problem: 7, s0, 2)" in deviating(drawn, spoiled(motion, **{table: {name: values}}))


def test_each_method_notices_a_wrong_rate_by_itself(drawn: list[Variant]) -> None:
    from variantgen.methods.by_groups.solve_groups import velocities
    from variantgen.methods.linkage.problem import task_of
    from variantgen.methods.solution.book import Book

    asked = read_ask(drawn[0].form)
    motion, place = solve_all(drawn, [read_ask(v.form) for v in drawn])[0]
    groups = velocities(Book(task_of(drawn[0], motion, place, asked)))
    good = evaluation.deviations(motion, groups)
    assert max(float(worst.max()) for worst in good.values()) < 1e-12
    wrong = spoiled(
        motion,
        omega={name: 1.001 * rate for name, rate in motion.omega.items()},
        epsilon={name: 1.001 * rate for name, rate in motion.epsilon.items()},
    )
    found = evaluation.deviations(wrong, groups)
    noticed = {name for name, worst in found.items() if float(worst.max()) > 1e-9}
    # Equal projections speak of no rate.
    assert noticed == set(found) - {"projections"}


def test_a_solution_that_disagrees_stops_the_build_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("variantgen.methods.agreement.deviation", lambda book: 1e-6)
    exam = tmp_path / "exam.toml"
    exam.write_text('title = "Quiz"\nlanguage = "en"\n[[problem]]\nfamily = "spool"\n', encoding="utf-8")
    with pytest.raises(VerificationError) as caught:
        build(exam, numbered(2), tmp_path / "out", seed="97")
    assert "spool: the solution deviates from the solver by 1.0e-06 for r=" in str(caught.value)
    assert "(student 1, problem 1) (seed 97)" in str(caught.value)
    assert not (tmp_path / "out").exists()
