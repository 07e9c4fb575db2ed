"""The inspection of arrows names each fault of a figure made by hand, and none of its neighbour without the fault."""

from __future__ import annotations

import math

import pytest
from msgspec.structs import astuple

from variantgen.figure.drawing import BOLD, Arc, Drawing, Layer, RotationArc
from variantgen.figure.inspection.arrow_faults import inspect_arrows
from variantgen.figure.placement.label_requests import along_arrow
from variantgen.figure.sketch import Sketch
from variantgen.wording.formula import Symbol

V, A = Symbol("v"), Symbol("a")


def arrow(sketch: Sketch, start: complex, tip: complex, symbol: Symbol = V) -> None:
    sketch.arrow(start, tip)
    sketch.label(along_arrow(symbol, start, tip))


def dimension(sketch: Sketch, start: complex, tip: complex) -> None:
    sketch.arrow(start, tip, Layer.MARK, 0.3, 1.9)


def turn(sketch: Sketch, centre: complex, radius: float, rims: tuple[float, ...] = (), sweep: float = 1.1) -> None:
    sketch.rotations.append(RotationArc(Symbol("ω"), sketch.arc_arrow(centre, radius, 1.0, sweep), rims))


def finished(sketch: Sketch) -> Drawing:
    return sketch.finish({})


def kinds(sketch: Sketch) -> dict[str, int]:
    found = inspect_arrows(finished(sketch)).by_kind
    return {kind: len(faults) for kind, faults in found.items() if faults}


@pytest.fixture
def sketch() -> Sketch:
    return Sketch({}, 1.0)


@pytest.mark.parametrize(("height", "expected"), [(0.0, {"crossed": 1}), (4.0, {})])
def test_an_arrow_over_a_link(sketch: Sketch, height: float, expected: dict[str, int]) -> None:
    sketch.path((8 + height * 1j, 8 + 20j), Layer.LINK)
    arrow(sketch, 0, 12)
    assert kinds(sketch) == expected


def test_an_arrow_may_begin_on_a_link_that_it_leaves(sketch: Sketch) -> None:
    sketch.path((-10j, 10j), Layer.LINK)
    arrow(sketch, 0.5, 12)
    assert kinds(sketch) == {}


def test_an_arrow_may_leave_the_rim_that_it_touches(sketch: Sketch) -> None:
    sketch.circle(-20j, 20, Layer.DISC)
    arrow(sketch, 0.5, 12)
    assert kinds(sketch) == {}


def test_two_arrows_over_each_other(sketch: Sketch) -> None:
    arrow(sketch, 0, 12)
    arrow(sketch, 8 - 8j, 8 + 8j, A)
    assert kinds(sketch) == {"crossed": 2}


@pytest.mark.parametrize(("aside", "expected"), [(0.0, {"doubled": 1}), (4.0, {})])
def test_two_opposite_arrows_at_a_point(sketch: Sketch, aside: float, expected: dict[str, int]) -> None:
    arrow(sketch, 1, 12)
    arrow(sketch, -1 + aside * 1j, -10 + aside * 1j, A)
    assert kinds(sketch) == expected


@pytest.mark.parametrize(("side", "expected"), [(-1j, {"behind": 1}), (1j, {})])
def test_an_arrow_behind_a_wall(sketch: Sketch, side: complex, expected: dict[str, int]) -> None:
    sketch.path((-20, 20), Layer.GROUND)
    sketch.hatch(-20, 20, -1j)
    arrow(sketch, 4 * side, 12 + 4 * side)
    assert kinds(sketch) == expected


@pytest.mark.parametrize(("end", "expected"), [(15.0, {"continued": 1}), (11.0, {})])
def test_a_line_past_the_head(sketch: Sketch, end: float, expected: dict[str, int]) -> None:
    sketch.path((0, end), Layer.GROUND, 0.3)
    arrow(sketch, 1, 12)
    assert kinds(sketch) == expected


@pytest.mark.parametrize(("start", "expected"), [(-5j, {"radii": 1}), (5j, {})])
def test_a_radius_over_a_rod(sketch: Sketch, start: complex, expected: dict[str, int]) -> None:
    sketch.circle(0, 20, Layer.DISC)
    sketch.path((10 + start, 10 + 15j), Layer.LINK)
    dimension(sketch, 0, 20)
    assert kinds(sketch) == expected


@pytest.mark.parametrize(("off", "expected"), [(0.5, {"grazing": 1}), (4.0, {})])
def test_a_radius_along_the_rim_of_another_wheel(sketch: Sketch, off: float, expected: dict[str, int]) -> None:
    sketch.circle(10 + (6 + off) * 1j, 6, Layer.DISC)
    dimension(sketch, 0, 30)
    assert kinds(sketch) == expected


@pytest.mark.parametrize(("radius", "expected"), [(4.0, {"small": 1}), (9.0, {})])
def test_an_arc_on_a_plate(sketch: Sketch, radius: float, expected: dict[str, int]) -> None:
    sketch.path((-20 - 20j, 20 - 20j, 20 + 20j, -20 + 20j), Layer.DISC, closed=True, fill="shade")
    turn(sketch, 0, radius)
    assert kinds(sketch) == expected


@pytest.mark.parametrize(
    ("radius", "rims", "expected"), [(22.0, (), {"foreign": 1}), (8.0, (), {}), (22.0, (20.0,), {})]
)
def test_an_arc_outside_a_wheel_is_of_the_wheel(
    sketch: Sketch, radius: float, rims: tuple[float, ...], expected: dict[str, int]
) -> None:
    sketch.arc(Arc(0, 20, Layer.DISC, BOLD, 0.0, math.tau))
    turn(sketch, 0, radius, rims, 0.8)
    assert kinds(sketch) == expected


def test_every_kind_has_its_words() -> None:
    found = inspect_arrows(Drawing(10.0, 10.0, (), ()))
    assert len(found.by_kind) == len(astuple(found)) == 8
