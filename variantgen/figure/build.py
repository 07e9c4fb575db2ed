"""The figure of a statement: the mechanism to scale in its position, with everything given and nothing else."""

from __future__ import annotations

import importlib
import math
from collections.abc import Mapping, Sequence
from functools import cache, cached_property, partial
from types import MappingProxyType, ModuleType

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.families.hints import DIRECTIONS
from variantgen.families.quantities import Quantity, split_name
from variantgen.figure.axes import draw_axes, has_axes
from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, MEDIUM, Drawing, Layer
from variantgen.figure.graph import with_graphs
from variantgen.figure.guide_angles import draw_guide_angle
from variantgen.figure.lettered_sketch import finish
from variantgen.figure.links import draw_links, draw_walls
from variantgen.figure.making import Making, made
from variantgen.figure.marks import draw_angle, draw_disc_name, draw_length, draw_radius, draw_right_angle
from variantgen.figure.points import draw_points
from variantgen.figure.sketch import Sketch
from variantgen.figure.symbols.gears import contour, is_moving
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import Motion, take_scene
from variantgen.mechanism.rows import Constraint
from variantgen.mechanism.scene import Scene
from variantgen.variants.printed_data import given_names, shown_points
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language
from variantgen.wording.scene_data import guide_inclinations

_WIDE, _HIGH, _AREA = 74.0, 66.0, 74.0 * 52.0  # room for the mechanism itself: its sides (u), its area (u^2)
_WIDEST, _HIGHEST = 94.0, 88.0  # room for everything but labels, u


@cache
def _symbol_module(stem: str) -> ModuleType:
    return importlib.import_module(f"variantgen.figure.symbols.{stem}")


def statement_figure(
    variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language, grids: bool = True
) -> Drawing:
    """The drawing of one variant; ``index`` is its place in the batch ``motion`` (positions are enough).

    Below it are the graph of a given rate, and the empty ``grids`` of the curves that are to be sketched.

    Raises InputError where there is nothing to draw or points that a symbol needs apart coincide (the screens keep
    drawn variants away from that; data fixed by hand may lead there).
    """
    return made(draw_statement(variant, motion, index, asked, language, grids))


def draw_statement(
    variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language, grids: bool = True
) -> Making:
    """The same in the making."""
    board = Mechanism(variant, motion, index, asked, language).board()
    lettered = yield board.draft()
    tell = partial(_alt_text, board, asked)
    figure = replace(lettered.drawing, tell=tell, language=language.name, poses=board.poses)
    return with_graphs(figure, variant, language, grids)


def _alt_text(board: Board, asked: Sequence[Quantity]) -> str:
    """What a statement figure shows, in words."""
    # Here, because most programs draw figures and tell of none.
    from variantgen.figure.alt_text.description import describe

    return describe(board, asked)


def finished(board: Board) -> Drawing:
    """The drawing of a board: labels placed, everything in order; without an alternative text."""
    return finish(board.sketch, board.draft().named)


class Mechanism(Struct, frozen=True, dict=True):
    """A variant of a solved batch, what is asked of it and in which language: what all its figures have in common."""

    variant: Variant
    motion: Motion
    index: int
    asked: Sequence[Quantity]
    language: Language

    @cached_property
    def shown(self) -> tuple[str, ...]:
        """The points that figures show. Raises InputError where there is none."""
        shown = tuple(shown_points(self.variant, self.asked))
        if not shown:
            raise InputError(Problem("every point is hidden", key="figure.hidden", value=self.variant.family.name))
        return shown

    @cached_property
    def places(self) -> dict[str, complex]:
        """The places of all points (m)."""
        return {name: complex(places[self.index]) for name, places in self.motion.z.items()}

    @cached_property
    def radii(self) -> list[float]:
        """The radii of the discs (m)."""
        form = self.variant.form
        values = form.values({name: self.variant.si(name) for name in form.parameters}) if form.figure.discs else {}
        return [float(disc.radius.value(values)) for disc in form.figure.discs]

    @cached_property
    def scene(self) -> Scene:
        """The numbers of the variant; a figure needs no constructions: where points are is known."""
        return take_scene(replace(self.motion.scene, points={}, conditions=()), self.index, self.motion.size)

    @cached_property
    def linkage(self) -> Linkage:
        """The mechanism as a reader sees it."""
        return Linkage(self.scene)

    def board(
        self,
        marks: bool = True,
        size: float = 1.0,
        scale: float | None = None,
        poses: Mapping[str, float] = MappingProxyType({}),
    ) -> Board:
        """The mechanism on a board, its labels not yet placed: the figure of a statement or the base of another.

        Without ``marks`` it shows no data: no angles, lengths, radii, axes, no arrows of given motion. ``size`` is its
        size in proportion to that in the statement, a ``scale`` (u per metre) is kept whether it fits or not. Supports
        stand as the ``poses`` say, where they say it. Raises InputError like :func:`statement_figure`.
        """
        try:
            return self._drawn(marks, scale, poses) if scale else self._fitted(marks, size, poses)
        except (ZeroDivisionError, OverflowError):
            raise InputError(
                Problem(
                    "cannot be drawn: points that its symbols need apart coincide, or its proportions are extreme",
                    key="figure",
                    value=self.variant.family.name,
                    remedy="change the data, or the hints of the family that name these points",
                )
            ) from None

    def _fitted(self, marks: bool, size: float, poses: Mapping[str, float]) -> Board:
        """The mechanism of a size with which it has room."""
        discs = zip(self.variant.form.figure.discs, self.radii, strict=True)
        circles = [(self.places[disc.centre], radius) for disc, radius in discs if not disc.arc]
        scale = size * _scale([self.places[name] for name in self.shown], circles)
        while True:
            board = self._drawn(marks, scale, poses, most=1.0)
            excess = _excess(board.sketch)
            if excess <= 1:
                return board
            # Walls, guides and ropes, seldom data, reach beyond the paper: it is all drawn smaller.
            scale *= 0.98 / excess

    def _drawn(self, marks: bool, scale: float, poses: Mapping[str, float], most: float = math.inf) -> Board:
        """The mechanism at a scale; without data where it alone takes more than its room, times ``most``."""
        form, asked = self.variant.form, self.asked
        sketch = Sketch({name: scale * place for name, place in self.places.items()}, scale)
        given = frozenset(given_names(self.variant, asked)) if marks else frozenset()
        second = any(quantity.order == 2 for quantity in asked)
        board = Board(sketch, self.linkage, form, self.language, self.shown, second, given)
        board.poses.update(poses)
        on_paper = [radius * scale for radius in self.radii]
        _draw_mechanism(board, on_paper, marks)
        if most == math.inf or _excess(sketch) <= most:
            _draw_data(board, on_paper, marks)
            if marks and self.variant.family.is_scene:
                for point, angle in guide_inclinations(self.variant, asked, self.language):
                    draw_guide_angle(board, point, angle)
            seen = [*asked, *map(split_name, form.figure.sketch)]
            if marks and has_axes(seen):
                draw_axes(board, seen)
        return board


def _excess(sketch: Sketch) -> float:
    """How many times a drawing is larger than the room for everything but labels."""
    if not sketch.lines:
        return 0.0
    low, high = sketch.corners()
    return max((high - low).real / _WIDEST, (high - low).imag / _HIGHEST)


def _draw_mechanism(board: Board, radii: Sequence[float], marks: bool) -> None:
    """The mechanism with what has its place by it, given angles and arrows; ``radii`` (u) are those of the discs."""
    sketch, form, given = board.sketch, board.form, board.given
    for disc, radius in zip(form.figure.discs, radii, strict=True):
        if disc.arc:
            continue
        rim = contour(board, disc.centre, radius)
        weight = BOLD if disc.body or is_moving(board, disc.centre, radius) else MEDIUM
        sketch.circle(sketch.at[disc.centre], rim, Layer.DISC, weight)
        board.discs.setdefault(disc.body, []).append(radius)
    draw_walls(board)
    draw_links(board)
    for driver in board.scene.drivers if marks else ():
        _occupy_directions(board, driver)
    for angle in form.figure.angles:
        if angle.name in given:
            draw_angle(board, angle)
    for corner in form.figure.right_angles if marks else ():
        if {corner.at, corner.start, corner.end} <= {*board.shown, *DIRECTIONS, *form.figure.hidden}:
            draw_right_angle(board, corner)
    for driver in board.scene.drivers:
        _draw_parts(board, driver)
    for joint in board.scene.joints:
        if not _seeks_room(joint):
            _draw_symbol(board, joint)
    for driver in board.scene.drivers if marks else ():
        if not _seeks_room(driver):
            _draw_symbol(board, driver)


def _draw_data(board: Board, radii: Sequence[float], marks: bool) -> None:
    """Dimensions, names of discs and points, and what seeks room; labels are only asked for."""
    form = board.form
    for length in form.figure.lengths:
        if length.name in board.given:
            draw_length(board, length)
    for disc, radius in zip(form.figure.discs, radii, strict=True):
        if disc.name in board.given:
            concentric = [r for other, r in zip(form.figure.discs, radii, strict=True) if other.centre == disc.centre]
            draw_radius(board, disc, radius, concentric)
        draw_disc_name(board, disc, radius)
    for joint in board.scene.joints:
        if _seeks_room(joint):
            _draw_symbol(board, joint)
    draw_points(board, board.shown)
    if marks:
        # Last, because arcs of rotation go where there is room left.
        for driver in board.scene.drivers:
            if _seeks_room(driver):
                _draw_symbol(board, driver)


def _draw_symbol(board: Board, item: Constraint) -> None:
    _symbol_of(item).draw(board, item)


def _draw_parts(board: Board, item: Constraint) -> None:
    """What of a driver is a part of the mechanism (a hydraulic cylinder), before the symbols that seek room."""
    parts = getattr(_symbol_of(item), "draw_parts", None)
    if parts is not None:
        parts(board, item)


def _occupy_directions(board: Board, item: Constraint) -> None:
    """Note the directions of arrows that stand for lines of reference of angles."""
    directions = getattr(_symbol_of(item), "directions", None)
    for point, way in directions(board, item) if directions is not None else ():
        board.sketch.occupy(point, way)


def _symbol_of(item: Constraint) -> ModuleType:
    return _symbol_module(type(item).__module__.rsplit(".", 1)[-1])


def _seeks_room(item: Constraint) -> bool:
    """Whether a symbol is free to choose its side, and so waits until what has no choice is drawn."""
    return bool(getattr(_symbol_of(item), "SEEKS_ROOM", False))


def _scale(places: Sequence[complex], discs: Sequence[tuple[complex, float]]) -> float:
    """Figure units per metre, so that the mechanism, or the way from the origin to a lone point, fills its box."""
    corners = [*places, *(c + r * d for c, r in discs for d in (1 + 1j, -1 - 1j))]
    if len({*corners}) == 1:
        corners.append(0j)
    width = max(c.real for c in corners) - min(c.real for c in corners)
    height = max(c.imag for c in corners) - min(c.imag for c in corners)
    limits = [limit / side for limit, side in ((_WIDE, width), (_HIGH, height)) if side]
    if not limits:
        return 1.0  # a point at the origin
    return min([*limits, math.sqrt(_AREA / (width * height)) if width * height else math.inf])
