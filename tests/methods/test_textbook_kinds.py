"""Mechanisms of every textbook kind, each a scene of its own: all that can be asked has a worked solution.

A solution is written only where each of its numbers and its answers are those of the solver, whose motion the
independent computation confirms; so it is enough that there is one.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from variantgen.errors import InputError
from variantgen.families.asking import read_ask
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import motion_order, split_name
from variantgen.methods import compose, natural_answers
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.single import one_variant, solution_document
from variantgen.variants.variant import Variant, solve_variants

SCENES = sorted((Path(__file__).parents[1] / "textbook_kinds").glob("*.toml"))
CRANKED = [path for path in SCENES if 'A = { polar = { origin = "O"' in path.read_text(encoding="utf-8")]
METHODS = {"by itself": (), "coordinates": ("coordinates",)}
# Not all that can be asked of these is found link by link; then the coordinate method is the natural one.
NOT_LINK_BY_LINK = {
    "boat_rope", "cam_roller_rolls", "coupler_driven", "crane_rope", "excavator", "frame_on_cart",
    "incline_blocks_rope", "movable_pulley_rope", "oldham", "pin_in_two_yokes",
    "pin_two_slots", "rack_on_rocker", "two_stage_hoist",
}  # fmt: skip
# Cranks at angles (degrees) at which the lengths of what hangs on them do not reach.
UNREACHED = {"slider_on_rotating_by_link": {180, 270}, "stephenson_three": {180, 270}, "third_class": {0, 180, 270}}


# From rest the natural solution of this one is not confirmed, and the coordinate method takes its place: it is asked
# for a centre of velocities where there are none.
UNCONFIRMED_FROM_REST = {"plate_two_directions"}


class _NeverError(Exception):
    """What nothing raises."""


@pytest.fixture
def wrong_is_wrong(monkeypatch: pytest.MonkeyPatch) -> None:
    """A natural solution that is not confirmed fails; of a scene of one's own coordinates would take its place."""
    monkeypatch.setattr(natural_answers, "VerificationError", _NeverError)


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
def test_natural_methods_alone(path, monkeypatch):
    """Nothing takes the place of the natural methods."""
    monkeypatch.setattr(
        compose, "by_choice", lambda task, choice, _, make: make(Book(task, style=choice.style), choice.whole)
    )
    variant = one_variant(str(path))
    if path.stem in NOT_LINK_BY_LINK:
        with pytest.raises(NOT_APPLICABLE):
            _answered(variant, _wholes(variant), ())
    else:
        assert _answered(variant, _wholes(variant), ()) == _wholes(variant)


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
@pytest.mark.usefixtures("wrong_is_wrong")
def test_each_by_itself(path):
    """A quantity alone needs other steps than together with others."""
    variant = one_variant(str(path))
    for name in _wholes(variant):
        assert _answered(variant, [name], ()) == [name]


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
@pytest.mark.usefixtures("wrong_is_wrong")
def test_what_is_made_of_others(path):
    """Positions, the path of a point, components along a line, coordinates of centres, a ratio.

    Of these only places, radii of paths and centres at a pivot may be told by the data. A point at rest has no path:
    that is said, and no method leads to it.
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
        try:
            asked += read_ask(form, [name])
        except InputError as error:
            assert "is given, so it cannot be asked" in str(error)
            assert split_name(name).kind in ("x", "y", "rho", "P")
    assert len(asked) >= 2 * len(moving) + len(bodies) + 1  # the accelerations, a centre each, the component
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
@pytest.mark.usefixtures("wrong_is_wrong")
def test_cranks_along_the_axes(path, angle, tmp_path):
    """Where slips, rates or whole equations are zero but for rounding."""
    text = path.read_text(encoding="utf-8")
    turned = re.sub(r'^(A = .*origin = "O", distance = \S+, angle =) \S+', rf"\1 {angle}", text, flags=re.MULTILINE)
    own = tmp_path / path.name
    own.write_text(turned, encoding="utf-8")
    variant = one_variant(str(own))
    reached = angle not in UNREACHED.get(path.stem, ())
    assert solve_variants([variant], 2).solved[0] == reached
    for method in METHODS.values() if reached else ():
        assert _answered(variant, _wholes(variant), method) == _wholes(variant)


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_from_rest(path, tmp_path, request):
    """Every driver sets in: no velocities, but accelerations."""
    if path.stem not in UNCONFIRMED_FROM_REST:
        request.getfixturevalue("wrong_is_wrong")
    head, drivers = path.read_text(encoding="utf-8").split("[[drivers]]", 1)
    drivers = re.sub(r"omega = \S+( epsilon = \S+)?", "omega = 0, epsilon = 3,", drivers)
    drivers = re.sub(r"\bv = [-.\d]+(?!.*\ba = )", "v = 0, a = 3", drivers)
    drivers = re.sub(r"\bv = [-.\d]+", "v = 0", drivers)
    drivers = drivers.replace("epsilon = 3, }", "epsilon = 3 }")
    own = tmp_path / path.name
    own.write_text(f"{head}[[drivers]]{drivers}", encoding="utf-8")
    variant = one_variant(str(own))
    motion = solve_variants([variant], 2)
    assert motion.solved[0]
    assert max(abs(complex(v[0])) for v in motion.v.values()) < 1e-12
    assert max(abs(complex(a[0])) for a in motion.a.values()) > 1e-3
    assert _answered(variant, list(variant.form.ask), ()) == list(variant.form.ask)
