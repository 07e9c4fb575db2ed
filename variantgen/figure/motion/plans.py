"""Plans of vectors: rays from a pole to scale, the vectors between their ends, construction lines, a scale."""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal

import numpy as np
from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.families.parameters.units import Unit
from variantgen.families.parameters.units import unit as unit_of
from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Drawing, Layer
from variantgen.figure.making import Unlettered, made
from variantgen.figure.placement.label_requests import LabelRequest, Places, along_line, around, label_size
from variantgen.figure.placement.least_crowded import first_clean
from variantgen.figure.sketch import DOT, Sketch
from variantgen.methods.graphical.plan_scale import MILLIMETRES, per_millimetre, places_of
from variantgen.methods.graphical.vector_chain import VectorChain
from variantgen.methods.linkage.instant import Instant
from variantgen.wording.formula import Equation, Formula, FormulaList, Measured, Symbol
from variantgen.wording.language import Language

_BEYOND = (6.0, 3.0, 9.0, 4.5)  # how far a construction line runs on, tried until all letters find room, u
COINCIDENT = 1.3  # points of a plan that are nearer to each other than this have one place, u
EQUAL = 1e-6  # relative difference below which two vectors are said to be equal
_ASIDE = 2.4  # between a vector and one that lies on it, u
_ALONG = math.radians(2.5)
_BAR = 26.0  # longest scale bar, u
_BELOW = 7.5  # between plan and scale bar, u


class PlanVector(Struct, frozen=True):
    """An arrow of a plan from ``start`` to ``end`` (m/s or m/s^2 from the pole); ``whole`` for one from the pole."""

    start: complex
    end: complex
    symbol: Symbol
    whole: bool = False


class VectorPlan(Struct):
    """What a plan shows: letters at ends of vectors, the vectors, construction lines (end, direction), edges of plates.

    Everything in m/s or m/s^2 from the pole.
    """

    pole: Symbol
    ends: list[tuple[Symbol, complex]] = field(default_factory=list)
    vectors: list[PlanVector] = field(default_factory=list)
    lines: list[tuple[complex, complex]] = field(default_factory=list)
    edges: list[tuple[complex, complex]] = field(default_factory=list)

    @property
    def extent(self) -> list[complex]:
        """All places, the pole among them."""
        return [0j, *(end for _, end in self.ends), *(p for vector in self.vectors for p in (vector.start, vector.end))]


class PlanScale(Struct, frozen=True):
    """One millimetre on paper stands for ``value`` of ``unit``."""

    value: Decimal
    unit: Unit

    @property
    def figure_units(self) -> float:
        """Figure units per m/s (or m/s^2)."""
        return 1 / (self.unit.to_si(self.value) * MILLIMETRES)


def scale_of_plan(chain: VectorChain, now: Instant, order: int, unit: Unit) -> PlanScale:
    """The round scale of a plan, in the printed unit."""
    places = [place * unit.from_si(1.0) for place in places_of(chain, now, order)]
    return PlanScale(per_millimetre(places), unit)


def draw_plan(plan: VectorPlan, scale: PlanScale, language: Language) -> Drawing:
    """The finished plan, to the given scale."""
    return made(first_clean(_drawn(plan, scale, language, beyond) for beyond in _BEYOND))


def _drawn(plan: VectorPlan, printed: PlanScale, language: Language, beyond: float) -> Unlettered:
    """The plan, with construction lines that run on so far beyond the ends."""
    scale = printed.figure_units
    sketch = Sketch({"pole": 0j}, scale)
    ends = _gathered([(plan.pole, 0j), *((symbol, scale * end) for symbol, end in plan.ends)])
    vectors = [PlanVector(scale * v.start, scale * v.end, v.symbol, v.whole) for v in plan.vectors]
    vectors = [v for v in vectors if abs(v.end - v.start) >= COINCIDENT]
    crowded = [place for place, symbols in ends if len(symbols) > 1]
    for end, way in plan.lines:
        # What coincides anyway is not found by lines that meet.
        if all(abs(scale * end - place) >= COINCIDENT for place in crowded):
            _draw_construction(sketch, scale * end, way, beyond)
    for start, end in plan.edges:
        if abs(end - start) * scale > COINCIDENT:
            sketch.path((scale * start, scale * end), Layer.MARK, THIN)
    _draw_vectors(sketch, vectors)
    sketch.circle(0j, DOT, Layer.HINGE, fill="ink")
    for place, symbols in ends:
        names: Formula = symbols[0] if len(symbols) == 1 else FormulaList(tuple(symbols))
        sketch.label(around(names, place, 0.7))
    _draw_scale(sketch, printed, language)
    return Unlettered(sketch, {str(i): place for i, (place, _) in enumerate(ends)})


def _gathered(named: Sequence[tuple[Symbol, complex]]) -> list[tuple[complex, list[Symbol]]]:
    """Letters by place; places too near to each other to be distinguished are one."""
    found: list[tuple[complex, list[Symbol]]] = []
    for symbol, place in named:
        near = next((symbols for at, symbols in found if abs(at - place) < COINCIDENT), None)
        if near is None:
            found.append((place, [symbol]))
        elif symbol not in near:
            near.append(symbol)
    return found


def _draw_construction(sketch: Sketch, end: complex, way: complex, beyond: float) -> None:
    """The line of a known direction, on beyond the end of its vector, which it helps to find."""
    if abs(way) > 0:
        way /= abs(way)
        sketch.path((end - beyond * way, end + beyond * way), Layer.GROUND, THIN, dash="dashed")


def _draw_vectors(sketch: Sketch, vectors: Sequence[PlanVector]) -> None:
    """The rays from the pole, then what lies between their ends; what coincides is one arrow with all names."""
    drawn: list[PlanVector] = []
    for vector in sorted(vectors, key=lambda v: not v.whole):
        if any(_coincide(vector, other) for other in drawn):
            continue
        formula = _names([v for v in vectors if _coincide(vector, v)])
        aside = _aside(vector, drawn)
        start, end = vector.start + aside, vector.end + aside
        weight = BOLD if vector.whole else MEDIUM
        sketch.arrow(start, end, Layer.VECTOR, weight, min(2.6, 0.5 * abs(end - start)))
        sketch.label(_beside(formula, start, end, _free_from(vector, vectors)))
        drawn.append(PlanVector(start, end, vector.symbol, vector.whole))


def _names(vectors: Sequence[PlanVector]) -> Formula:
    """The name of one arrow for vectors that cannot be distinguished: an equation only where they are equal."""
    first, *others = vectors
    if not others:
        return first.symbol
    length = abs(first.end - first.start)
    if all(abs((v.end - v.start) - (first.end - first.start)) < EQUAL * length for v in others):
        return Equation(first.symbol, others[0].symbol)
    return FormulaList(tuple(v.symbol for v in vectors))


def _coincide(first: PlanVector, second: PlanVector) -> bool:
    """Whether two vectors have the same ends, as far as the eye can tell."""
    return abs(first.start - second.start) < COINCIDENT and abs(first.end - second.end) < COINCIDENT


def _aside(vector: PlanVector, drawn: Sequence[PlanVector]) -> complex:
    """How far a part must be moved so as not to lie on what is drawn already; a ray stays."""
    if vector.whole:
        return 0j
    way = (vector.end - vector.start) / abs(vector.end - vector.start)
    for step in (0j, 1j * way, -1j * way, 2j * way, -2j * way):
        moved = PlanVector(vector.start + _ASIDE * step, vector.end + _ASIDE * step, vector.symbol)
        if not any(_covers(moved, other) for other in drawn):
            return _ASIDE * step
    return 0j


def _covers(first: PlanVector, second: PlanVector) -> bool:
    """Whether two vectors lie on one line with a good part of the first on the second."""
    way = (second.end - second.start) / abs(second.end - second.start)
    start, end = ((p - second.start) / way for p in (first.start, first.end))
    if max(abs(start.imag), abs(end.imag)) > 0.9:
        return False
    low, high = sorted((start.real, end.real))
    shared = min(high, abs(second.end - second.start)) - max(low, 0.0)
    return shared > 0.3 * abs(first.end - first.start) or shared > 4.0


def _free_from(vector: PlanVector, others: Sequence[PlanVector]) -> complex:
    """Where the name of a ray should begin: past the ends of shorter rays on the same line."""
    length = abs(vector.end)
    if not vector.whole:
        return vector.start
    shorter = [
        abs(o.end) for o in others if o.whole and abs(o.end) < length - 7 and abs(np.angle(o.end / vector.end)) < _ALONG
    ]
    return max(shorter, default=0.0) / length * vector.end


def _beside(formula: Formula, start: complex, end: complex, free: complex) -> LabelRequest:
    """A name beside a vector; ``free`` is where the part begins at which it may stand."""
    if abs(end - free) > 3.0:
        near, far = along_line(formula, free, end), along_line(formula, free, end, 2.6)
        whole = along_line(formula, start, end)
        places = np.concatenate((near.places, far.places, whole.places))
        costs = np.concatenate((near.costs, far.costs + 5.0, whole.costs + 7.0))
        return LabelRequest(formula, near.anchor, places, costs, near.extent)
    return along_line(formula, start, end)


def round_length(most: float) -> Decimal:
    """The largest of 1, 2, 5, 10, 20, ... (and of their tenths) that is not above a number."""
    power = Decimal(10) ** math.floor(math.log10(most))
    return max(
        step * power for step in (Decimal(1), Decimal(2), Decimal(5)) if float(step * power) <= most * (1 + 1e-12)
    )


def _draw_scale(sketch: Sketch, scale: PlanScale, language: Language) -> None:
    """A bar below the plan whose length is a round number of units; beside it what a millimetre of the sheet means."""
    unit = scale.unit
    value = round_length(unit.from_si(_BAR / sketch.scale))
    length = unit.to_si(value) * sketch.scale
    low, _ = sketch.corners()
    start = low - 1j * _BELOW
    end = start + length
    sketch.path((start, end), Layer.MARK, THIN)
    for place in (start, end):
        sketch.path((place - 0.9j, place + 0.9j), Layer.MARK, THIN)
    own = Measured(language.decimal(value), language.unit(unit))
    width, _ = label_size(own)
    sketch.label(_beside_bar(own, start, end, np.array([end + 0.5 * width + off for off in (1.4, 2.4, 4.0)])))
    one = Measured(language.decimal(Decimal(1)), language.unit(unit_of("mm")))
    meaning = Equation(one, Measured(language.decimal(scale.value), language.unit(unit)))
    wide, high = label_size(meaning)
    below = np.array([start + 0.5 * wide - 1j * (0.5 * high + off) for off in (2.2, 3.2, 5.0)])
    sketch.label(_beside_bar(meaning, start, end, below))


def without_millimetres(drawing: Drawing) -> Drawing:
    """A drawing that will not be printed in the usual size: what a millimetre means there is left out."""
    return replace(drawing, labels=tuple(label for label in drawing.labels if not _tells_millimetres(label.formula)))


def _tells_millimetres(formula: Formula) -> bool:
    return isinstance(formula, Equation) and isinstance(formula.left, Measured)


def _beside_bar(formula: Formula, start: complex, end: complex, places: Places) -> LabelRequest:
    """A label with its places, best first."""
    return LabelRequest(formula, 0.5 * (start + end), places, 0.5 * np.arange(len(places), dtype=np.float64))
