"""Cost of worked solutions: CPU of every stage per student of a class, and by family, beside the typesetting engine.

    python -m benchmarks.solutions [--students N] [--variants N] [--family NAME ...]

Prints Markdown tables and, run on the whole catalogue, writes them to ``benchmarks/solutions.md``. The first variant of
every form is made beforehand, so that what is worked out once for a form is not counted. Ratios within one run are
meaningful, absolute times depend on the machine.
"""

from __future__ import annotations

import argparse
import gc
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from msgspec.structs import replace

from benchmarks import exams, processes
from benchmarks.exams import FIVE_FAMILIES
from benchmarks.measure import Clock, machine_line, write_beside
from benchmarks.sheets import drawn_sheets
from variantgen.builder import build
from variantgen.exam.content import Content, PosedProblem, Written, with_figures
from variantgen.exam.exam import Exam
from variantgen.exam.exam_file import read_exam
from variantgen.exam.roster import numbered
from variantgen.exam.sheets import Sheet, solve_all
from variantgen.families.reading.folders import family_names
from variantgen.figure.build import draw_statement
from variantgen.figure.drawing import Drawing
from variantgen.figure.making import all_made
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.outputs.documents.key_data import key_by_problem, key_by_student
from variantgen.outputs.documents.sheet_data import sheets_data
from variantgen.outputs.documents.solution_data import problem_data, solutions_data
from variantgen.outputs.formats import STUDENTS_PER_PART
from variantgen.outputs.typst.markup import Lettered
from variantgen.outputs.typst.sheet_pages import with_pages
from variantgen.outputs.typst.typesetter import Typesetter, typesetter
from variantgen.outputs.typst.writing import TYPST
from variantgen.wording.solution.explain import written
from variantgen.wording.statement import statement

SOLVING, METHODS, TEXT, FIGURES, DATA, JSON = "solving again", "methods", "text", "figures", "data", "JSON"
STAGES = (SOLVING, METHODS, TEXT, FIGURES, DATA, JSON)
STATEMENT = "a statement figure"
SHEETS, KEY, SOLUTIONS = "sheets", "key", "solutions"
FAMILY_HEAD = """\
| family | statement figure | methods | text | figures | data, JSON | solution but Typst | in statement figures \
| Typst, sheet | Typst, solution |
|---|---|---|---|---|---|---|---|---|---|"""


def exam_of(families: Sequence[str], folder: Path) -> Exam:
    """An exam with one problem of each family, all answers asked, with full solutions."""
    return read_exam(exams.write(exams.of_families(families), folder))


def measure_solutions(exam: Exam, sheets: Sequence[Sheet], clock: Clock) -> None:
    """The stages of the solutions of some sheets, and their statement figures."""
    language = exam.explained
    items = [item for sheet in sheets for item in sheet.items]
    with clock.measuring(SOLVING):
        solved = iter(solve_all([item.variant for item in items], [item.asked for item in items]))
    made: list[dict[str, Any]] = []
    for sheet in sheets:
        places = [next(solved) for _ in sheet.items]
        with clock.measuring(STATEMENT):
            makings = [
                draw_statement(item.variant, *place, item.asked, language)
                for item, place in zip(sheet.items, places, strict=True)
            ]
            drawings = all_made(makings)
            known = {id(drawing): TYPST.figure(drawing) for drawing in drawings}
        written_of = []
        for item, place, drawing in zip(sheet.items, places, drawings, strict=True):
            with clock.measuring(METHODS):
                task = task_of(item.variant, *place, item.asked)
                found = solution(task)
            with clock.measuring(TEXT):
                text = written(task, found, language)
            posed = PosedProblem(item, statement(item.variant, item.asked, language), drawing)
            written_of.append(Written(item.variant, item.asked, place, text, posed))
        with clock.measuring(FIGURES):
            problems = with_figures(written_of, language)
        with clock.measuring(DATA):
            made += [problem_data(problem, language, TYPST, known) for problem in problems]
    with clock.measuring(JSON):
        json.dumps(made, ensure_ascii=False, separators=(",", ":"), default=_untagged)


def _untagged(item: Drawing | Lettered) -> Any:
    """What stands for drawings and letters in the data of a document on paper."""
    return item.data(letters=True) if isinstance(item, Lettered) else ""


def typesetting_cost(exam: Path, students: int) -> Clock:
    """The engine alone on the sheets, the key and the solutions of an exam, everything else being prepared."""
    plan = read_exam(exam)
    sheets = drawn_sheets(replace(plan, seed="0"), numbered(students))
    clock = Clock()
    with typesetter() as engine:
        for target, template, data in _documents(plan, sheets, engine, clock):
            with clock.measuring(target):
                engine.compile(template, data, tagged=False)
    return clock


def _documents(
    plan: Exam, sheets: Sequence[Sheet], engine: Typesetter, clock: Clock
) -> Iterator[tuple[str, str, dict[str, Any]]]:
    """What a build gives to the engine: target, template and data."""
    for i in range(0, len(sheets), STUDENTS_PER_PART):
        content = Content(plan, sheets[i : i + STUDENTS_PER_PART])
        data = sheets_data(content, TYPST)
        with clock.measuring(SHEETS):
            data = with_pages(data, engine)
        yield SHEETS, "sheets.typ", data
        yield from ((SOLUTIONS, "solutions.typ", solutions_data(content, n, TYPST)) for n in range(len(content.sheets)))
    for data in (key_by_student, key_by_problem):
        yield from ((KEY, "key.typ", data(plan, sheets[i : i + 40], i == 0, TYPST)) for i in range(0, len(sheets), 40))


def in_fresh_process(task: str, exam: Path, students: int) -> Clock:
    """What :func:`typesetting_cost` or :func:`building_cost` measure (the engine remembers what it has laid out)."""
    command = [
        sys.executable,
        "-m",
        "benchmarks.solutions",
        "--only",
        task,
        "--exam",
        str(exam),
        "--students",
        str(students),
    ]
    done = subprocess.run(command, check=True, capture_output=True, text=True, env=processes.environment())
    return Clock(json.loads(done.stdout))


def building_cost(exam: Path, students: int) -> Clock:
    """A whole build."""
    clock = Clock()
    with tempfile.TemporaryDirectory() as folder, clock.measuring("build"):
        build(exam, numbered(students), Path(folder) / "out")
    return clock


def class_table(students: int) -> list[str]:
    """What a class costs, by stage, in milliseconds of CPU for each student."""
    clock = Clock()
    with tempfile.TemporaryDirectory() as name:
        exam = exam_of(FIVE_FAMILIES, Path(name))
        sheets = drawn_sheets(replace(exam, seed="0"), numbered(students))
        measure_solutions(exam, sheets[:1], Clock())
        with clock.measuring("drawing variants, answers, confirmation"):
            drawn_sheets(replace(exam, seed="0"), numbered(students))
        with clock.measuring("text and figures of the sheets"):
            sheets_data(Content(exam, sheets), TYPST)
        measure_solutions(exam, sheets, clock)
        engine = in_fresh_process("typesetting", exam.path, students)
        whole = in_fresh_process("building", exam.path, students)["build"]
    clock["solutions but for Typst"] = sum(clock[stage] for stage in STAGES)  # type: ignore[assignment]
    clock |= Clock({f"Typst alone, {target}": engine[target] for target in (SHEETS, KEY, SOLUTIONS)})
    clock["Typst alone, all"] = engine.total()
    clock["whole build"] = whole
    clock[STATEMENT] /= len(FIVE_FAMILIES)  # type: ignore[assignment]
    rows = [f"| {stage} | {value / students:.2f} |" for stage, value in clock.items()]
    ratios = [
        "",
        f"The whole build takes {whole / engine.total():.2f} times the CPU of Typst alone on the same input; solutions "
        f"but for Typst take {clock['solutions but for Typst'] / clock[STATEMENT]:.1f} statement figures a student.",
    ]
    return ["| stage | CPU per student, ms |", "|---|---|", *rows, *ratios]


def family_row(family: str, variants: int) -> str:
    """One line of the table by family, in milliseconds of CPU for each problem."""
    clock = Clock()
    with tempfile.TemporaryDirectory() as name:
        exam = exam_of([family], Path(name))
        sheets = drawn_sheets(replace(exam, seed="0"), numbered(variants))
        known = {item.variant.form.name: sheet for sheet in sheets for item in sheet.items}
        measure_solutions(exam, list(known.values()), Clock())
        measure_solutions(exam, sheets, clock)
        engine = in_fresh_process("typesetting", exam.path, variants)
    whole = sum(clock[stage] for stage in STAGES)
    values = [clock[STATEMENT], clock[METHODS], clock[TEXT], clock[FIGURES], clock[DATA] + clock[JSON], whole]
    cells = [f"{value / variants:.2f}" for value in values]
    cells += [f"{whole / clock[STATEMENT]:.2f}", *(f"{engine[t] / variants:.1f}" for t in (SHEETS, SOLUTIONS))]
    return f"| {family} | {' | '.join(cells)} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--students", type=int, default=100)
    parser.add_argument("--variants", type=int, default=24, help="of each family")
    parser.add_argument("--family", nargs="*", help="only these, without the class")
    parser.add_argument("--only", choices=("typesetting", "building"), help=argparse.SUPPRESS)
    parser.add_argument("--exam", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    gc.disable()  # as a build does: a search of all objects would be counted to whatever is measured at that moment
    if options.only:
        cost = typesetting_cost if options.only == "typesetting" else building_cost
        print(json.dumps(cost(options.exam, options.students)))
        return
    note = f"{options.students} students, {options.variants} variants of a family, {machine_line()}"
    lines = [f"# Worked solutions, their cost\n\n`python -m benchmarks.solutions`: {note}.", ""]
    if options.family is None:
        lines += [*class_table(options.students), ""]
    lines.append(FAMILY_HEAD)
    print(*lines, sep="\n", flush=True)
    for name in family_names() if options.family is None else options.family:
        lines.append(family_row(name, options.variants))
        print(lines[-1], flush=True)
    if options.family is None:
        write_beside(__file__, lines)


if __name__ == "__main__":
    main()
