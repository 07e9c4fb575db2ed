"""A rope: its straight pieces and what is wound on circles keep their length together."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import Maybe, added, product
from variantgen.mechanism.constructions.tangent import thread_direction
from variantgen.methods.coordinates.heading import Heading
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Point

if TYPE_CHECKING:
    from variantgen.mechanism.joints.rope import Bend, Rope
    from variantgen.methods.coordinates.model import Model

_STEADY = 1e-9  # of the velocities: a piece that swings less keeps its direction


def state(model: Model, joint: Rope, template: None) -> None:
    """``sum l_j + wound arcs = const``, with ``l = (x_2 - x_1) cos theta + (y_2 - y_1) sin theta``."""
    if joint.closing:
        return
    terms: list[tuple[int, Maybe]] = []
    constant = 0.0
    for first, second in pairwise(joint.path):
        length, exact = _piece(model, joint, first, second)
        terms += length
        constant += exact
    for bend, sign in ((joint.path[0], 1), (joint.path[-1], -1)):
        if bend.body is not None:
            side = _side(model, bend)
            terms.append((round(sign * side), product(_radius(model, bend), model.swept(bend.body))))
    ends = [Point(bend.point) for bend in (joint.path[0], joint.path[-1])]
    model.add("belt" if joint.belt else "rope", added(*terms), model.offset(constant), first=ends[0], second=ends[1])


def _side(model: Model, bend: Bend) -> float:
    return float(model.task.scene.frame.sense * bend.side)


def _radius(model: Model, bend: Bend) -> Expression:
    """The radius of a drum or a pulley; the sheet of a scene calls that of a pulley at rest by its point."""
    if bend.body is None and model.task.is_own_scene:
        return Value(Name("radius", bend.point), "length", model.length(bend.radius))
    return model.radius(bend.body, bend.point, model.length(bend.radius))


def _piece(model: Model, joint: Rope, first: Bend, second: Bend) -> tuple[list[tuple[int, Maybe]], float]:
    """The length of a straight piece, with the arcs that its swing winds up; and its part of the constant."""
    ends = [(model.task.now.z[b.point], model.length(b.radius), _side(model, b)) for b in (first, second)]
    ray = complex(thread_direction(*ends[0], *ends[1])[0])
    parallel = joint.way(first, second) is not None
    if parallel:
        ray = complex(joint.pieces(model.task.at)[joint.path.index(first)][0])
    shifts = [model.shift(first.point, second.point, axis) for axis in (0, 1)]
    exact = (model.now(first.point, second.point) * ray.conjugate()).real
    if parallel or _is_steady(model, first, second, ray):
        way = Heading(None, degrees(ray)).ray(model.one)
        return [(1, product(shift, part)) for shift, part in zip(shifts, way, strict=True)], exact
    turn = model.coordinate(Name("swing", first.point + second.point), "angle", 0.0)
    along, across = (Heading(turn, degrees(ray) + by).ray(model.one) for by in (0.0, 90.0))
    # The centres are as far from the line of the rope as their radii say.
    gap = (model.now(first.point, second.point) * (1j * ray).conjugate()).real
    left = added(*((1, product(shift, part)) for shift, part in zip(shifts, across, strict=True)))
    model.add(
        "belt_tangent" if joint.belt else "tangent",
        left,
        model.offset(gap),
        first=Point(first.point),
        second=Point(second.point),
    )
    lengths: list[tuple[int, Maybe]] = [(1, product(s, part)) for s, part in zip(shifts, along, strict=True)]
    wound = [(round(sign * _side(model, bend)), bend) for sign, bend in ((1, second), (-1, first)) if bend.radius]
    return [*lengths, *((sign, product(_radius(model, bend), turn)) for sign, bend in wound)], exact


def _is_steady(model: Model, first: Bend, second: Bend, ray: complex) -> bool:
    """Whether a piece keeps its direction."""
    now = model.task.now
    tables = [now.v, now.a] if now.accelerated else [now.v]
    for table in tables:
        ends = [0j if bend.fixed else table[bend.point] for bend in (first, second)]
        swing = ((ends[1] - ends[0]) * (1j * ray).conjugate()).real
        if abs(swing) > _STEADY * max(abs(vector) for vector in table.values()):
            return False
    return True
