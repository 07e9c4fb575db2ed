"""Fair variants: work is counted as a reader would, and everyone's lies in the band of the form."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from benchmarks.sheets import drawn_sheets
from variantgen.algebra.expression import Constant, SquareRoot, Value, cos
from variantgen.algebra.linear import LinearSolution
from variantgen.algebra.name import Name
from variantgen.errors import InputError
from variantgen.exam.allocation import ProblemSampler
from variantgen.exam.exam import Exam
from variantgen.exam.exam_file import parse_exam
from variantgen.exam.packing import pack, unpack
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.exam.work.fairness import band_of, shortages, uneven_pools
from variantgen.exam.work.kept_work import WorkSample
from variantgen.families.quantities import motion_order
from variantgen.methods.compose import solution
from variantgen.methods.hand.work import Work, work_of
from variantgen.methods.linkage.problem import task_of
from variantgen.variants.variant import solve_variants

CLASS = [Student(f"s{i}", f"N{i}", "M-1") for i in range(16)]
CAM = '[[problem]]\nfamily = "cam_disc"\nform = "flat"\n'


def exam(head: str = "", problems: str = CAM) -> Exam:
    return parse_exam(f'title = "T"\nlanguage = "en"\nseed = 5\n{head}\n{problems}', Path("exam.toml"), ())


def spread(sheets: tuple[Sheet, ...]) -> tuple[float, int]:
    """Most over fewest operations of the written solutions, and by how much their negative numbers differ."""
    works = []
    for item in (sheet.items[0] for sheet in sheets):
        motion = solve_variants([item.variant], motion_order(item.asked))
        written = solution(task_of(item.variant, motion, 0, item.asked))
        works.append(work_of(value for _, value in written.answers))
    operations, negatives = [work.operations for work in works], [work.negatives for work in works]
    return max(operations) / min(operations), max(negatives) - min(negatives)


def derived(expression: object, measure: str = "velocity", name: Name | None = None) -> Value:
    return Value(name, measure, expression.number(True), expression)  # type: ignore[attr-defined,arg-type]


def test_the_work_of_a_calculation_by_hand() -> None:
    """``u = 3 cos 120 + 1 = -0.5``, ``w = sqrt(u^2)``, ``a_cor = 2 u w``: counted with a pencil."""
    r, phi = Value(None, "length", 3.0), Value(None, "angle", 120.0)
    u = derived(r * cos(phi) + Constant(1.0))  # a product, a sum, a cosine; the cosine and u are negative
    w = derived(SquareRoot(u**2))  # a power, a root
    coriolis = derived(Constant(2.0) * u * w, "acceleration", Name("a", "B", part="cor"))  # two products; negative
    assert work_of([coriolis, w]) == Work(
        lines=3, operations=5, functions=2, systems=0, negatives=3, obtuse=1, coriolis=1
    )


def test_a_system_counts_once_with_its_elimination() -> None:
    """``x + 2 y = 5``, ``3 x + 4 y = 11``: a factor, two products and two differences, then y (a quotient) and x (a
    product, a difference, a quotient): nine operations.
    """
    one, two, three, four = (Constant(float(n)) for n in (1, 2, 3, 4))
    rows, right = ((one, two), (three, four)), (Constant(5.0), Constant(11.0))
    x, y = (derived(LinearSolution(rows, right, i)) for i in (0, 1))
    assert (x.exact, y.exact) == (pytest.approx(1.0), pytest.approx(2.0))
    assert work_of([x, y]) == Work(lines=2, operations=9, functions=0, systems=1, negatives=0, obtuse=0, coriolis=0)


def works(*counts: tuple[int, int, int]) -> WorkSample:
    """So many works of calculations with so many negative numbers: (count, calculations, negatives)."""
    return WorkSample(Counter({(size, negatives, 0): count for count, size, negatives in counts}), 48)


def test_the_band_is_the_fullest_of_its_width() -> None:
    found = band_of(works((3, 20, 0), (14, 40, 0), (12, 41, 2), (2, 41, 3), (9, 43, 1)), 0.05, 10_000)
    # From 40, five per cent lead to 42; three negative numbers are too far from none.
    assert (found.calculations, found.negatives, found.widened) == ((40, 42), (0, 2), False)
    assert found.share == 26 / 40
    assert (found.room, found.of) == (6500, 10_000)
    assert Work(9, 30, 12, 0, 2, 0, 0) in found
    for other in (Work(9, 30, 13, 0, 2, 0, 0), Work(9, 30, 12, 0, 3, 0, 0), Work(9, 30, 12, 0, 2, 3, 0)):
        assert other not in found


def test_too_little_room_is_said() -> None:
    every = works((20, 40, 0), (20, 43, 0))
    wide = band_of(every, 0.05, 1500)  # half of them are too few, ten per cent more leave all
    assert (wide.calculations, wide.widened, wide.room) == ((40, 44), True, 1500)
    none = band_of(every, 0.05, 900)
    assert none.calculations is None
    assert Work(9, 99, 0, 0, 9, 9, 0) in none
    assert shortages({(1, "f", "g"): wide, (2, "h", ""): none, (3, "i", ""): band_of(every, 0.1, 5000)}) == [
        "problem[1]: f g: variants of 40 to 44 calculations, as narrower leaves too few of 1500",
        "problem[2]: h: some 900 variants, too few to choose equally hard ones",
    ]


def test_fair_variants_take_the_same_work_and_others_do_not() -> None:
    chance, negatives = spread(drawn_sheets(exam("fair = false"), CLASS))
    assert chance > 1.5
    cams = exam()
    fair = drawn_sheets(cams, CLASS)
    ratio, negatives = spread(fair)
    assert ratio <= 1.05
    assert negatives <= 2
    assert all(sheet.items[0].work is not None for sheet in fair)
    packed = pack(cams, [sheet.items[0] for sheet in fair])
    assert [item.work for item in unpack(cams, packed)] == [sheet.items[0].work for sheet in fair]


def test_a_variant_depends_on_no_other_student_and_no_other_problem() -> None:
    alone = {sheet.student.id: sheet.items[0].variant.printed for sheet in drawn_sheets(exam(), CLASS[::3])}
    both = drawn_sheets(exam(problems=CAM + '[[problem]]\nfamily = "spool"\n'), CLASS)
    assert {sheet.student.id: sheet.items[0].variant.printed for sheet in both if sheet.student.id in alone} == alone


def test_a_problem_with_few_variants_is_drawn_without_a_band() -> None:
    """A grid of 3 x 4 x 5 points: fewer than a thousand, whatever their work."""
    ranges = "range = { OA = [20, 24], AB = [60, 66], phi = [40, 60], omega_OA = [2, 2], epsilon_OA = [2, 2] }\n"
    few = exam(problems=f'[[problem]]\nfamily = "slider_crank"\nform = "central"\n{ranges}')
    (band,) = ProblemSampler(few).bands().values()
    assert band.calculations is None
    assert band.of < 1000
    assert len({str(sheet.items[0].variant.printed) for sheet in drawn_sheets(few, CLASS[:6])}) == 6


POOL = '[[problem]]\nfamilies = ["spool", "rolling_wheel"]\n'  # 18 and 30 calculations, both counted on paper


@pytest.mark.parametrize("wish", ["work = [15, 20]", "work = [25, 32]", 'level = "easy"'])
def test_work_chooses_the_members_of_a_pool(wish: str) -> None:
    sheets = drawn_sheets(exam(problems=POOL + wish), CLASS[:8])
    drawn = {sheet.items[0].variant.family.name for sheet in sheets}
    assert drawn == {"[15, 20]": {"spool"}, "[25, 32]": {"rolling_wheel"}}.get(wish[7:], {"spool", "rolling_wheel"})


def test_a_pool_without_such_a_form_is_told() -> None:
    with pytest.raises(InputError) as caught:
        drawn_sheets(exam(problems=POOL + 'level = "hard"'), CLASS[:2])
    (problem,) = caught.value.problems
    assert (problem.key, problem.value) == ("problem[1].level", "hard")
    assert problem.message == "no form has enough variants of 47 or more calculations"
    assert "spool 18, rolling_wheel 30" in problem.remedy


def test_members_that_are_not_comparable_are_named() -> None:
    bands = {(2, name, ""): band_of(works((9, size, 0)), 0.05, 5000) for name, size in (("a", 40), ("b", 20))}
    assert uneven_pools({(1, "c", ""): next(iter(bands.values())), **bands}) == [
        "problem[2]: its variants are not comparable in work (calculations): b 20.5, a 41;"
        " form, level or work chooses comparable ones"
    ]
    assert uneven_pools({key: band_of(works((9, 30, 0)), 0.05, 5000) for key in bands}) == []


@pytest.mark.parametrize(
    ("line", "key"),
    [
        ("work = 20", "problem[1].work"),
        ("work = [20]", "problem[1].work"),
        ("work = [0, 20]", "problem[1].work"),
        ("work = [20, 10001]", "problem[1].work"),
        ("work = [30, 20]", "problem[1].work"),
        ("work = [1.5, 20]", "problem[1].work"),
        ('level = "simple"', "problem[1].level"),
        ('level = "easy"\nwork = [1, 2]', "problem[1].level"),
    ],
)
def test_wrong_work_is_told(line: str, key: str) -> None:
    with pytest.raises(InputError) as caught:
        exam(problems=CAM + line)
    assert [problem.key for problem in caught.value.problems] == [key]


@pytest.mark.parametrize("value", ["0", "-0.1", "1.5", '"yes"', "nan"])
def test_a_wrong_width_is_told(value: str) -> None:
    with pytest.raises(InputError) as caught:
        exam(f"fair = {value}")
    assert any(problem.key == "fair" for problem in caught.value.problems)
