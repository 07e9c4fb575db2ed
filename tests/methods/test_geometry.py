"""Lengths, directions and coordinates of the position: exact in every pose, each line after those that it needs."""

from __future__ import annotations

import cmath
import copy
import math
from collections.abc import Iterator
from decimal import Decimal
from itertools import permutations
from pathlib import Path
from typing import Any

import pytest

from tests.solved_cases import case_of, task
from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import parts
from variantgen.families.family import Form
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family, parse_family
from variantgen.families.restrict import restrict
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.methods.steps.step import Derived, EquationLine, Sentence
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant, solve_variants

POSES = [(sense, turns) for sense in (1, -1) for turns in range(4)]
ORDERS = ("length direction", "direction length", "coordinates direction length", "coordinates length direction")

# Every construction that a family may use, with conditions; hand-made numbers in the tests below.
SCENE: dict[str, Any] = {
    "schema": 1,
    "title": {"en": "Constructions", "ru": "Построения"},
    "length_unit": "cm",
    "parameters": {
        "OA": {"unit": "cm", "values": [30]},
        "AL": {"unit": "cm", "values": [40]},
        "d": {"unit": "cm", "values": [50]},
        "h": {"unit": "cm", "values": [10]},
        "R": {"unit": "cm", "values": [12]},
        "r": {"unit": "cm", "values": [5]},
        "phi": {"unit": "deg", "values": [40]},
        "omega_OA": {"unit": "rad/s", "values": [2]},
    },
    "bodies": {"OA": ["O", "A"]},
    "joints": [{"pivot": {"point": "O"}}],
    "drivers": [{"rotation": {"body": "OA", "omega": "omega_OA"}}],
    "points": {
        "O": {"coordinates": {"x": 0, "y": 0}},
        "C": {"coordinates": {"x": "d", "y": "h"}},
        "A": {"polar": {"origin": "O", "distance": "OA", "angle": "phi"}},
        "B": {"polar": {"origin": "A", "towards": "O", "distance": "r", "angle": "-2 * phi"}},
        "T": {"tangent": {"centre": "C", "radius": "R", "side": "left", "to": "A"}},
        "S": {
            "tangent": {
                "centre": "C", "radius": "R", "side": "right", "to": "O", "to_radius": "r", "to_side": "left",
            }
        },
        "U": {
            "tangent": {"centre": "C", "radius": "r", "side": "left", "to": "O", "to_radius": "R", "to_side": "left"}
        },
        "P": {"on_body": {"origin": "A", "towards": "C", "along": "r", "across": "R"}},
        "Q": {"line_line": {"first": "O", "first_angle": "25 * deg", "second": "C", "second_towards": "A"}},
        "F": {"foot": {"of": "A", "through": "C", "angle": "15 * deg"}},
        "G": {"fraction": {"start": "A", "end": "C", "part": "0.3"}},
        "L": {"line_circle": {"through": "C", "towards": "O", "centre": "A", "distance": "AL", "branch": "behind"}},
        "M": {
            "circle_circle": {
                "first": "A", "first_distance": "AL", "second": "C", "second_distance": "OA", "side": "right",
            }
        },
        "N": {"near": {"x": "d", "y": "0.2 * d"}},
        "K": {"near": {"x": "d", "y": "0.8 * d"}},
    },
    "conditions": [
        {"distance": {"start": "A", "end": "N", "length": "OA"}},
        {"line": {"point": "N", "through": "C", "angle": "phi"}},
        {"distance": {"start": "N", "end": "K", "length": "AL"}},
        {"line": {"point": "K", "through": "O", "towards": "A"}},
    ],
    "ask": ["v_A"],
}  # fmt: skip


def scene_task(sense: int, turns: int) -> Task:
    family = parse_family(copy.deepcopy(SCENE), Path("constructions") / "family.toml")
    form = next(iter(family.forms.values()))
    printed = {name: Decimal(str(parameter.printed[0])) for name, parameter in form.parameters.items()}
    variant = Variant(family, form, printed, sense, turns)
    return task_of(variant, solve_variants([variant], 1), 0, ())


def catalogue() -> list[tuple[str, Form]]:
    return [(name, form) for name in family_names() for form in load_family(name).forms.values()]


def drawn_tasks(name: str, form: Form, count: int) -> Iterator[Task]:
    family = load_family(name)
    chosen = restrict(family, None, None, (form.name,) if form.name else ())
    for seed in range(count):
        variant = draw(chosen, None, [(str(seed), "single", 0)])[0]
        yield task_of(variant, solve_variants([variant], 1), 0, ())


def deviations(task: Task, order: str) -> Iterator[tuple[str, float]]:
    """By quantity, how far it is from the solver's position, as a share of the size of the mechanism."""
    geometry, z = Geometry(task), task.now.z
    pairs = [(a, b) for a, b in permutations(z, 2) if abs(z[a] - z[b]) > 1e-9 * task.size]
    for what in order.split():
        if what == "coordinates":
            for point in z:
                x, y = geometry.coordinates(point)
                yield f"coordinates of {point}", abs(complex(x.exact, y.exact) - z[point]) / task.size
            continue
        for a, b in pairs:
            step = z[b] - z[a]
            if what == "length":
                yield f"{a}{b}", abs(geometry.length(a, b).exact - abs(step)) / task.size
            else:
                found = cmath.rect(abs(step), math.radians(geometry.direction(a, b).exact))
                yield f"direction of {a}{b}", abs(found - step) / task.size


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(("name", "form"), catalogue(), ids=[f"{n}-{f.name}" for n, f in catalogue()])
def test_every_pair_of_points_is_exact(name: str, form: Form, order: str) -> None:
    for each in drawn_tasks(name, form, 3):
        for what, far in deviations(each, order):
            assert far < 1e-12, what


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(("sense", "turns"), POSES)
def test_every_construction_is_exact_in_every_pose(sense: int, turns: int, order: str) -> None:
    for what, far in deviations(scene_task(sense, turns), order):
        assert far < 1e-12, what


def worked(task: Task, order: str) -> Geometry:
    geometry = Geometry(task)
    for what in order.split():
        for a, b in permutations(task.now.z, 2):
            if abs(geometry.vector(a, b)) > 1e-9 * task.size:
                _ = geometry.coordinates(a) if what == "coordinates" else getattr(geometry, what)(a, b)
    return geometry


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(("sense", "turns"), POSES)
def test_lines_follow_from_lines_before_and_nothing_comes_twice(sense: int, turns: int, order: str) -> None:
    seen: set[int] = set()
    names = []
    for item in worked(scene_task(sense, turns), order).items:
        if isinstance(item, Derived) and item.value.expression is not None:
            unknown = [v for v in parts(item.value.expression) if v.expression is not None and id(v) not in seen]
            assert not unknown, (item.value, unknown)
            seen.add(id(item.value))
            names.append(item.value.name)
    assert len(names) > 20
    assert len(names) == len(set(names))


@pytest.mark.parametrize(("name", "form"), catalogue(), ids=[f"{n}-{f.name}" for n, f in catalogue()])
def test_the_lines_of_families_follow_from_lines_before(name: str, form: Form) -> None:
    for each in drawn_tasks(name, form, 2):
        geometry = worked(each, "length direction coordinates")
        seen = set(map(id, geometry.printed.values()))
        for item in geometry.items:
            if isinstance(item, Derived) and item.value.expression is not None:
                assert all(v.expression is None or id(v) in seen for v in parts(item.value.expression)), item.value
                seen.add(id(item.value))


def lines(geometry: Geometry) -> list[Value]:
    return [item.value for item in geometry.items if isinstance(item, Derived)]


class TestProblem28:
    """A four-bar linkage with a sleeve: the source puts the origin into C, the family into O, 62 cm to the right."""

    @pytest.fixture
    def geometry(self) -> Geometry:
        return Geometry(task(*case_of("four_bar_with_sleeve", "K28")))

    def test_the_hinge_by_a_triangle(self, geometry: Geometry) -> None:
        x, y = geometry.coordinates("B")
        assert x.exact + 62 == pytest.approx(-20.29777, abs=1e-5)
        assert y.exact == pytest.approx(37.90779, abs=1e-5)
        for centre, radius in (("A", 111.0), ("C", 43.0)):
            there = complex(*(value.exact for value in geometry.coordinates(centre)))
            assert abs(complex(x.exact, y.exact) - there) == pytest.approx(radius, rel=1e-12)
        assert not any(isinstance(item, EquationLine) for item in geometry.items)

    def test_the_sleeve(self, geometry: Geometry) -> None:
        assert geometry.length("O", "D").exact == pytest.approx(19.951603, abs=1e-6)
        assert geometry.direction("O", "D").exact == 45.0

    def test_the_links_by_the_diagonal(self, geometry: Geometry) -> None:
        found = geometry.direction("A", "B").exact
        assert found == pytest.approx(math.degrees(math.atan2(37.90779 - 28.284271, -20.29777 - 90.284271)), abs=1e-5)
        diagonal = math.hypot(62 + 40 * math.sqrt(0.5), 40 * math.sqrt(0.5))
        assert any(value.exact == pytest.approx(diagonal, rel=1e-12) for value in lines(geometry))
        assert not any(isinstance(item, EquationLine) for item in geometry.items)


def test_example_36() -> None:
    geometry = Geometry(task(*case_of("two_loop_mechanism", "M36")))
    x, y = geometry.coordinates("A")
    assert (x.exact, y.exact) == pytest.approx((0.2, 0.2 * math.sqrt(3)), abs=1e-15)
    x, y = geometry.coordinates("B")
    assert (x.exact, y.exact) == pytest.approx((0.2, 0.2 * math.sqrt(3) - 1.4), abs=1e-15)
    assert geometry.direction("A", "B").exact == -90.0
    assert geometry.length("A", "D").exact == 0.7


class TestByHand:
    """Numbers of the scene above, worked out with triangles."""

    @pytest.fixture
    def geometry(self) -> Geometry:
        return Geometry(scene_task(1, 0))

    def test_a_given_direction_is_the_given_angle(self, geometry: Geometry) -> None:
        assert geometry.direction("O", "A") is geometry.task.given["phi"]
        assert not geometry.items

    def test_law_of_cosines_and_sum_of_angles(self, geometry: Geometry) -> None:
        # The direction of AB is that of AO, 40 + 180, less 80; OB^2 = 30^2 + 5^2 - 2 * 30 * 5 * cos 80.
        assert geometry.direction("A", "B").exact == pytest.approx(140.0, abs=1e-12)
        assert geometry.length("O", "B").exact == pytest.approx(29.54497, abs=1e-5)

    def test_a_foot_is_half_way_round_a_right_triangle(self, geometry: Geometry) -> None:
        step = complex(30 * math.cos(math.radians(40)) - 50, 30 * math.sin(math.radians(40)) - 10)
        along, across = geometry.length("C", "F").exact, geometry.length("A", "F").exact
        assert math.hypot(along, across) == pytest.approx(abs(step), rel=1e-14)
        assert geometry.direction("C", "F").exact == pytest.approx(-165.0, abs=1e-12)

    def test_the_radius_is_across_the_thread(self, geometry: Geometry) -> None:
        assert geometry.length("C", "T") is geometry.task.given["R"]
        turn = geometry.direction("C", "T").exact - geometry.direction("A", "T").exact
        assert math.cos(math.radians(turn)) == pytest.approx(0.0, abs=1e-14)

    def test_points_placed_together_come_with_their_conditions(self, geometry: Geometry) -> None:
        geometry.coordinates("K")
        conditions = [item for item in geometry.items if isinstance(item, EquationLine)]
        assert len(conditions) == 4
        for each in conditions:
            assert each.left.number(True) == pytest.approx(each.right.number(True), rel=1e-10, abs=1e-8)


def test_the_sine_rule_of_the_slider_crank() -> None:
    family = restrict(load_family("slider_crank"), None, None, ("central",))
    form = family.forms["central"]
    printed = {name: p.printed[0] for name, p in form.parameters.items()}
    printed |= {"OA": Decimal(20), "AB": Decimal(80), "phi": Decimal(30)}
    variant = Variant(family, form, printed)
    geometry = Geometry(task_of(variant, solve_variants([variant], 1), 0, ()))
    assert geometry.direction("A", "B").exact == pytest.approx(-math.degrees(math.asin(20 * 0.5 / 80)), rel=1e-14)
    # The corner by OA sin phi / AB and the direction by it, no coordinates.
    assert isinstance(said := geometry.items[0], Sentence) and said.key == "position.triangle_sines"
    lines = [item.value.name for item in geometry.items if isinstance(item, Derived)]
    assert lines == [Name("angle", "B", "A O"), Name("direction", "A", "B")]
    assert geometry.length("O", "B").exact == pytest.approx(10 * math.sqrt(3) + math.sqrt(80**2 - 10**2), rel=1e-14)
