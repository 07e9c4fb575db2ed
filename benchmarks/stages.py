"""CPU of a build by stage: where the time goes.

    python -m benchmarks.stages RESULT.json build EXAM.toml ...     # one command of the program, by stage

The build runs in a process of its own with clocks around the functions of :data:`HOOKS`. They cost little; the same
build without them is measured beside it.
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from benchmarks import exams, processes
from benchmarks.hooks import IMPORTS, Hook, StageClock, around, around_imports
from benchmarks.measure import Table
from benchmarks.options import Options

TITLE = "CPU by stage"
START, REST, END = "starting Python", "other", "ending Python"
ALL, BARE = "all", "the same build without clocks"

_DRAW, _ANSWERS, _SOLVE = "drawing candidates, screens", "answers, tolerances, mistakes", "solving"
_DATA, _JSON, _RECORDS = "data of documents", "JSON", "key.csv, manifest, hashes"
_PARTS = "keeping finished parts"

# The only place where the benchmarks name functions of the program besides its command line and the engine.
HOOKS = (
    Hook("reading the exam", "variantgen.outputs.formats:read_exam", whole=True),
    Hook("reading the exam", "variantgen.outputs.typst.coverage:check_letters", whole=True),
    Hook(_DRAW, "variantgen.exam.allocation:ProblemSampler.variants"),
    Hook("equally hard variants: samples", "variantgen.exam.work.work_samples:drawn_sample", whole=True),
    Hook("equally hard variants: work", "variantgen.exam.work.work_samples:variant_answers", whole=True),
    Hook("keeping variants distinct", "variantgen.exam.allocation:resolve_duplicates", whole=True),
    Hook("keeping variants distinct", "variantgen.variants.similarity:traits", whole=True),
    Hook("verifying", "variantgen.variants.screening:verification", whole=True),
    Hook(_SOLVE, "variantgen.mechanism.solving.solve:solve"),
    Hook(_SOLVE, "variantgen.mechanism.solving.solve:add_speeds"),
    Hook(_ANSWERS, "variantgen.exam.answer_tolerances:AnswerTolerances.__call__", whole=True),
    Hook(_ANSWERS, "variantgen.exam.answer_tolerances:AnswerTolerances.tolerances", whole=True),
    Hook(_ANSWERS, "variantgen.exam.answer_tolerances:AnswerTolerances.unnoticed", whole=True),
    Hook(_ANSWERS, "variantgen.exam.sheets:_answers"),
    Hook("confirming", "variantgen.methods.hand.confirmation:confirm_answers", whole=True),
    Hook("confirming", "variantgen.methods.agreement:confirm", whole=True, apart=True),
    Hook("statement text", "variantgen.wording.statement:statement", whole=True),
    Hook("figures: geometry", "variantgen.figure.making:all_made"),
    Hook("figures: labels", "variantgen.figure.placement.labels:place_labels", whole=True),
    Hook("figures: text in words", "variantgen.figure.alt_text.description:describe", whole=True),
    Hook("solutions: methods", "variantgen.methods.linkage.problem:task_of", whole=True),
    Hook("solutions: methods", "variantgen.methods.compose:solution", whole=True),
    Hook("solutions: text", "variantgen.wording.solution.explain:written", whole=True),
    Hook("solutions: figures", "variantgen.exam.solution_figures:draw_together", whole=True),
    Hook(_DATA, "variantgen.outputs.documents.sheet_data:sheets_data"),
    Hook(_DATA, "variantgen.outputs.documents.key_data:key_by_student"),
    Hook(_DATA, "variantgen.outputs.documents.key_data:key_by_problem"),
    Hook(_DATA, "variantgen.outputs.documents.solution_data:solutions_data"),
    Hook(_DATA, "variantgen.outputs.typst.writing:figure_data"),
    Hook(_JSON, "variantgen.outputs.typst.typesetter:_json"),
    Hook("pages of the sheets", "variantgen.outputs.typst.sheet_pages:with_pages"),
    Hook("Typst: {}", "variantgen.outputs.typst.typesetter:Typesetter.query"),
    Hook("Typst: {}", "variantgen.outputs.typst.typesetter:Typesetter.compile"),
    Hook("joining", "variantgen.outputs.join:join_pdfs", whole=True),
    Hook(_PARTS, "variantgen.exam.packing:pack", whole=True),
    Hook(_PARTS, "variantgen.exam.packing:unpack", whole=True),
    Hook(_PARTS, "variantgen.builder.kept:KeptParts.put_made", whole=True),
    Hook(_PARTS, "variantgen.builder.kept:KeptParts.made", whole=True),
    Hook(_RECORDS, "variantgen.outputs.files.records:key_rows", whole=True),
    Hook(_RECORDS, "variantgen.outputs.files.records:manifest_lines", whole=True),
    Hook(_RECORDS, "variantgen.outputs.files.records:write_records"),
    Hook(_RECORDS, "variantgen.outputs.files.folder:file_hashes", whole=True),
)


@dataclass
class Case:
    """One build: seconds by stage of the best round (with all that the system counts), and without clocks."""

    exam: str
    solutions: bool
    students: int
    stages: dict[str, float] = field(default_factory=dict)
    bare: float = float("inf")

    @property
    def title(self) -> str:
        """The head of its column."""
        return f"{self.exam}, {'with solutions' if self.solutions else 'sheets and key'}, {self.students}"

    def measure(self) -> None:
        """One more round."""
        with tempfile.TemporaryDirectory(prefix="stages-") as name:
            folder = Path(name)
            exam, result = exams.write(exams.EXAMS[self.exam], folder), folder / "stages.json"
            arguments = exams.build_arguments(exam, self.students, self.solutions, folder / "out")
            self.bare = min(self.bare, processes.run([*processes.PROGRAM, *arguments]).cpu)
            ran = processes.run([sys.executable, "-m", "benchmarks.stages", str(result), *arguments])
            spent: dict[str, float] = json.loads(result.read_text("utf-8"))
        spent[END] = ran.cpu - sum(spent.values())
        if not self.stages or ran.cpu < sum(self.stages.values()):
            self.stages = spent


def cases(options: Options) -> list[Case]:
    """What is built."""
    if options.quick:
        return [Case(exam, True, 1) for exam in list(exams.EXAMS)[-1:]]
    sheets = sorted({min(size, options.students) for size in (100, 1000)})
    found = [Case(exam, False, size) for exam in exams.EXAMS for size in sheets]
    return found + [Case(exam, True, min(100, options.solutions)) for exam in exams.EXAMS]


def run(options: Options) -> list[Table]:
    """Measure all cases in interleaved rounds."""
    every = cases(options)
    for turn in range(options.rounds):
        for case in every:
            case.measure()
            print(f"round {turn + 1}: {case.title}: {case.bare:.2f} s", flush=True)
    return [table(every)]


def table(every: Sequence[Case]) -> Table:
    """Milliseconds per student by stage and case."""
    order = list(dict.fromkeys([START, IMPORTS, *(hook.stage for hook in HOOKS)]))
    found = dict.fromkeys(stage for case in every for stage in case.stages)
    named = [stage for stage in order if stage in found]
    typeset = [stage for stage in found if stage not in {*order, REST, END}]
    place = named.index(_JSON) + 1
    lines = [*named[:place], *typeset, *named[place:], REST, END]
    result = Table(
        "CPU by stage, ms per student",
        ("stage", *(case.title for case in every)),
        "A stage is its own time, without the stages inside it; one process, best of the rounds. Tolerances, solutions "
        "and the second computation are counted with all that they call, other solving apart. All stages together are "
        f"{', '.join(f'{sum(case.stages.values()) / case.bare:.2f}' for case in every)} of the same build without "
        "clocks.",
    )
    for stage in lines:
        result.add(stage, *(_each(case.stages.get(stage, 0.0), case) for case in every))
    result.add(ALL, *(_each(sum(case.stages.values()), case) for case in every))
    result.add(BARE, *(_each(case.bare, case) for case in every))
    return result


def _each(seconds: float, case: Case) -> float:
    return 1e3 * seconds / case.students


def clocked(arguments: Sequence[str], start: float) -> dict[str, float]:
    """Run a command of the program in this process: CPU seconds by stage, that of starting Python being known."""
    clock = StageClock(REST, start)
    around_imports(clock)
    around(HOOKS, clock)
    from variantgen.cli import main

    if main(list(arguments)):
        raise SystemExit("the build failed")
    return {START: start, **clock.finish()}


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(json.dumps(clocked(sys.argv[2:], time.process_time())), "utf-8")
