"""The velocity centre of a body on three supports: the paths of two of its points are known, a rod leads a third one.

The normals of the two paths (the rods DC and EF) meet in the centre P. The third point B moves across BP, and its
velocity has the same projection on its rod AB as that of A. So ``omega = v_B / BP``, where else two vector equations
are solved together. It applies to a wished centre, and by itself where P is near and well seen: not far beyond the
body, with an open angle between the normals, and with B far enough from P and moving along AB rather than across it.
It costs two triangles and one projection.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from variantgen.algebra.name import Name
from variantgen.methods.centres.centre import ray_to_centre
from variantgen.methods.centres.known_centre import sense_about
from variantgen.methods.centres.perpendiculars import meet
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.groups.group import PointPath, Support, ThirdClassGroup
from variantgen.methods.solution.book import Book, Known, Rate, resultant
from variantgen.methods.solution.rays import Centre
from variantgen.methods.steps.step import Body, Fact, Point, Projection, Segment, Term, VectorOf
from variantgen.methods.vectors.natural_sum import ordered_sum, signed
from variantgen.methods.vectors.point_paths import on_path
from variantgen.methods.vectors.points import vector
from variantgen.methods.vectors.vector_equation import named_shares

_FAR = 3.0  # of the extent of the body: a centre beyond that is remote
_NEAR = 0.1  # of the same: a point so near to the centre hardly moves
_OPEN = math.sin(math.radians(15.0))  # of the angle between two normals that cross clearly
_ALONG = 0.1  # cosine of the angle between a velocity and the rod on which it is projected
_CROSSING = 1e-6  # sine of the angle between two normals that cross at all


class _Guided(NamedTuple):
    """The two points with paths, and the third one with its rod."""

    paths: tuple[PointPath, PointPath]
    led: Support


def applies(book: Book, group: ThirdClassGroup) -> bool:
    """Whether the centre is wished and there, or found cheaply."""
    wished = book.style.strict and book.style.velocities == "velocity_centre"
    guided = _guided(group)
    if book.order != 1 or guided is None or book.graphics is not None or not (wished or book.style.is_free):
        return False
    now, members = book.task.now, book.task.scene.bodies[group.body]
    omega, ends = now.omega[group.body], [path.point for path in guided.paths]
    if not omega or not all(now.v[point] for point in (*ends, guided.led.point)):
        return False
    centre = now.z[ends[0]] + 1j * now.v[ends[0]] / omega
    rays = [centre - now.z[point] for point in ends]
    open_angle = abs((rays[0].conjugate() * rays[1]).imag) / abs(rays[0] * rays[1])
    rod, speed = now.z[guided.led.point] - now.z[guided.led.far], now.v[guided.led.point]
    along = abs((rod.conjugate() * speed).real) / abs(rod * speed)
    if wished:
        return min(open_angle, along) > _CROSSING
    size = max(abs(now.z[p] - now.z[q]) for p in members for q in members)
    distances = [abs(centre - now.z[point]) for point in (*ends, guided.led.point)]
    return max(distances) < _FAR * size and min(distances) > _NEAR * size and open_angle > _OPEN and along > _ALONG


def _guided(group: ThirdClassGroup) -> _Guided | None:
    """The parts of a group with two paths and one rod."""
    second, third = sorted(group.supports, key=lambda support: support.point_path is None)
    if second.point_path is None or third.point_path is not None:
        return None
    return _Guided((group.point_path, second.point_path), third)


def solve(book: Book, group: ThirdClassGroup) -> None:
    """Find the velocity of the point with the rod, and the angular velocity of the body."""
    guided = _guided(group)
    assert guided is not None
    body, point, far = group.body, guided.led.point, guided.led.far
    known = vector(book, far)
    with book.step("coupled.velocity", "velocity_centre", body=Body(body)):
        first, second = (on_path(book, path)[1] for path in guided.paths)
        centre = meet(book, body, first, second)
        book.centres[centre.key] = centre
        ray = ray_to_centre(book, centre, point, True)
        assert ray is not None, "the point moves"
        ahead = (book.exact(point).conjugate() * 1j * (centre.place(book.task) - book.task.now.z[point])).real > 0
        angle = Geometry.turned(ray.angle, 90.0 if ahead else -90.0)
        name = Name("v", point)
        way = book.term(name, None, angle, "across", segment=centre.segment(point))
        book.velocity[point] = (_with_size(book, way, centre, known, far),)
        found = book.velocity[point][0]
        assert found.size is not None
        omega = book.derive(Name("omega", body), "angular velocity", found.size / ray.arm)
        rate = book.omega[body] = Rate(omega, sense_about(ray, found))
        vector_fact = VectorOf(name)
        book.say(f"velocity_centre.{rate.word}", False, body=Body(body), centre=centre.fact, vector=vector_fact)
    for path in guided.paths:
        if path.centre and not path.body and book.order < book.task.order:  # for its normal acceleration
            vector(book, path.point)


def _with_size(book: Book, term: Term, centre: Centre, known: Known, far: str) -> Term:
    """The velocity of the point by equal projections on its rod, to the side where they are positive."""
    point = term.point
    back = (resultant(known) * book.geometry.vector(far, point).conjugate()).real < 0
    start, end = (point, far) if back else (far, point)
    axis = book.geometry.direction(start, end)
    facts: dict[str, Fact] = {"start": Point(start), "end": Point(end), "segment": Segment(far, point)}
    facts |= {"vector": VectorOf(term.name), "known": VectorOf(Name("v", far)), "ray": centre.segment(point)}
    at_far, (own,) = (named_shares(book, terms, axis, facts["segment"]) for terms in (known, (term,)))
    book.say("coupled.equal", False, **facts)
    book.items.append(Projection((), at_far, (own,), axis))
    whole = ordered_sum(signed(at_far))
    size = book.derive(term.name, "velocity", whole if own.factor is None else whole / own.factor)
    return Term(term.name, size, term.angle, term.way)
