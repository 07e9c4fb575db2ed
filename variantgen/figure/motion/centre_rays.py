"""Velocity centres: where the perpendiculars to the velocities of a body meet."""

from __future__ import annotations

from collections.abc import Collection

from variantgen.figure.board import Board
from variantgen.figure.drawing import THIN, Layer
from variantgen.figure.placement.label_requests import around
from variantgen.figure.sketch import DOT
from variantgen.mechanism.linkage import Linkage
from variantgen.methods.linkage.instant import Instant
from variantgen.wording.formula import Symbol
from variantgen.wording.solution.quantity_symbols import centre_letters

_REACH = 1.15  # distance of a centre that is shown from the middle of the mechanism, in sizes of the mechanism
_RAY = 16.0  # length of the ray to a centre beyond the paper, u
_SQUARE = 2.4  # side of a right-angle mark, so that it comes out of a hinge, u
_NOTHING = 1e-9  # of the largest velocity or rate
_MOST_RAYS = 3


def plane_bodies(now: Instant) -> list[str]:
    """Bodies that neither turn about a fixed point nor are kept from turning."""
    linkage = Linkage(now.scene)
    free = [body for body in now.scene.bodies if body not in linkage.translating]
    return [body for body in free if linkage.hinged.isdisjoint(now.scene.bodies[body])]


def draw_centres(board: Board, now: Instant, points: Collection[str], straight: Collection[str]) -> None:
    """Add the centre of each body in plane motion with dashed rays to its points and right angles to the velocities.

    ``points`` are those whose velocities are drawn, ``straight`` those at which they begin in the point itself.
    A centre too far away is not shown but noted as lying beyond the paper; short rays show the way to it.
    """
    sketch = board.sketch
    low, high = sketch.corners()
    middle, size = 0.5 * (low + high), max((high - low).real, (high - low).imag)
    fastest = max(abs(v) for v in now.v.values())
    places: dict[str, complex] = {}
    beyond: list[str] = []
    for body in plane_bodies(now):
        members = [name for name in now.scene.bodies[body] if name in points]
        moving = [name for name in members if abs(now.v[name]) > _NOTHING * fastest]
        if not moving:
            continue
        centre = _centre(now, body, moving[0], sketch.scale)
        if centre is not None and abs(centre - middle) < _REACH * size:
            places[body] = centre
        elif centre is not None:
            beyond.append(body)
        for name in moving[:_MOST_RAYS]:
            _draw_ray(board, now, name, body, places.get(body), name in straight)
    elsewhere = [name for name in board.shown if all(abs(sketch.at[name] - p) > DOT for p in places.values())]
    # One index for all, where there are several, though some are too far away to be shown.
    letters = centre_letters({body: board.form.symbols.get(body, body) for body in plane_bodies(now)}, elsewhere)
    for body, place in places.items():
        draw_centre(board, place, letters[body])
    sketch.beyond += [letters[body] for body in beyond]


def _centre(now: Instant, body: str, name: str, scale: float) -> complex | None:
    """The centre (u), or None where the body does not turn."""
    if abs(now.omega[body]) <= _NOTHING * max(abs(rate) for rate in now.omega.values()):
        return None
    return scale * (now.z[name] + 1j * now.v[name] / now.omega[body])


def _draw_ray(board: Board, now: Instant, name: str, body: str, centre: complex | None, marked: bool) -> None:
    """A dashed line across a velocity to the centre, or a piece of it."""
    sketch = board.sketch
    start = sketch.at[name]
    ahead = now.v[name] / abs(now.v[name])
    # The centre lies to the left of the velocity of a body that turns counter-clockwise.
    side = 1j * ahead if now.omega[body] >= 0 else -1j * ahead
    end = start + _RAY * side if centre is None else centre
    if abs(end - start) < 2 * _SQUARE:
        return
    sketch.path((start, end), Layer.GROUND, THIN, dash="dashed")
    sketch.occupy(name, end - start)
    if marked:
        corner = (start + _SQUARE * side, start + _SQUARE * (side + ahead), start + _SQUARE * ahead)
        sketch.path(corner, Layer.LINK, THIN)


def draw_centre(board: Board, place: complex, letter: Symbol) -> None:
    """A dot with its letter; a shown point of the same name at the same place says it already."""
    sketch = board.sketch
    here = [name for name in board.shown if abs(sketch.at[name] - place) < DOT]
    if not here:
        sketch.circle(place, DOT, Layer.HINGE, fill="ink")
    if all(board.symbol(name) != letter for name in here):
        clear = max((board.clear.get(name, DOT) for name in here), default=DOT)
        sketch.label(around(letter, place, clear))
