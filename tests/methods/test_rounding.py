"""The error of a careful hand calculation: by hand formulas, and against the written solution in three digits."""

from __future__ import annotations

import numpy as np
import pytest

from tests.methods.forms import FORMS, tasks, variants
from variantgen.algebra.expression import Constant, Ratio, Total, Value
from variantgen.algebra.linear import LinearSolution
from variantgen.algebra.name import Name
from variantgen.algebra.vectorised import Operations
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.methods.compose import solution
from variantgen.methods.hand.repeatable_calculation import RepeatableCalculation
from variantgen.methods.hand.rounding import HandCalculation
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.methods.steps.printed_digits import follow_printed_digits
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants

USUAL = ("velocity_centre", "acceleration_pole")


def printed(task: Task) -> dict[str, np.ndarray]:
    """The printed numbers by parameter, magnitudes of rates."""
    found = {}
    for name, parameter in task.form.parameters.items():
        if parameter.unit is not None:
            number = float(task.variant.printed[name])
            found[name] = np.array([abs(number) if parameter.is_rate else number])
    return found


def errors_of(task: Task) -> np.ndarray:
    with np.errstate(all="ignore"):
        return RepeatableCalculation.of(task).errors(printed(task))[:, 0]


def test_the_rounding_of_a_product_and_of_a_quotient() -> None:
    # omega = v / OP with OP = 3 * 7.77 = 23.31: OP is rounded to 23.3 (half a unit 0.05), omega = 0.429 (0.0005).
    given = Value(None, "length", 7.77)
    arm = Value(Name("length", "O", "P"), "length", 23.31, Constant(3.0) * given)
    omega = Value(Name("omega", "wheel"), "angular velocity", 10 / 23.31, Ratio(Constant(10.0), arm))
    found = RepeatableCalculation([omega], {id(given): "g"}).errors({"g": np.array([7.77, 5.0])})
    by_arm = 10 / 23.31 - 10 / 23.36
    total = by_arm + 0.0005
    three_sigma = 3 * np.sqrt((by_arm**2 + 0.0005**2) / 3)
    assert found[0, 0] == pytest.approx(min(total, three_sigma), rel=1e-9)
    # 3 * 5 = 15.0 is not rounded; 10/15 = 0.667 is.
    assert found[0, 1] == pytest.approx(0.0005, rel=1e-9)


def test_cancellation_is_seen() -> None:
    # 100.4 - 99.96: each term is off by half a unit of its third digit, 0.5 and 0.05, the difference 0.44 by both.
    given = Value(None, "number", 1.0)
    first = Value(Name("a", "A"), "acceleration", 100.4, given * Constant(100.4))
    second = Value(Name("a", "B"), "acceleration", 99.96, given * Constant(99.96))
    difference = Value(Name("a", "C"), "acceleration", 0.44, Total(((1, first), (-1, second))))
    worked = RepeatableCalculation([difference], {id(given): "g"})
    assert worked.errors({"g": np.array([1.0])})[0, 0] == pytest.approx(0.55, rel=1e-6)


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_the_written_solution_in_three_digits_stays_within_it(name: str, form: str) -> None:
    """All numbers of the solution are rounded to three digits, each computed from rounded ones."""
    for task in tasks(name, form, 4):
        errors = errors_of(task)
        # A family may name a method for the whole problem; tolerances come from the usual steps.
        found = solution(task, USUAL if "three_rates" in task.variant.family.solution else ())
        answers = [value for _, value in found.answers]
        follow_printed_digits([*(item for step in found.steps for item in step.items), *found.check], answers, 3)
        for quantity, answer, error in zip(task.asked, answers, errors, strict=True):
            if quantity.component != "sense":
                # More than 1: what is of second order, and angles that projections round once more.
                assert abs(answer.shown - answer.exact) <= 1.5 * error + 1e-9 * abs(answer.exact)


@pytest.mark.parametrize("name", ["four_bar", "slider_crank", "rolling_wheel", "guided_plate"])
def test_what_is_found_for_a_variant_does_not_depend_on_the_others(name: str) -> None:
    family = load_family(name)
    form = next(iter(family.forms.values()))
    own = restrict(family, None, None, (form.name,) if form.name else ())
    drawn = draw(own, None, [("alone", i) for i in range(14)])
    asked = read_ask(drawn[0].form, None)
    motion = solve_variants(drawn, 2)

    def calculation() -> HandCalculation:
        return HandCalculation(
            drawn[0].form, asked, lambda count: draw(own, None, [("models", i) for i in range(count)])
        )

    together = calculation().errors(drawn, motion, range(14))
    for i in (0, 5, 13):
        alone = calculation().errors([drawn[i]], solve_variants([drawn[i]], 2), [0])
        assert alone[:, 0] == pytest.approx(together[:, i], rel=1e-9)
    backwards = calculation().errors(drawn[::-1], motion, range(13, -1, -1))
    assert backwards[:, ::-1] == pytest.approx(together, rel=1e-9)


def test_steps_of_one_variant_lead_to_the_answers_of_others() -> None:
    drawn, motion = variants("slider_crank", "central", 12)
    asked = read_ask(drawn[0].form, None)
    worked = RepeatableCalculation.of(task_of(drawn[0], motion, 0, asked))
    data = {
        name: np.concatenate([printed(task_of(v, motion, i, asked))[name] for i, v in enumerate(drawn)])
        for name in ("OA", "AB", "phi", "omega_OA", "epsilon_OA")
    }
    repeated = worked.repeat(data)
    right = 0
    for i in range(12):
        exact = [q.unit("cm").from_si(float(q.value(motion)[i])) for q in asked]
        right += bool(np.allclose(np.abs(repeated[:, i]), np.abs(exact), rtol=1e-9))
    assert right >= 3


def test_a_singular_system_of_one_variant_leaves_the_others_alone() -> None:
    first, second, third = (Value(None, "number", 0.0) for _ in range(3))
    operations = Operations()
    places = {id(value): operations.named(str(i)) for i, value in enumerate((first, second, third))}
    numbers = operations.begin({"0": np.array([1.0, 2.0]), "1": np.array([4.0, 4.0]), "2": np.array([6.0, 6.0])})
    # x + 2 y = 6, first x + 4 y = 4: y = -1 for first = 1, no solution for first = 2.
    rows = ((Constant(1.0), Constant(2.0)), (first, second))
    place = operations.of(LinearSolution(rows, (third, second), 1), places)
    numbers += operations.start[len(numbers) :]
    operations.run(numbers, operations.listed)
    found = numbers[place]
    assert found[0] == pytest.approx(-1.0)
    assert np.isnan(found[1])


def test_values_that_are_computed_alike_are_rounded_each_for_itself() -> None:
    # Two products 1.115 are off by half a unit of the third digit each, their difference by both.
    given = Value(None, "length", 1.115)
    first, second = (Value(Name("a", point), "length", 1.115, given * Constant(1.0)) for point in "AB")
    worked = RepeatableCalculation([Value(None, "length", 0.0, Total(((1, first), (-1, second))))], {id(given): "g"})
    assert worked.errors({"g": np.array([1.115])})[0, 0] == pytest.approx(0.01, rel=1e-9)
    assert worked.repeat({"g": np.array([1.115])})[0, 0] == 0
