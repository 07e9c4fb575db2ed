"""Mechanisms of every textbook kind, each a scene of its own: all that can be asked has a worked solution.

A solution is written only where each of its numbers and its answers are those of the solver, whose motion the
independent computation confirms; so it is enough that there is one.
"""

from __future__ import annotations

import re
from contextlib import suppress
from pathlib import Path

import pytest

from variantgen.errors import InputError
from variantgen.families.asking import read_ask
from variantgen.families.quantities import motion_order, split_name
from variantgen.families.units import unit
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.single import one_variant, solution_document
from variantgen.variants.variant import Variant, solve_variants

SCENES = sorted((Path(__file__).parents[1] / "textbook_kinds").glob("*.toml"))
CRANKED = [path for path in SCENES if 'A = { polar = { origin = "O"' in path.read_text(encoding="utf-8")]
METHODS = {"by itself": (), "coordinates": ("coordinates",)}


def _answered(variant: Variant, names: list[str], methods: tuple[str, ...]) -> list[str]:
    """The quantities that the solution for these ones answers."""
    asked = read_ask(variant.form, names)
    motion = solve_variants([variant], motion_order(asked))
    return [name for name, _ in solution(task_of(variant, motion, 0, asked), methods).answers]


def _wholes(variant: Variant) -> list[str]:
    """Everything that can be asked, but for components, senses and distances from centres."""
    return [name for name in variant.form.askable if not split_name(name).component]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_everything_together(path, method):
    variant = one_variant(str(path))
    assert solution_document(variant)["outcome"] == "solved"
    assert _answered(variant, _wholes(variant), METHODS[method]) == _wholes(variant)


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_each_by_itself(path):
    """A quantity alone needs other steps than together with others."""
    variant = one_variant(str(path))
    for name in _wholes(variant):
        assert _answered(variant, [name], ()) == [name]


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_what_is_made_of_others(path):
    """Positions, the path of a point, components along a line, coordinates of centres, a ratio: what data do not tell.

    A point at rest has no path: that is said, and no method leads to it.
    """
    variant = one_variant(str(path))
    form, bodies = variant.form, list(variant.form.bodies)
    moving = [name[2:] for name in _wholes(variant) if re.fullmatch("v_[A-Z][0-9]*", name)]
    names = [f"{kind.format(p)}" for p in moving for kind in ("x_{}", "y_{}", "rho_{}", "a_{}.t", "a_{}.n")]
    names += [f"v_{moving[0]}.along_{a}{b}" for a, b in [list(form.points)[:2]]]
    names += [f"{kind}_{body}.{axis}" for body in bodies for kind, axis in (("P", "x"), ("Q", "y"))]
    names += [f"ratio_{bodies[-1]}.{bodies[0]}"] if len(bodies) > 1 else []
    asked = []
    for name in names:
        with suppress(InputError):
            asked += read_ask(form, [name])
    motion = solve_variants([variant], 2)
    slowest = 1e-9 * max(abs(complex(v[0])) for v in motion.v.values())
    for quantity in asked:
        path_alone = quantity.kind == "rho" or quantity.component in ("t", "n")
        if path_alone and abs(complex(motion.v[quantity.target][0])) < slowest:
            continue
        assert _answered(variant, [quantity.name], ()) == [quantity.name]


@pytest.mark.parametrize("digits", [3, 8])
@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_points_by_coordinates_with_few_digits(path, digits, tmp_path):
    """As read off a figure: a pin then lies a little beside its slot."""
    variant = one_variant(str(path))
    metre = float(unit(variant.family.length_unit).factor)
    points = solution_document(variant)["points"]
    lines = ["[points]"]
    for name, found in points.items():
        x, y = (f"{number / metre:.{digits}g}" for number in found["position"])
        lines.append(f"{name} = {{ coordinates = {{ x = {x}, y = {y} }} }}")
    text = re.sub(r"\[\[conditions\]\]\n.*\n", "", path.read_text(encoding="utf-8"))
    text = re.sub(r"\[points\]\n(.+\n)+", "\n".join(lines) + "\n", text)
    own = tmp_path / path.name
    own.write_text(text, encoding="utf-8")
    variant = one_variant(str(own))
    assert solution_document(variant)["outcome"] == "solved"
    assert _answered(variant, list(variant.form.ask), ()) == list(variant.form.ask)


@pytest.mark.parametrize("angle", [0, 90, 180, 270])
@pytest.mark.parametrize("path", CRANKED, ids=lambda path: path.stem)
def test_cranks_along_the_axes(path, angle, tmp_path):
    """Where slips, rates or whole equations are zero but for rounding; some lengths do not reach there."""
    text = path.read_text(encoding="utf-8")
    turned = re.sub(r'^(A = .*origin = "O", distance = \S+, angle =) \S+', rf"\1 {angle}", text, flags=re.MULTILINE)
    own = tmp_path / path.name
    own.write_text(turned, encoding="utf-8")
    variant = one_variant(str(own))
    if not solve_variants([variant], 2).solved[0]:
        return
    for method in METHODS.values():
        assert _answered(variant, _wholes(variant), method) == _wholes(variant)


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_from_rest(path, tmp_path):
    """Every driver sets in: no velocities, but accelerations."""
    head, drivers = path.read_text(encoding="utf-8").split("[[drivers]]", 1)
    drivers = re.sub(r"omega = \S+( epsilon = \S+)?", "omega = 0, epsilon = 3,", drivers)
    drivers = re.sub(r"\bv = [-.\d]+", "v = 0", drivers)
    drivers = drivers.replace("epsilon = 3, }", "epsilon = 3 }")
    own = tmp_path / path.name
    own.write_text(f"{head}[[drivers]]{drivers}", encoding="utf-8")
    variant = one_variant(str(own))
    if solve_variants([variant], 2).solved[0]:
        assert _answered(variant, list(variant.form.ask), ()) == list(variant.form.ask)
