"""What is computed for a problem and what is left out: every form with velocities only, and with all that it asks.

    python -m benchmarks.needed

Prints Markdown tables and writes them to ``benchmarks/needed.md``. Nothing here is a time; the numbers are the same on
every machine but for the modules, which depend on versions.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from benchmarks.measure import write_beside
from variantgen.algebra.values import in_order
from variantgen.families.asking import read_ask
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.relative import sliding_points
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.single import one_variant
from variantgen.variants.printed_data import given_names
from variantgen.variants.variant import solve_variants

HEAD = """\
| form | asked | orders | blocks | unknown rates | quadratic terms | sliding points | given data | steps | values |
|---|---|---|---|---|---|---|---|---|---|"""


@contextmanager
def counted(scene: Scene) -> Iterator[list[int]]:
    """How often quadratic terms of the joints and drivers of a scene are evaluated inside the block."""
    calls = [0]
    kinds = {type(constraint) for constraint in scene.constraints}
    before = {kind: kind.quadratic for kind in kinds}

    def counting(kind: type):
        def quadratic(self, at, speeds):
            calls[0] += 1
            return before[kind](self, at, speeds)

        return quadratic

    for kind in kinds:
        kind.quadratic = counting(kind)
    try:
        yield calls
    finally:
        for kind in kinds:
            kind.quadratic = before[kind]


def row(name: str, form: Form, asked: list[Quantity]) -> str:
    variant = one_variant(name, seed="1", form=form.name, ask=[quantity.name for quantity in asked])
    order = max(quantity.order for quantity in asked)
    motion = solve_variants([variant], order)
    with counted(motion.scene) as calls:
        solve(motion.scene, order, form.plan)
    worked = solution(task_of(variant, motion, 0, asked))
    values = in_order([value for _, value in worked.answers])
    blocks = [len(block.unknowns) for block in form.plan.blocks]
    title = f"{name} {form.name}".strip()
    return (
        f"| {title} | {', '.join(q.name for q in asked)} | {', '.join(map(str, range(order + 1)))}"
        f" | {' + '.join(map(str, blocks)) or '-'} | {sum(blocks)} | {calls[0]} | {len(sliding_points(motion.scene))}"
        f" | {len(given_names(variant, asked))} | {len(worked.steps)} | {len(values)} |"
    )


def rows() -> Iterator[str]:
    for name in family_names():
        for form in restrict(load_family(name)).forms.values():
            every = read_ask(form)
            velocities = [quantity for quantity in every if quantity.order == 1]
            for asked in ([velocities] if velocities and len(velocities) < len(every) else []) + [every]:
                yield row(name, form, asked)


COMMANDS = {
    "--help": ["--help"],
    "solve": ["solve", "slider_crank", "--seed", "1"],
    "build, no solutions": ["build", "EXAM", "--variants", "1", "--out", "OUT"],
    "build with solutions": ["build", "sample_en", "--variants", "1", "--out", "OUT"],
}
EXAM = 'title = "T"\nlanguage = "en"\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "slider_crank"\n'
SCRIPT = """
import contextlib, io, json, sys
from variantgen.cli import main
quiet = io.StringIO()
with contextlib.redirect_stdout(quiet), contextlib.redirect_stderr(quiet), contextlib.suppress(SystemExit):
    main(sys.argv[1:])
print(json.dumps(sorted(sys.modules)))
"""
PACKAGES = ("msgspec", "numpy", "scipy", "jinja2", "typst", "pikepdf", "matplotlib", "mpmath", "openpyxl")


def modules(arguments: list[str]) -> list[str]:
    """Names of the modules that a command has loaded when it ends."""
    with tempfile.TemporaryDirectory() as folder:
        exam = Path(folder) / "exam.toml"
        exam.write_text(EXAM, "utf-8")
        places = {"EXAM": str(exam), "OUT": str(Path(folder) / "out")}
        command = [sys.executable, "-c", SCRIPT, *(places.get(word, word) for word in arguments)]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def module_rows() -> Iterator[str]:
    for title, arguments in COMMANDS.items():
        loaded = modules(arguments)
        own = [name for name in loaded if name.split(".")[0] == "variantgen"]
        packages = [name for name in PACKAGES if name in loaded]
        layers = sorted({name.split(".")[1] for name in own if "." in name})
        yield f"| {title} | {len(own)} | {', '.join(packages) or '-'} | {', '.join(layers)} |"


def main() -> None:
    lines = [
        "# What is computed, and what is left out",
        "",
        "`python -m benchmarks.needed`: one variant of every form, asked for velocities only and for all that it asks.",
        "Unknown rates are solved block by block (2 + 1: a pair, then one); quadratic terms are counted as joints and",
        "drivers are asked for them. Values are the numbers of the worked solution, given ones included.",
        "",
        HEAD,
        *rows(),
        "",
        "Modules that are loaded when a command ends:",
        "",
        "| command | own modules | packages | parts of the program |",
        "|---|---|---|---|",
        *module_rows(),
    ]
    print(*lines, "", sep="\n")
    write_beside(__file__, lines)


if __name__ == "__main__":
    main()
