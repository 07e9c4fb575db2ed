"""What a problem does not need is not computed, and what a command does not need is not loaded."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.methods.forms import FORMS, variants
from variantgen import single
from variantgen.mechanism.component import discover
from variantgen.mechanism.relative import sliding_points
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import FreePoint, GuidedPoint

NOTHING_ELSE = {"cli", "errors", "version"}
SOLVING = NOTHING_ELSE | {
    "algebra", "exam", "families", "letters", "limits", "mechanism", "methods", "notebook", "resources", "single",
    "tables", "variants", "wording",
}  # fmt: skip
BUILDING = (SOLVING - {"single"}) | {"builder", "figure", "outputs"}
CLASSES = {"msgspec", "typing_extensions"}  # msgspec takes the second where something else has installed it
EXAM = 'title = "T"\nlanguage = "en"\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "slider_crank"\n'


def refused(*args: object) -> None:
    raise AssertionError("this problem does not need it")


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_velocity_problems_evaluate_no_quadratic_terms(name: str, form: str, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn, motion = variants(name, form, 2)
    for kind in ("joints", "drivers"):
        for component in discover(f"variantgen.mechanism.{kind}").values():
            monkeypatch.setattr(component, "quadratic", refused)
    found = solve(motion.scene, 1, drawn[0].form.plan)
    assert found.v
    assert not found.a
    assert not found.epsilon


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_a_scene_without_a_sleeve_has_no_relative_unknowns(
    name: str, form: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn, motion = variants(name, form, 2)
    plan = drawn[0].form.plan
    # An unknown is the rate of a body, the speed of a point along a line at rest, or one of a point that nothing leads.
    own = set(plan.omega.values())
    for step in plan.steps:
        if isinstance(step, GuidedPoint):
            own.add(step.unknown)
        elif isinstance(step, FreePoint):
            own |= {step.x, step.y}
    assert {unknown for block in plan.blocks for unknown in block.unknowns} <= own
    if sliding_points(motion.scene):
        return
    monkeypatch.setattr(single, "relative_motion", refused)
    assert "relative" not in single.solution_document(drawn[0])


def loaded(arguments: list[str]) -> tuple[set[str], set[str]]:
    """Parts of the program and packages from elsewhere that are loaded when a command ends."""
    script = (
        "import contextlib, io, json, sys\nfrom variantgen.cli import main\nquiet = io.StringIO()\n"
        "with contextlib.redirect_stdout(quiet), contextlib.redirect_stderr(quiet), contextlib.suppress(SystemExit):\n"
        "    code = main(sys.argv[1:])\n    assert not code, quiet.getvalue()\n"
        "print(json.dumps({n: getattr(m, '__file__', None) or '' for n, m in sys.modules.items()}))"
    )
    done = subprocess.run([sys.executable, "-c", script, *arguments], capture_output=True, text=True, check=True)
    files = json.loads(done.stdout)
    own = {name.removeprefix("variantgen.") for name in files if name.startswith("variantgen.")}
    others = {name for name, file in files.items() if "." not in name and "site-packages" in file}
    return own, {name for name in others if not name.startswith("_") and name != "variantgen"}


def there(*names: str) -> set[str]:
    """Modules by their names, which would be missed if they had others now."""
    for name in names:
        assert importlib.util.find_spec(f"variantgen.{name}"), name
    return set(names)


def parts(modules: set[str]) -> set[str]:
    """The folders and modules right below the program that modules belong to."""
    return {name.split(".")[0] for name in modules}


def test_list_checks_no_family_of_the_catalogue() -> None:
    own, packages = loaded(["list"])
    assert parts(own) <= NOTHING_ELSE | {"exam", "families", "letters", "limits", "resources", "tables", "wording"}
    assert {name for name in own if name.startswith("exam.")} == {
        "exam.work",
        "exam.work.kept_work",
        "exam.work.wanted_work",
    }
    assert "families.reading.load" not in own
    assert packages <= CLASSES


def test_solve_loads_no_more_than_it_needs() -> None:
    own, packages = loaded(["solve", "slider_crank", "--seed", "1"])
    assert parts(own) <= SOLVING
    # Of an exam the answers alone; of methods those that lead to them, nothing that chooses, checks or prints steps.
    assert not own & there("exam.exam", "exam.exam_file", "exam.sections.notices", "exam.roster", "wording.inline")
    assert not {name for name in own if name.startswith(("wording.language", "wording.formula"))}
    # Nothing about a whole turn of the crank, but whether there is a crank.
    assert {name for name in own if name.startswith("mechanism.turn.")} == {"mechanism.turn.crank"}
    assert "methods.by_groups.turn_answers" not in own
    printing = ("agreement", "beside_motion", "checks", "compose", "printed_numbers")
    others = ("by_groups.closed_chain", "by_groups.three_rates", "centres.projections", "vectors.sliding.cylinder")
    assert not own & there(*(f"methods.{name}" for name in (*printing, *others, "steps.printed_digits")))
    assert not {name for name in own if name.startswith(("methods.coordinates", "methods.graphical"))}
    assert packages <= CLASSES | {"numpy"}


def test_a_build_without_solutions_loads_no_more_than_it_needs(tmp_path: Path) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(EXAM, "utf-8")
    own, packages = loaded(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")])
    assert parts(own) <= BUILDING
    assert {name for name in own if name.startswith("outputs.formats.")} == {"outputs.formats.pdf"}
    unneeded = (
        "wording.solution.",
        "figure.views.",
        "figure.alt_text.",
        "outputs.html.",
        "outputs.platforms.",
        "outputs.qti.",
        "outputs.latex.",
    )
    assert not {name for name in own if name.startswith(unneeded)}
    # Pillow and lxml belong to pikepdf, MarkupSafe to Jinja; tqdm is for builds of more than a second.
    assert packages <= CLASSES | {
        "tqdm",
        "numpy",
        "jinja2",
        "markupsafe",
        "typst",
        "pikepdf",
        "segno",
        "deprecated",
        "wrapt",
        "lxml",
        "PIL",
        "packaging",
    }
