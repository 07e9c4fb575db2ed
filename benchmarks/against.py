"""CPU of worked solutions in two checkouts, turn by turn in one run: what a change costs or saves.

    python -m benchmarks.against OTHER [--students N] [--rounds N]

``OTHER`` is the folder of another checkout of the program. Each has a process of its own; they solve, write, draw and
typeset the solutions of the same students in turn, so that whatever else the machine does meets both. Prints the least
milliseconds of user CPU a student of several rounds by stage and the ratio, and writes them to ``against.md``.
"""

from __future__ import annotations

import argparse
import gc
import resource
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from msgspec.structs import replace

ROOT = Path(__file__).resolve().parent.parent
STAGES = ("methods", "text", "figures of motion", "data", "engine")


def serve(exam_name: str, students: int) -> None:
    """Measure one round for each line of input. Only what both checkouts have is used."""
    from benchmarks import exams
    from benchmarks.sheets import drawn_sheets
    from variantgen.exam.content import SolvedProblem
    from variantgen.exam.exam_file import read_exam
    from variantgen.exam.roster import numbered
    from variantgen.exam.sheets import solve_all
    from variantgen.exam.solution_figures import SolutionFigures, view_order
    from variantgen.figure.build import statement_figure
    from variantgen.methods.compose import solution
    from variantgen.methods.linkage.problem import task_of
    from variantgen.outputs.documents.sheet_data import exam_data, student_data
    from variantgen.outputs.documents.solution_data import problem_data, solution_words
    from variantgen.outputs.typst.typesetter import typesetter
    from variantgen.outputs.typst.writing import TYPST
    from variantgen.wording.solution.explain import written
    from variantgen.wording.statement import statement

    with tempfile.TemporaryDirectory() as folder, typesetter() as engine:
        exam = read_exam(exams.write(exams.EXAMS[exam_name], Path(folder)))
        sheets, language = drawn_sheets(replace(exam, seed="0"), numbered(students)), exam.explained
        items = [item for sheet in sheets for item in sheet.items]
        solved = solve_all([item.variant for item in items], [item.asked for item in items])
        places = {id(item): place for item, place in zip(items, solved, strict=True)}
        known = {id(i): statement_figure(i.variant, *places[id(i)], i.asked, language) for i in items}
        gc.disable()
        for _ in sys.stdin:
            spent = dict.fromkeys(STAGES, 0.0)
            for sheet in sheets:
                problems = []
                for item in sheet.items:
                    place = places[id(item)]
                    start = _cpu()
                    task = task_of(item.variant, *place, item.asked)
                    steps = solution(task)
                    spent["methods"] += (after := _cpu()) - start
                    text = written(task, steps, language)
                    spent["text"] += (start := _cpu()) - after
                    figures = SolutionFigures(item.variant, item.asked, language, place, known[id(item)], text)
                    figures.draw(view_order(text))
                    spent["figures of motion"] += (after := _cpu()) - start
                    said = statement(item.variant, item.asked, language)
                    problem = SolvedProblem(item.variant, said, text, figures.rows(), figures.numbers)
                    number = str(item.task.number)
                    problems.append({"number": number, **problem_data(problem, language, TYPST)})
                    spent["data"] += _cpu() - after
                own = [{**student_data(sheet, problems, language), "last": True}]
                data = {**exam_data(exam, language), "words": solution_words(language), "students": own}
                start = _cpu()
                engine.compile("solutions.typ", data, tagged=False)
                spent["engine"] += _cpu() - start
            gc.collect()
            print(*(1e3 * spent[stage] / students for stage in STAGES), flush=True)


def _cpu() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_utime


def measured(exam: str, checkouts: Sequence[Path], students: int, rounds: int) -> list[list[float]]:
    """The least milliseconds a student of each stage in each checkout."""
    from benchmarks.processes import environment

    servers = []
    for checkout in checkouts:
        command = [
            sys.executable,
            str(Path(__file__).resolve()),
            str(checkout),
            "--serve",
            exam,
            "--students",
            str(students),
        ]
        settings = {**environment(), "PYTHONPATH": str(checkout)}
        servers.append(
            subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=settings)
        )
    best = [[float("inf")] * len(STAGES) for _ in checkouts]
    for _ in range(rounds):
        for i, server in enumerate(servers):
            assert server.stdin is not None and server.stdout is not None
            server.stdin.write("\n")
            server.stdin.flush()
            found = [float(word) for word in server.stdout.readline().split()]
            best[i] = [min(pair) for pair in zip(best[i], found, strict=True)]
    for server in servers:
        server.communicate()
    return best


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("other", type=Path)
    parser.add_argument("--students", type=int, default=10)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--serve", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.serve:
        sys.path[0] = str(options.other)
        serve(options.serve, options.students)
        return
    from benchmarks.exams import EXAMS
    from benchmarks.measure import machine_line, write_beside

    note = f"{options.students} students, the least of {options.rounds} rounds, {machine_line()}"
    lines = [
        f"# Worked solutions beside those of another checkout\n\n`python -m benchmarks.against OTHER`: {note}.",
        "",
        "| exam | stage | other, ms a student | this, ms a student | ratio |",
        "|---|---|---|---|---|",
    ]
    for exam in EXAMS:
        before, now = measured(exam, [options.other.resolve(), ROOT], options.students, options.rounds)
        rows = [*zip(STAGES, before, now, strict=True), ("all", sum(before), sum(now))]
        lines += [f"| {exam} | {stage} | {a:.1f} | {b:.1f} | {b / a:.2f} |" for stage, a, b in rows]
        lines.append(f"| {exam} | all in engines of this | {sum(before) / now[-1]:.2f} | {sum(now) / now[-1]:.2f} | |")
    print(*lines, sep="\n")
    write_beside(__file__, lines)


if __name__ == "__main__":
    main()
