"""The programs of the coordinate method: they run by themselves and print what the solver has."""

from __future__ import annotations

import ast
import json
import subprocess
import sys

import pytest

from tests.methods.forms import FORMS, exact, tasks, variants
from variantgen.families.asking import read_ask
from variantgen.methods.coordinates import coordinates
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book
from variantgen.methods.solution_options import SolutionOptions
from variantgen.methods.steps.step import ProgramListing
from variantgen.resources import languages
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import Program
from variantgen.wording.solution.explain import explain
from variantgen.wording.solution.phrases import load_phrases

SEEDS = 2
LONGEST = 52  # lines, for a mechanism of two loops
USUAL = 44  # lines, for half of the problems at least
WIDEST = 100  # columns
BATCH = 8  # forms whose programs run in one process

# Runs programs from standard input, each by itself, and returns what they print.
RUNNER = """
import contextlib, io, json, sys
found = []
for code in json.load(sys.stdin):
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(code, "listing", "exec"), {"__name__": "__main__"})
    found.append(out.getvalue())
json.dump(found, sys.stdout)
"""


def listing(task: Task) -> str:
    book = Book(task)
    coordinates.solve(book)
    (found,) = [item for step in book.steps for item in step.items if isinstance(item, ProgramListing)]
    return found.code


def run(codes: list[str]) -> list[dict[str, float]]:
    command = [sys.executable, "-I", "-W", "error", "-c", RUNNER]
    done = subprocess.run(command, input=json.dumps(codes), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    lines = [dict(line.split(" = ") for line in text.splitlines()) for text in json.loads(done.stdout)]
    return [{name: float(number) for name, number in item.items()} for item in lines]


@pytest.mark.parametrize("start", range(0, len(FORMS), BATCH))
def test_programs_print_what_the_solver_has(start: int) -> None:
    found = [task for name, form in FORMS[start : start + BATCH] for task in tasks(name, form, SEEDS)]
    codes = [listing(task) for task in found]
    for task, code, results in zip(found, codes, run(codes), strict=True):
        printed = [quantity for quantity in task.asked if not quantity.is_of_turn]  # a program is for one position
        assert list(results) == [quantity.name for quantity in printed]
        for quantity in printed:
            wanted = exact(task, quantity)
            assert results[quantity.name] == pytest.approx(wanted, rel=1e-9, abs=1e-9), (quantity.name, code)


def test_programs_are_short_and_need_numpy_only() -> None:
    lengths = []
    for name, form in FORMS:
        (task,) = tasks(name, form, 1)
        code = listing(task)
        lines = code.splitlines()
        lengths.append(len(lines))
        assert len(lines) <= LONGEST, name
        assert max(map(len, lines)) <= WIDEST, name
        imports = [node for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Import | ast.ImportFrom)]
        assert [alias.name for node in imports for alias in node.names] == ["numpy"]
    assert sorted(lengths)[len(lengths) // 2] <= USUAL


@pytest.mark.parametrize("language", languages())
def test_comments_are_in_the_language(language: str) -> None:
    drawn, motion = variants("four_bar", "crank", 1)
    text = explain(
        drawn[0], motion, 0, read_ask(drawn[0].form), load_language(language), SolutionOptions(("coordinates",))
    )
    (program,) = [block for section in text.sections for block in section.blocks if isinstance(block, Program)]
    comments = [line for line in program.code.splitlines() if line.startswith("#")]
    sentences = {
        "".join(map(str, p)) for key, p in load_phrases(language).sentences.items() if key.startswith("listing.")
    }
    assert comments
    assert {line.removeprefix("# ") for line in comments} <= sentences
