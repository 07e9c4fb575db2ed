"""Answers are confirmed by the steps that a solution would print; where they lead elsewhere, nothing is built."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from tests.methods.damaged import damage_formulas
from variantgen.algebra.expression import Constant, Expression
from variantgen.builder import build
from variantgen.cli import main
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.roster import numbered
from variantgen.exam.sheets import solve_all
from variantgen.exam.work.fairness import FairDraws
from variantgen.families.asking import read_ask
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.load import load_family
from variantgen.mechanism.motion import Motion
from variantgen.methods.hand.confirmation import UnconfirmedError, confirm_answers
from variantgen.variants.attempts import VerificationError
from variantgen.variants.draw import FamilySampler
from variantgen.variants.variant import Variant


@pytest.fixture
def drawn() -> list[Variant]:
    return FamilySampler(load_family("sleeve_on_crank"), None).after([("confirm", i) for i in range(4)], [0] * 4)


def solved(variants: list[Variant]) -> Motion:
    return solve_all(variants, [read_ask(v.form) for v in variants])[0][0]


def test_good_variants_pass(drawn: list[Variant]) -> None:
    confirm_answers(drawn, read_ask(drawn[0].form), solved(drawn), range(4))


# Both signs of what is asked: an answer that is right but for its sign is wrong.
@pytest.mark.parametrize("factor", [1 + 1e-6, -1.0])
@pytest.mark.parametrize(
    ("asked", "table", "name"),
    [
        ("omega_BD", "omega", "BD"),
        ("epsilon_BD", "epsilon", "BD"),
        ("v_A.x", "v", "A"),
        ("a_B.angle", "a", "B"),
        ("omega_BD.sense", "omega", "BD"),
    ],
)
def test_one_wrong_number_is_noticed_in_its_variant(
    drawn: list[Variant], asked: str, table: str, name: str, factor: float
) -> None:
    if factor > 0 and asked.endswith(("sense", "angle")):
        factor = -1.0  # neither depends on a magnitude
    quantities, motion = [parse_quantity(asked, drawn[0].form.sample)], solved(drawn)
    confirm_answers(drawn, quantities, motion, range(4))
    values = getattr(motion, table)[name].copy()
    values[0] *= factor
    wrong = replace(motion, **{table: {**getattr(motion, table), name: values}})
    with pytest.raises(UnconfirmedError, match="sleeve_on_crank: the steps of its solution lead to other") as caught:
        confirm_answers(drawn, quantities, wrong, range(4))
    assert caught.value.variant is drawn[0]
    assert f"OA={drawn[0].printed['OA']}" in str(caught.value)


def test_a_mirrored_scene_turns_the_other_way(drawn: list[Variant]) -> None:
    """The steps of one variant confirm the others that have its senses, mirrored ones included."""
    pair = [replace(drawn[0], sense=1), replace(drawn[0], sense=-1)]
    asked, motion = [parse_quantity("omega_BD", pair[0].form.sample)], solved(pair)
    assert motion.omega["BD"][0] == pytest.approx(-motion.omega["BD"][1])
    confirm_answers(pair, asked, motion, range(2))
    with pytest.raises(UnconfirmedError):
        confirm_answers(pair, asked, replace(motion, omega={**motion.omega, "BD": np.abs(motion.omega["BD"])}), [0, 1])


@pytest.mark.parametrize("factor", [1.0, 1 + 1e-6, -1.0])
def test_answers_worked_out_before_are_compared_with_the_solver(
    drawn: list[Variant], monkeypatch: pytest.MonkeyPatch, factor: float
) -> None:
    """Right ones need no steps any more, wrong ones confirm nothing: then it is the steps that count."""
    motion = solved(drawn)
    # No other test asks both, so that the form remembers no steps for them.
    asked = [parse_quantity(name, drawn[0].form.sample) for name in ("omega_BD", "epsilon_BD")]
    worked_out = np.array([motion.omega["BD"], motion.epsilon["BD"]])
    worked_out[0, 2] *= factor
    damage_formulas(monkeypatch, "omega", doubled)
    if factor == 1.0:
        confirm_answers(drawn, asked, motion, range(4), worked_out)
        return
    with pytest.raises(UnconfirmedError) as caught:
        confirm_answers(drawn, asked, motion, range(4), worked_out)
    assert caught.value.variant is drawn[2]


def test_of_fair_draws_the_answers_are_kept() -> None:
    """Those of the solver, signs included; what is asked otherwise has none."""
    family, tolerances = load_family("sleeve_on_crank"), AnswerTolerances()
    variants = FamilySampler(family, None, screening=FairDraws(0.05, tolerances)).after(
        [("kept", 1), ("kept", 2)], [0, 0]
    )
    asked, motion = read_ask(variants[0].form), solved(variants)
    right = [q.own_unit(family.length_unit).from_si(q.value(motion)) for q in asked]
    assert tolerances.worked_out(variants, asked) == pytest.approx(np.array(right), rel=1e-9, abs=1e-9)
    assert np.isnan(tolerances.worked_out(variants, asked[:1])).all()
    tolerances.forget()
    assert np.isnan(tolerances.worked_out(variants, asked)).all()


def exam(folder: Path, depth: str) -> Path:
    path = folder / "exam.toml"
    head = 'title = "Quiz"\nlanguage = "en"\nfair = false\n'  # a band would be looked for with the wrong formula, too
    text = f'{head}[solutions]\ndepth = "{depth}"\n[[problem]]\nfamily = "slider_crank"\n'
    path.write_text(text, encoding="utf-8")
    return path


def doubled(expression: Expression) -> Expression:
    return Constant(2.0) * expression


def opposite(expression: Expression) -> Expression:
    return -expression


@pytest.mark.parametrize("damage", [doubled, opposite])
@pytest.mark.parametrize("depth", ["none", "full"])
def test_a_wrong_formula_stops_a_build_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, depth: str, damage: Callable[[Expression], Expression]
) -> None:
    damage_formulas(monkeypatch, "omega", damage)
    with pytest.raises(VerificationError) as caught:
        build(exam(tmp_path, depth), numbered(2), tmp_path / "out", seed="97")
    message = str(caught.value)
    assert message.startswith("slider_crank: ")
    assert "for OA=" in message
    assert "(seed, student, problem: 97, 1, 1) (seed 97)" in message
    assert not (tmp_path / "out").exists()


def test_a_wrong_printed_number_stops_a_build(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing but the solution itself shows it: the answers are right."""
    monkeypatch.setattr("variantgen.methods.agreement.deviation", lambda book: 1e-6)
    with pytest.raises(VerificationError) as caught:
        build(exam(tmp_path, "short"), numbered(2), tmp_path / "out", seed="97")
    assert "slider_crank: the solution by velocity_centre, acceleration_pole deviates from the solver" in str(
        caught.value
    )
    assert "(student 1, problem 1) (seed 97)" in str(caught.value)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "arguments",
    [
        ("solve", "slider_crank"),
        ("solve", "slider_crank", "--json"),
        ("solve", "slider_crank", "--explain"),
    ],
)
def test_a_single_variant_is_confirmed_too(
    arguments: tuple[str, ...], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    damage_formulas(monkeypatch, "omega", doubled)
    assert main(list(arguments)) == 1
    assert "slider_crank: the s" in capsys.readouterr().err
