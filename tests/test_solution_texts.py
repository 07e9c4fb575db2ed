"""The measures of worked solutions: what is counted as a number, a long decimal, a sum that gives a known angle."""

from __future__ import annotations

from types import SimpleNamespace

from msgspec.structs import replace

from benchmarks import solution_texts
from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.exam.solution_figures import SolutionFigure
from variantgen.figure.drawing import Layer
from variantgen.figure.lettered_sketch import finish
from variantgen.figure.sketch import Sketch
from variantgen.wording.solution.document import Paragraph, Section, SolutionText


def text_of(words: str) -> SolutionText:
    return SolutionText((), (Section(("A",), (Paragraph((words,)),)),), ("no",))


def test_numbers_and_long_decimals_are_counted() -> None:
    counted = solution_texts.of_text(text_of("v_2 = 3.25 + 12 ≈ 15.2500001, the x axis, b^2"), "en")
    assert counted["numbers"] == 3 + 1  # and that of the step
    assert (counted["decimals"], counted["long"], counted["nearly"]) == (2, 1, 1)
    assert counted["axis x"]
    assert not counted["coordinates"]


def angle(number: float, expression: Expression | None = None) -> Value:
    return Value(None, "angle", number, expression)


def test_a_sum_that_gives_a_known_angle() -> None:
    phi, half = angle(60.0), Constant(180.0, "angle")
    beside = angle(120.0, half - phi)
    assert solution_texts.reproduces(angle(60.0, half - beside), [60.0])
    assert solution_texts.reproduces(angle(60.0, half - Constant(120.0, "angle")), [60.0])
    assert not solution_texts.reproduces(angle(60.0, half - beside), [30.0])
    assert not solution_texts.reproduces(angle(60.0, Constant(60.0)), [60.0])


def test_an_angle_that_equals_a_given_one_by_its_number_alone_is_worked_out() -> None:
    phi, alpha = angle(45.0), angle(90.0)
    assert not solution_texts.reproduces(angle(45.0, Constant(90.0, "angle") - phi), [45.0])
    assert not solution_texts.reproduces(angle(45.0, alpha - phi), [45.0, 90.0])
    assert not solution_texts.reproduces(angle(30.0, angle(120.0) - Constant(90.0, "angle")), [30.0, 120.0])


def test_shares_are_of_what_they_are_shares_of() -> None:
    row = {"long": 1.0, "decimals": 4.0, "minus": 0.0, "unknown": 0.0, "figures": 2.0, "axis x": 0.5}
    assert [solution_texts.shown(row, key) for key in ("long", "minus", "axis x", "figures")] == [25.0, 0.0, 50.0, 2.0]


def test_a_quantity_that_nothing_uses_is_counted() -> None:
    rows = solution_texts.rows(["wedge_and_rod"], 1)
    assert set(rows) == {f"wedge_and_rod {form}, {name}" for form in ("vertical", "inclined") for name in ("en", "ru")}
    assert all(row["unknown"] == 4 and row["minus"] == 0 for row in rows.values())
    empty = SimpleNamespace(steps=(), answers=(), check=())
    assert solution_texts.of_steps(empty, [])["unused"] == 0


def test_figures_are_counted_as_they_are_on_paper() -> None:
    sketch = Sketch({}, 1.0)
    sketch.arrow(0j, 4 + 0j, Layer.SLIDER, head=2.6)
    short = SolutionFigure("velocities", replace(finish(sketch, {}), width=80.0), (), 0.8)
    plan = replace(short, name="velocity_plan", unit=1.25)  # 100 mm
    shown = SimpleNamespace(draw=lambda names: None, rows=lambda: ((short, plan),))
    counted = solution_texts.of_figures(shown, [])
    assert counted == {
        "figures": 2,
        "narrow": 1,
        "room left": 1,
        "small index": 1,
        "short arrows": 2,
        "misread": 0,
    }
