"""Three angular velocities and accelerations: the systems of the source, agreement with the solver."""

from __future__ import annotations

import pytest

from tests.methods.forms import FORMS, IDS, answers, exact, tasks
from tests.solved_cases import case_of, task
from variantgen.methods.agreement import deviation
from variantgen.methods.by_groups import three_rates
from variantgen.methods.linkage.problem import AGREES
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import LinearSystem
from variantgen.methods.steps.step_geometry import ChainGraph

SEEDS = 3
# Chains of three links between fixed pivots that lead to what is asked.
WITH_CHAIN = {"four_bar", "four_bar_with_sleeve", "limit_positions-rocker"}


def systems(book: Book) -> list[LinearSystem]:
    return [item for step in book.steps for item in step.items if isinstance(item, LinearSystem)]


def solved_case(family: str, case: str) -> Book:
    book = Book(task(*case_of(family, case)))
    three_rates.solve(book)
    return book


def numbers(system: LinearSystem) -> list[list[float]]:
    return [[v.exact for v in (*row, right)] for row, right in zip(system.rows, system.right, strict=True)]


class TestProblem28:
    """Kirsanov, problem 28, formulas (2.9) and (2.10): the printed coefficients."""

    book = solved_case("four_bar_with_sleeve", "K28")

    def test_angular_velocities(self) -> None:
        first, second = numbers(systems(self.book)[0])
        assert first == pytest.approx([9.63, -37.91, -28.28 * 3], abs=0.02)
        assert second == pytest.approx([-110.58, 20.30, -28.28 * 3], abs=0.02)

    def test_angular_accelerations(self) -> None:
        first, second = numbers(systems(self.book)[1])
        assert first == pytest.approx([-110.58, 20.30, 22.33], abs=0.02)
        assert second == pytest.approx([9.63, -37.91, -217.89], abs=0.05)

    def test_results(self) -> None:
        assert self.book.omega["AB"].sense * self.book.omega["AB"].size.exact == pytest.approx(1.2357815, rel=1e-7)
        assert self.book.omega["BC"].sense * self.book.omega["BC"].size.exact == pytest.approx(2.552124, rel=1e-6)
        assert self.book.epsilon["AB"].sense * self.book.epsilon["AB"].size.exact == pytest.approx(0.89462835, rel=1e-7)
        assert self.book.epsilon["BC"].sense * self.book.epsilon["BC"].size.exact == pytest.approx(5.9749754, rel=1e-7)

    def test_the_sleeve_follows_by_relative_motion(self) -> None:
        found = answers(self.book)
        assert found["v_rel_D"] == pytest.approx(58.557863, rel=1e-7)
        assert found["a_rel_D"] == pytest.approx(465.93779, rel=1e-7)


def test_example_by_directions() -> None:
    """Kirsanov: 4 omega_1 + 4 omega_3 = 0, 3 omega_1 - 4 omega_2 = 0; then 32 and 3 with omega_1 = 4."""
    book = solved_case("four_bar", "K26-directions")
    velocities, accelerations = systems(book)
    assert numbers(velocities)[0] == pytest.approx([-4, 0, -12])  # 3 * 4 - 4 omega_2 = 0
    assert numbers(velocities)[1] == pytest.approx([0, 4, -16])  # 4 * 4 + 4 omega_3 = 0
    assert numbers(accelerations)[0] == pytest.approx([0, 4, 3 * 16 - 4 * 9])  # 4 epsilon_3 = 3*16 - 4*9
    assert numbers(accelerations)[1] == pytest.approx([-4, 0, -4 * 16 - 4 * 16])
    assert answers(book)["epsilon_AB"] == pytest.approx(32)
    assert answers(book)["epsilon_BC"] == pytest.approx(3)


def test_notation_of_graphs() -> None:
    book = solved_case("four_bar", "K26-directions")
    (graph,) = [item for step in book.steps for item in step.items if isinstance(item, ChainGraph)]
    assert graph.start == "O"
    assert graph.ends == ("A", "B", "C")


@pytest.mark.parametrize(("name", "form"), FORMS, ids=IDS)
def test_agreement_with_the_solver(name: str, form: str) -> None:
    for item in tasks(name, form, SEEDS):
        led = bool(WITH_CHAIN & {name, f"{name}-{form}"})
        assert three_rates.applies(item) == led
        if led:
            book = Book(item)
            three_rates.solve(book)
            assert deviation(book) < AGREES
            for quantity in item.asked:
                wanted = exact(item, quantity)
                assert answers(book)[quantity.name] == pytest.approx(wanted, rel=1e-9, abs=1e-9)
