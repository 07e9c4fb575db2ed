"""The figure of a statement: the mechanism to scale in its position, with everything given and nothing else."""

from __future__ import annotations

import importlib
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from itertools import pairwise
from types import ModuleType

from variantgen.errors import InputError, Problem
from variantgen.families.quantities import Quantity
from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Drawing, Layer
from variantgen.figure.labels import around
from variantgen.figure.marks import draw_angle, draw_disc_name, draw_length, draw_radius
from variantgen.figure.sketch import DOT, HINGE, Sketch
from variantgen.figure.telling.description import describe
from variantgen.mechanism.motion import Motion, take_scene
from variantgen.mechanism.rows import Constraint
from variantgen.mechanism.scene import fixed_points
from variantgen.variants.needed import given_names, shown_points
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language

_BOX = complex(66.0, 50.0)  # room for the mechanism itself, u
_HALF_SLOT = 1.6


@cache
def _symbol_module(stem: str) -> ModuleType:
    return importlib.import_module(f"variantgen.figure.symbols.{stem}")


def statement_figure(
    variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language
) -> Drawing:
    """The drawing of one variant; ``index`` is its place in the batch ``motion`` (positions are enough).

    Raises InputError where there is nothing to draw or points that a symbol needs apart coincide (the screens keep
    drawn variants away from that; data fixed by hand may lead there).
    """
    try:
        return _figure(variant, motion, index, asked, language)
    except (ZeroDivisionError, OverflowError):
        raise InputError(
            Problem(
                "cannot be drawn: points that its symbols need apart coincide, or its proportions are extreme",
                key="figure",
                value=variant.family.name,
                remedy="change the data, or the hints of the family that name these points",
            )
        ) from None


def _figure(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language) -> Drawing:
    form = variant.form
    shown = shown_points(variant, asked)
    if not shown:
        raise InputError(Problem("every point is hidden", key="figure.hidden", value=variant.family.name))
    values = form.values({name: variant.si(name) for name in form.parameters})
    z = {name: complex(motion.z[name][index]) for name in motion.z}
    radii = [float(disc.radius.value(values)) for disc in form.figure.discs]
    circles = [(z[d.centre], r) for d, r in zip(form.figure.discs, radii, strict=True) if not d.arc]
    scale = _scale([z[name] for name in shown], circles)
    sketch = Sketch({name: scale * place for name, place in z.items()}, scale)
    scene = take_scene(motion.scene, index, motion.size)
    board = Board(sketch, scene, form, language, tuple(shown), any(q.order == 2 for q in asked))
    for disc, radius in zip(form.figure.discs, radii, strict=True):
        if disc.arc:
            continue
        sketch.circle(sketch.at[disc.centre], radius * scale, Layer.DISC, BOLD if disc.body else MEDIUM)
        board.discs.setdefault(disc.body, []).append(radius * scale)
    _draw_walls(board)
    _draw_links(board)
    given = set(given_names(variant, asked))
    for angle in form.figure.angles:
        if angle.name in given:
            draw_angle(board, angle)
    for driver in board.scene.drivers:
        _draw_parts(board, driver)
    for joint in board.scene.joints:
        if not _seeks_room(joint):
            _draw_symbol(board, joint)
    for length in form.figure.lengths:
        if length.name in given:
            draw_length(board, length)
    for disc, radius in zip(form.figure.discs, radii, strict=True):
        if disc.name in given:
            concentric = [
                r * scale for other, r in zip(form.figure.discs, radii, strict=True) if other.centre == disc.centre
            ]
            draw_radius(board, disc, radius * scale, concentric)
        draw_disc_name(board, disc, radius * scale)
    for joint in board.scene.joints:
        if _seeks_room(joint):
            _draw_symbol(board, joint)
    _draw_points(board, shown)
    # Last, because the arrows of given motion go where there is room left.
    for driver in board.scene.drivers:
        _draw_symbol(board, driver)
    return replace(sketch.finish({name: sketch.at[name] for name in shown}), alt=describe(board, given))


def _draw_symbol(board: Board, item: Constraint) -> None:
    _symbol_of(item).draw(board, item)


def _draw_parts(board: Board, item: Constraint) -> None:
    """What of a driver is a part of the mechanism (a hydraulic cylinder), before the symbols that seek room."""
    parts = getattr(_symbol_of(item), "draw_parts", None)
    if parts is not None:
        parts(board, item)


def _symbol_of(item: Constraint) -> ModuleType:
    return _symbol_module(type(item).__module__.rsplit(".", 1)[-1])


def _seeks_room(item: Constraint) -> bool:
    """Whether a symbol is free to choose its side, and so waits until what has no choice is drawn."""
    return bool(getattr(_symbol_of(item), "SEEKS_ROOM", False))


def _scale(places: Sequence[complex], discs: Sequence[tuple[complex, float]]) -> float:
    """Figure units per metre, so that the mechanism fills its box in one direction."""
    corners = [*places, *(c + r * d for c, r in discs for d in (1 + 1j, -1 - 1j))]
    width = max(c.real for c in corners) - min(c.real for c in corners)
    height = max(c.imag for c in corners) - min(c.imag for c in corners)
    return min(_BOX.real / width if width else 1e9, _BOX.imag / height if height else 1e9)


def _draw_links(board: Board) -> None:
    sketch = board.sketch
    for body, start, end in board.form.bars:
        a, b = sketch.at[start], sketch.at[end]
        if body in board.form.figure.slotted:
            _draw_slotted(sketch, a, b)
        else:
            sketch.path((a, b), Layer.LINK)
        sketch.occupy(start, b - a)
        sketch.occupy(end, a - b)
        for point in board.form.bodies[body][2:]:
            for far in (a, b):
                sketch.occupy(point, far - sketch.at[point])
    for names in board.form.figure.thin:
        sketch.path([sketch.at[name] for name in names], Layer.GROUND, THIN)
        _occupy_both_ways(sketch, names)
    for names in board.form.figure.lines:
        sketch.path([sketch.at[name] for name in names], Layer.LINK)
        _occupy_both_ways(sketch, names)
    for body in board.form.figure.plates:
        names = board.form.bodies[body]
        sketch.path([sketch.at[name] for name in names], Layer.DISC, closed=True, fill="shade")
        _occupy_both_ways(sketch, (*names, names[0]))

    for groove in board.form.figure.grooves:
        _draw_groove(sketch, sketch.at[groove[0]], sketch.at[groove[-1]])


def _draw_groove(sketch: Sketch, start: complex, end: complex) -> None:
    """A slot closed at both ends, over what lies below it."""
    side = _HALF_SLOT * 1j * (end - start) / abs(end - start)
    sketch.path((start - side, end - side, end + side, start + side), Layer.LINK, MEDIUM, closed=True, fill="paper")


def _occupy_both_ways(sketch: Sketch, names: Sequence[str]) -> None:
    for first, second in pairwise(names):
        step = sketch.at[second] - sketch.at[first]
        sketch.occupy(first, step)
        sketch.occupy(second, -step)


def _draw_slotted(sketch: Sketch, start: complex, end: complex) -> None:
    """A slotted arm: a bar from its pivot to the slot, then two edges closed at the ends."""
    way = (end - start) / abs(end - start)
    side, near = _HALF_SLOT * 1j * way, start + min(6.0, 0.2 * abs(end - start)) * way
    sketch.path((start, near), Layer.LINK)
    sketch.path((near - side, end - side, end + side, near + side), Layer.LINK, MEDIUM, closed=True, fill="paper")


def _draw_walls(board: Board) -> None:
    """Hatched lines, on the side away from the mechanism."""
    sketch = board.sketch
    seen = [sketch.at[name] for name in board.shown]
    middle = sum(seen) / len(seen)
    for names in board.form.figure.walls:
        for first, second in pairwise(names):
            a, b = sketch.at[first], sketch.at[second]
            normal = 1j * (b - a) / abs(b - a)
            away = -normal if ((middle - a) * normal.conjugate()).real > 0 else normal
            sketch.path((a, b), Layer.GROUND)
            sketch.hatch(a, b, away)
        _occupy_both_ways(sketch, names)


def _draw_points(board: Board, shown: Sequence[str]) -> None:
    """Hinges between links, dots on bodies, and the names."""
    sketch = board.sketch
    for point in shown:
        owners = [body for body, members in board.form.bodies.items() if point in members]
        on_disc = all(any(d.body == body for d in board.form.figure.discs) for body in owners)
        if point not in board.clear:
            if len(owners) > 1 or (on_disc and _is_axle(board, point, owners)):
                sketch.circle(sketch.at[point], HINGE, Layer.HINGE, fill="paper")
                board.sized(point, HINGE)
            elif not _is_free_end(board, point):
                sketch.circle(sketch.at[point], DOT, Layer.HINGE, fill="ink")
                board.sized(point, DOT)
        sketch.label(around(board.symbol(point), sketch.at[point], board.clear.get(point, 0.3)))


def _is_axle(board: Board, point: str, owners: Sequence[str]) -> bool:
    """Whether a disc turns about the point: its centre, unless another point of the disc is its fixed axis."""
    fixed = fixed_points(board.scene)
    held = any(name in fixed and name != point for body in owners for name in board.form.bodies[body])
    return bool(owners) and not held and board.is_disc(point)


def _is_free_end(board: Board, point: str) -> bool:
    return any(point in (start, end) for _, start, end in board.form.bars)
