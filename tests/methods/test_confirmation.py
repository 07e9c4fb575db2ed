"""Damaged methods are caught: a wrong formula, a wrong printed number, an equation that does not balance."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pytest
from msgspec.structs import replace

from tests.methods.damaged import damage_formulas
from variantgen.algebra.expression import Constant, Expression, Raised, Ratio, SquareRoot, Times, Total, Value
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.methods.agreement import confirm
from variantgen.methods.checks import check
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import (
    Balance,
    EquationLine,
    Item,
    LinearSystem,
    Projection,
    Solution,
    Step,
    VectorLine,
)
from variantgen.variants.attempts import VerificationError
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants


def task(name: str, form: str, ask: tuple[str, ...] = ()) -> Task:
    family = load_family(name)
    family = restrict(family, None, None, (form,) if form else ())
    variant = draw(family, None, [("1", "damaged", 0)])[0]
    return task_of(variant, solve_variants([variant], 2), 0, read_ask(variant.form, ask or None))


def factor(expression: Expression) -> Expression:
    return Constant(2.0) * expression


def sign(expression: Expression) -> Expression:
    """The last term of the first sum in it with the other sign; without a sum, of it all."""
    match expression:
        case Total(terms) if len(terms) > 1:
            return Total((*terms[:-1], (-terms[-1][0], terms[-1][1])))
        case Ratio(above, below):
            return Ratio(sign(above), below)
        case SquareRoot(inner):
            return SquareRoot(sign(inner))
    return -expression


def upside_down(expression: Expression) -> Expression:
    assert isinstance(expression, Ratio)
    return Ratio(expression.below, expression.above)


def without_square(expression: Expression) -> Expression:
    """``omega r`` for ``omega^2 r``, ``v / r`` for ``v^2 / r``."""
    match expression:
        case Raised(base, 2):
            return base
        case Times(factors):
            return Times(tuple(without_square(item) for item in factors))
        case Ratio(above, below):
            return Ratio(without_square(above), below)
    return expression


def other_arm(expression: Expression) -> Expression:
    """A product with another length of the same problem in place of the arm."""
    assert isinstance(expression, Times)
    arm = next(item for item in expression.factors if isinstance(item, Value) and item.measure == "length")
    longer = Value(arm.name, "length", 1.5 * arm.exact)
    return Times(tuple(longer if item is arm else item for item in expression.factors))


DAMAGES = [
    ("four_bar", "crank", "velocity_centre", "omega", factor),
    ("four_bar", "crank", "velocity_centre", "omega", upside_down),
    ("four_bar", "crank", "velocity_centre", "length centre", sign),
    ("four_bar", "crank", "velocity_centre", "v", sign),
    ("four_bar", "crank", "velocity_pole", "v", other_arm),
    ("four_bar", "crank", "velocity_pole", "a n", without_square),
    ("four_bar", "crank", "velocity_pole", "a n", other_arm),
    ("four_bar", "crank", "velocity_pole", "a tau", sign),
    ("four_bar", "crank", "three_rates", "omega", factor),
    ("slider_crank", "central", "projections", "v", factor),
    ("slider_crank", "offset", "projections", "v B", upside_down),
    ("slider_crank", "central", "velocity_centre", "epsilon", upside_down),
    ("sleeve_on_crank", "", "relative_motion", "a cor", sign),
    ("sleeve_on_crank", "", "relative_motion", "a cor", factor),
    ("sleeve_on_crank", "", "relative_motion", "a n C B", without_square),
    ("point_on_rotating_disc", "groove", "analytical", "a rel n", sign),
    ("plate_acceleration_centre", "square", "acceleration_centre", "length centre", factor),
    ("plate_acceleration_centre", "square", "acceleration_centre", "a", sign),
    ("crank_and_disc", "relative", "analytical", "a", sign),
    ("slider_crank", "offset", "coordinates", "omega", factor),
    ("slider_crank", "offset", "graphical", "v A", other_arm),
    ("slider_crank", "offset", "graphical", "a n", without_square),
    ("falling_rod", "", "analytical", "parameter", factor),
]


@pytest.mark.parametrize(("name", "form", "method", "symbol", "damage"), DAMAGES)
def test_a_wrong_formula_is_caught(
    name: str, form: str, method: str, symbol: str, damage: Callable[[Expression], Expression], monkeypatch
) -> None:
    """The formula is wrong in itself: what follows from it is computed with the wrong number."""
    found = task(name, form)
    solution(found, (method,))
    damaged = damage_formulas(monkeypatch, symbol, damage)
    with pytest.raises(VerificationError, match=rf"^{name}: the solution by .* deviates from the solver: .* is off by"):
        solution(found, (method,))
    assert damaged, "the damage was met"


def test_the_message_names_the_method_the_step_and_the_data(monkeypatch: pytest.MonkeyPatch) -> None:
    found = task("slider_crank", "central")
    monkeypatch.setattr("variantgen.methods.agreement.deviation", lambda book: 0.0)
    damage_formulas(monkeypatch, "a n", factor)
    with pytest.raises(VerificationError) as caught:
        solution(found, ("velocity_centre", "acceleration_pole"))
    message = str(caught.value)
    assert (
        "slider_crank: the solution by velocity_centre, acceleration_pole deviates from the solver: a_A n in the step"
        in message
    )
    assert f"for OA={found.variant.printed['OA']}" in message


def test_a_number_that_nothing_follows_from_is_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lengths and checks at the end lead to no answer."""
    found = task("slider_crank", "central")
    right = check.third_axis

    def wrong(steps: Sequence[Step]) -> list[Item]:
        *items, last = right(steps)
        assert isinstance(last, Balance)
        number = 1.001 * last.left.exact
        return [*items, Balance(Value(None, last.left.measure, number, Constant(number)), last.right)]

    monkeypatch.setattr(check, "third_axis", wrong)
    with pytest.raises(VerificationError, match="in the step check is off by"):
        solution(found)


def test_two_wrong_formulas_that_make_up_for_each_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """The answer ``v_B = omega BP`` is right by luck: omega is twice too large, and ``v`` is halved."""
    found = task("slider_crank", "central", ("v_B",))
    right = Book.derive

    def derive(book: Book, name, measure, expression):  # type: ignore[no-untyped-def]
        changed = {"omega": 2.0, "v": 0.5}.get(name.kind if name.of != "A" else "", 1.0)
        return right(book, name, measure, Constant(changed) * expression)

    monkeypatch.setattr(Book, "derive", derive)
    with pytest.raises(VerificationError):
        solution(found, ("velocity_centre",))


def _other(solved: Solution, kind: type[Item], change: Callable[[Item], Item]) -> Solution:
    """The solution with its first item of a kind changed."""
    for step in solved.steps:
        for i, item in enumerate(step.items):
            if isinstance(item, kind):
                step.items[i] = change(item)
                return solved
    raise AssertionError(f"no {kind}")


EQUATIONS = [
    ("velocity_pole", VectorLine, lambda item: VectorLine(item.left, item.right[:-1])),
    ("velocity_pole", VectorLine, lambda item: VectorLine(item.right[1:], (*item.left, item.right[0]))),
    (
        "velocity_pole",
        Projection,
        lambda item: Projection(
            item.words, item.left, (replace(item.right[0], sign=-item.right[0].sign), *item.right[1:])
        ),
    ),
    ("coordinates", EquationLine, lambda item: EquationLine(item.left, Constant(2.0) * item.right)),
    ("three_rates", LinearSystem, lambda item: LinearSystem(item.unknowns[::-1], item.rows, item.right)),
]


@pytest.mark.parametrize(("method", "kind", "change"), EQUATIONS)
def test_a_printed_equation_that_does_not_balance_is_caught(
    method: str, kind: type[Item], change: Callable[[Item], Item]
) -> None:
    """A term left out or on the wrong side, a sign, a factor, unknowns exchanged: no number of the solution changes."""
    found = task("four_bar", "crank")
    book, solved = Book(found), solution(found, (method,))
    confirm(book, solved, (method,))
    with pytest.raises(VerificationError, match="equation"):
        confirm(book, _other(solved, kind, change), (method,))


def test_an_answer_with_the_wrong_sign_is_caught() -> None:
    found = task("four_bar", "crank", ("omega_AB",))
    solved = solution(found)
    ((name, value),) = solved.answers
    wrong = Value(value.name, value.measure, -value.exact, -value)
    with pytest.raises(VerificationError, match="the answer omega_AB is off by"):
        confirm(Book(found), replace(solved, answers=((name, wrong),)), ("pole",))
