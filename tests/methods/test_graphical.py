"""Solutions by plans: the readings of the source, agreement with the solver, the drawn plan under a ruler."""

from __future__ import annotations

import math
import re
from functools import cache
from itertools import pairwise
from typing import ClassVar

import pytest
from msgspec.structs import replace

from tests.calculator import evaluate
from tests.figure.reading import arrows, variants_of
from tests.methods.applying import APPLYING
from tests.solved_cases import case_of, task
from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.families.quantities import parse_quantity
from variantgen.figure.drawing import Layer
from variantgen.figure.motion.motion_data import MovingMechanism, motion_data
from variantgen.figure.motion.plans import COINCIDENT, scale_of_plan, without_millimetres
from variantgen.figure.motion.vectors import vectors_of
from variantgen.figure.views import acceleration_plan, velocity_plan
from variantgen.methods.agreement import deviation
from variantgen.methods.compose import solution
from variantgen.methods.graphical import graphical
from variantgen.methods.graphical.plan_scale import MILLIMETRES, per_millimetre, pole_letter
from variantgen.methods.graphical.vector_chain import VectorChain
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Derived, Sentence, Solution
from variantgen.single import one_variant
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import Equation, Measured, Symbol, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import FormulaLine, FormulaLines
from variantgen.wording.solution.explain import written
from variantgen.wording.solution.formulas import Formulas
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.solution.quantity_symbols import Symbols
from variantgen.wording.solution.writer import Writer

EN = load_language("en")
SEEDS = 2
VIEWS = (
    (1, velocity_plan, velocity_plan.velocity_plan),
    (2, acceleration_plan, acceleration_plan.acceleration_plan),
)
RULER = 0.15  # mm
TENTH = 0.1  # mm, the last digit of a length on paper


@cache
def tasks(name: str, form: str) -> list[Task]:
    variants, motion, asked = variants_of(name, form, SEEDS)
    return [task_of(variant, motion, i, asked) for i, variant in enumerate(variants)]


def readings(found: Solution) -> list[Value]:
    """All lengths that are measured on the plans."""
    sentences = [item for step in found.steps for item in step.items if isinstance(item, Sentence)]
    return [value for s in sentences if isinstance(value := s.facts.get("reading"), Value)]


class TestProblem28:
    """Kirsanov, problem 28; exact values recomputed with 80 digits (the source rounds OD = 19.95 to 20)."""

    EXACT: ClassVar = {
        ("v", "B", "", ""): 109.74133,
        ("v", "B", "A", ""): 1.2357815 * 111,
        ("v", "D", "", "rel"): 58.557863,
        ("v", "D", "B", ""): 0.54685059 * 99.3,
        ("a", "B", "", ""): 380.06719,
        ("a", "B", "", "tau"): 5.9749754 * 43,
        ("a", "D", "", "rel"): 465.93779,
    }
    PRINTED: ClassVar = {("v", "B", "", ""): 109.7, ("v", "B", "A", ""): 137.2, ("v", "D", "", "rel"): 58.4}

    @cache  # noqa: B019 - one solution for all tests of the class
    def found(self) -> Solution:
        return solution(task(*case_of("four_bar_with_sleeve", "K28")), ["graphical"])

    def test_readings_are_those_of_a_ruler(self) -> None:
        scales = {"v": 2.5, "a": 15.0}  # 1 mm = 2.5 cm/s: the plan is 48 mm wide; 1 mm = 15 cm/s^2: 49 mm high
        read = {(v.name.body, v.name.of, v.name.about, v.name.part): v.shown for v in readings(self.found()) if v.name}
        assert set(read) >= set(self.EXACT)
        for key, exact in self.EXACT.items():
            assert read[key] == pytest.approx(exact / scales[key[0]], abs=0.0501), key
            assert read[key] == round(read[key], 1)

    def test_results_are_those_of_the_source(self) -> None:
        lines = [item.value for step in self.found().steps for item in step.items if isinstance(item, Derived)]
        values = {(v.name.kind, v.name.of, v.name.about, v.name.part): v.shown for v in lines if v.name}
        for key, printed in self.PRINTED.items():
            # The source's reading error and that of a plan where 1 mm stands for 2.5 cm/s.
            assert values[key] == pytest.approx(printed, abs=0.05 * 2.5 + 0.2), key

    def test_the_sleeve_is_measured_in_the_drawn_mechanism(self) -> None:
        lines = [item.value for item in self.found().steps[0].items if isinstance(item, Derived)]
        (length,) = [value for value in lines if value.name and value.name.kind == "length"]
        assert length.shown == pytest.approx(19.951603, abs=0.05)

    def test_the_answer_is_approximate(self) -> None:
        case = task(*case_of("four_bar_with_sleeve", "K28"))
        text = "".join(p if isinstance(p, str) else to_plain(p) for p in written(case, self.found(), EN).answer)
        assert "approximately" in text
        assert "a_B = 380\N{NO-BREAK SPACE}cm/s" in text


@pytest.mark.parametrize(("name", "form"), APPLYING["graphical"])
def test_plans_agree_with_the_solver(name: str, form: str) -> None:
    for item in tasks(name, form):
        book = Book(item)
        graphical.solve(book)
        assert book.velocity
        assert deviation(book) < 1e-9


@pytest.mark.parametrize(("name", "form"), APPLYING["graphical"])
def test_a_ruler_on_the_printed_plan_gives_the_readings(name: str, form: str) -> None:
    for item in tasks(name, form):
        variants, motion, asked = variants_of(name, form, SEEDS)
        index = variants.index(item.variant)
        symbols = Symbols(item.form, EN, load_phrases("en"), {})
        everything = readings(solution(item, ["graphical"]))
        for order, module, make in VIEWS[: item.order]:
            mechanism = MovingMechanism(item.variant, motion, index, asked, EN)
            state = motion_data(mechanism, order)
            plan = make(state, vectors_of(mechanism, order, methods=("graphical",)))
            drawing = module.draw(item.variant, motion, index, asked, EN)
            lengths = [end - start for start, end in arrows(drawing, Layer.VECTOR)]
            for value in drawn(everything, "va"[order - 1], item, state.chain):
                wanted = symbol_of(symbols, value.name)
                parts = [v for v in plan.vectors if v.symbol == wanted]
                # A vector that is drawn as two components is measured from the start of one to the end of the other.
                parts = parts or [v for v in plan.vectors if v.symbol._replace(part=()) == wanted]
                # One that is given bears the letter of the data.
                if name == "point_on_rotating_disc" and value.name and value.name.part == "rel":
                    parts += [v for v in plan.vectors if to_plain(v.symbol) == "a_t"]
                assert parts, wanted
                steps = [drawing.scale * (v.end - v.start) for v in parts]
                assert abs(abs(sum(steps)) * MILLIMETRES - value.shown) < RULER
                for step in steps:
                    assert abs(step) < COINCIDENT or min(abs(length - step) for length in lengths) < COINCIDENT, wanted


def drawn(values: list[Value], letter: str, item: Task, chain: VectorChain) -> list[Value]:
    """Readings of one plan that the figure shows as arrows.

    Projections are none; hidden points and contacts of rolling wheels are left out there, and what is too short.
    """
    shown, poles = shown_points(item.variant, item.asked), {"", *chain.points}
    own = [(v, v.name) for v in values if v.name and v.name.body == letter and v.shown > COINCIDENT * MILLIMETRES]
    return [v for v, n in own if n.of in shown and n.about in poles and not {"x", "y"} & set(n.part.split())]


def symbol_of(symbols: Symbols, name: Name | None) -> Symbol:
    """The symbol of the vector whose length on the plan has this name."""
    assert name is not None
    return symbols.of(replace(name, kind=name.body, body=""))


@pytest.mark.parametrize(("name", "form"), APPLYING["graphical"])
def test_text_and_figure_have_one_scale(name: str, form: str) -> None:
    for item in tasks(name, form):
        variants, motion, asked = variants_of(name, form, SEEDS)
        index = variants.index(item.variant)
        for order in range(1, item.order + 1):
            plan = graphical.begun(item, "va"[order - 1])
            state = motion_data(MovingMechanism(item.variant, motion, index, asked, EN), order)
            assert float(scale_of_plan(state.chain, state.now, order, state.unit).value) == plan.scale.exact
    if tasks(name, form):
        drawing = velocity_plan.draw(item.variant, motion, index, asked, EN)
        scale = graphical.begun(item, "v").scale.exact
        stated = [label.formula for label in drawing.labels if isinstance(label.formula, Equation)]
        texts = [e for e in stated if isinstance(e.left, Measured) and isinstance(e.right, Measured)]
        assert [float(e.right.number.text) for e in texts if isinstance(e.right, Measured)] == [scale]


@pytest.mark.parametrize(("name", "form"), APPLYING["graphical"])
def test_a_calculator_follows_the_numbers(name: str, form: str) -> None:
    for item in tasks(name, form):
        writer = writer_of(item)
        checked = 0
        for step in solution(item, ["graphical"]).steps:
            for block in writer.blocks([line for line in step.items if isinstance(line, Derived)]):
                assert isinstance(block, FormulaLines)
                for line in block.lines:
                    checked += recomputed(line)
        assert checked


def writer_of(item: Task) -> Writer:
    phrases = load_phrases("en")
    symbols = Symbols(item.form, EN, phrases, {body: Symbol("P") for body in item.form.bodies})
    return Writer(symbols, Formulas(symbols, item.variant.family.length_unit))


def recomputed(line: FormulaLine) -> int:
    """Checks the numbers of ``name = symbols = numbers = result``; how many formulas there were."""
    *pieces, last = [formula for _, formula in line.pieces]
    assert isinstance(last, Measured)
    result = float(last.number.text.replace("−", "-"))
    unit = TENTH if last.unit.parts == (("mm", 1),) else fourth_digit(result)
    # A law may come down to a symbol, as the tangential acceleration of a wheel to that of its axle: that is no number.
    numbers = [text for text in map(to_plain, pieces[2:]) if not re.fullmatch(r"\(?[av][_^]\S+", text)]
    for text in numbers:
        assert abs(evaluate(text, {}, ".") - result) <= unit * (1 + 1e-9), text
    return len(numbers)


def fourth_digit(value: float) -> float:
    """One unit of the fourth significant digit."""
    return 10.0 ** (math.floor(math.log10(abs(value))) - 3) if value else 0.0


def test_components_are_measured() -> None:
    variant = one_variant("four_bar", {}, seed="3")
    motion = solve_variants([variant], 2)
    asked = [parse_quantity(text, variant.form.sample) for text in ("v_B.x", "v_B.y", "a_B.x", "v_A", "omega_AB")]
    item = task_of(variant, motion, 0, asked)
    found = solution(item, ["graphical"])
    for quantity, (_, value) in zip(asked, found.answers, strict=True):
        wanted = quantity.unit("cm").from_si(float(quantity.value(motion)[0]))
        largest = max(abs(complex(v[0])) for v in (motion.v if quantity.order == 1 else motion.a).values())
        scale = largest / 0.01 if quantity.is_vector else abs(wanted)
        assert value.exact == pytest.approx(wanted, abs=1e-9 * scale)
        assert value.shown == pytest.approx(wanted, abs=0.01 * scale)


def test_a_plan_of_another_size_does_not_speak_of_millimetres() -> None:
    item = tasks("four_bar", "crank")[0]
    variants, motion, asked = variants_of("four_bar", "crank", SEEDS)
    drawing = velocity_plan.draw(item.variant, motion, variants.index(item.variant), asked, EN)
    left = without_millimetres(drawing)
    gone = [to_plain(label.formula) for label in drawing.labels if label not in left.labels]
    assert len(gone) == 1
    assert gone[0].replace("\N{NO-BREAK SPACE}", " ").startswith("1 mm = ")


def test_scales_are_round_and_fill_the_room() -> None:
    # 120 cm/s to the right: 64 mm of room, 1.875 cm/s per mm; the next round scale is 2.
    assert per_millimetre([0j, 120 + 0j]) == 2
    assert per_millimetre([0j, 64j]) == pytest.approx(1.5)  # 56 mm of height: 1.14
    assert per_millimetre([0j, 64 + 0j]) == 1  # exactly the room
    assert per_millimetre([-100 + 0j, 100j, 540 + 0j]) == 10
    steps = [float(per_millimetre([0j, complex(x)])) for x in range(64, 641, 8)]
    assert all(a <= b for a, b in pairwise(steps))
    assert set(steps) <= {1, 1.5, 2, 2.5, 4, 5, 7.5, 10}


def test_the_pole_has_a_letter_of_its_own() -> None:
    assert pole_letter(["A", "B"]) == "o"
    assert pole_letter(["A", "O"]) == "p"
    assert pole_letter(["O", "P"]) == "q"
