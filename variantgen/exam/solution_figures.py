"""The figures of a solution: that of the statement and those which its steps name, in rows, with captions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from variantgen.exam.solution_paper import COLUMN, WIDTH
from variantgen.families.quantities import Quantity, split_name
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import LETTER, Drawing
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.graph import solved_grid
from variantgen.figure.inspection.faults import figure_faults, vector_faults
from variantgen.figure.letters.letter_run import INDEX
from variantgen.figure.making import Making, tried
from variantgen.figure.motion.motion_data import MovingMechanism
from variantgen.figure.views import view
from variantgen.mechanism.motion import Motion
from variantgen.methods.graphical.plan_scale import MILLIMETRES
from variantgen.methods.steps.step_geometry import NOTHING_MARKED
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Formula, Symbol
from variantgen.wording.language import Language
from variantgen.wording.solution.document import SolutionText
from variantgen.wording.solution.phrases import Letter, SentenceField, load_phrases
from variantgen.wording.solution.quantity_symbols import Symbols
from variantgen.wording.text import Text

STATEMENT = "statement"
CURVE = "curve"  # of a quantity that is to be sketched
LEAST_INDEX = 7.0  # size of the indices of figures, pt
_MOST = 3  # figures in a row
# mm per unit: of the statement's figure usually, and beside others at least; of the others at least, so that an index
# has 7 pt, and at most, so that no letter is much larger than the text.
_STATEMENT_UNIT, _SMALLEST, _UNIT, _LARGEST = 0.62, 0.5, 0.83, 1.05
# mm: a column of the text, which figures fill if they become no higher than this; how high those are that would.
_WIDE, _HIGH, _TALL = 86.0, 96.0, 88.0
_PLAN_UNIT = MILLIMETRES  # mm per unit of a plan: lengths that the text tells are measured in it
_POINTS = 72 / 25.4  # in a millimetre
_BETWEEN = 4.0  # mm: figures in a row


class SolutionFigure(Struct, frozen=True):
    """A figure of a solution: its kind, the drawing, its caption and, for paper, millimetres per figure unit."""

    name: str
    drawing: Drawing
    caption: Text
    unit: float

    @property
    def least(self) -> float:
        """The fewest millimetres per unit: lengths are read from a plan, others have letters that can be read."""
        return self.unit if self.name.endswith("_plan") else min(self.unit, _UNIT)

    @property
    def index_size(self) -> float:
        """The size of its indices on paper in points."""
        return LETTER * INDEX * self.unit * _POINTS


def view_order(text: SolutionText) -> list[str]:
    """The kinds of figures that a solution needs, each once, in the order of the steps; the statement's first."""
    return list(dict.fromkeys([STATEMENT, *(name for section in text.sections for name in section.views)]))


class SolutionFigures:
    """The figures of one problem, drawn once each; ``place`` is its motion and its index in that batch.

    ``numbers`` are those of the kinds that could be drawn, from 1 on. ``known`` is the figure of the statement, where
    it has been drawn before; the others show the vectors and centres of the solution ``text`` (none: the natural one).
    """

    def __init__(
        self,
        variant: Variant,
        asked: Sequence[Quantity],
        language: Language,
        place: tuple[Motion, int],
        known: Drawing | None = None,
        text: SolutionText | None = None,
    ) -> None:
        self.variant, self.asked, self.language = variant, asked, language
        self.numbers: dict[str, int] = {}
        self._place, self._vectors = place, text.vectors if text else ()
        self._geometry = text.geometry if text else {}
        self._true_scale = bool(text and text.true_scale)
        self._shown = (*asked, *(text.centres if text else ()))
        self._mechanism = MovingMechanism(variant, *place, self._shown, language)
        self._drawn: dict[str, Drawing] = {} if known is None else {STATEMENT: known}

    def draw(self, names: Sequence[str]) -> None:
        """Draw what is not drawn yet. Raises InputError if the statement's figure cannot be drawn."""
        draw_together([(self, names)])

    def begun(self, names: Sequence[str]) -> dict[str, Making]:
        """What is not drawn yet in the making; the statement's figure is drawn, as others need it.

        Raises InputError if that cannot be.
        """
        missing = [name for name in names if name not in self._drawn]
        if missing and STATEMENT not in self._drawn:
            statement = statement_figure(self.variant, *self._place, self.asked, self.language, grids=False)
            self._drawn[STATEMENT] = statement
        return {name: self._making(name) for name in missing if name != STATEMENT}

    def keep(self, names: Sequence[str], drawn: Mapping[str, Drawing]) -> None:
        """Number the figures of these names; there is none of a kind of which there was nothing to draw."""
        self._drawn |= drawn
        for name in names:
            if name in self._drawn:
                self.numbers.setdefault(name, len(self.numbers) + 1)

    def _making(self, name: str) -> Making:
        """One figure by its name, but that of the statement. Raises InputError where there is nothing to draw."""
        kind, _, which = name.partition(":")
        marked = self._geometry.get(name, NOTHING_MARKED)
        if kind == CURVE:
            drawn: Drawing = solved_grid(self.variant, which, self.language)
            return drawn
        if which:
            subject = FigureSubject(self._mechanism, self._drawn[STATEMENT].poses, marked, self._true_scale)
            found: Drawing = yield from view(kind).draw(subject, self._vectors, which)
            return found
        scaled = {} if kind.endswith("_plan") else {"true_scale": self._true_scale, "geometry": marked}
        whole: Drawing = view(kind).draw(
            self.variant, *self._place, self._shown, self.language, self._vectors, **scaled
        )
        return whole

    def rows(self) -> tuple[tuple[SolutionFigure, ...], ...]:
        """Rows of figures as they fit beside each other on paper."""
        rows: list[list[str]] = [[]]
        for name in self.numbers:
            if rows[-1] and not self._fit([*rows[-1], name]):
                rows.append([])
            rows[-1].append(name)
        return tuple(tuple(self._one(name, self._shared(row)) for name in row) for row in rows)

    def _one(self, name: str, shared: float) -> SolutionFigure:
        unit = round(shared, 3) if name == STATEMENT else self._unit(name)
        return SolutionFigure(name, self._drawn[name], self._caption(name), unit)

    def _caption(self, name: str) -> Text:
        """The number and title of a figure, and which centres lie outside it; what curves are over is said once."""
        phrases = load_phrases(self.language.name)
        found: list[str | Formula] = [f"{phrases.words['figure']}\N{NO-BREAK SPACE}{self.numbers[name]}. "]
        kind, _, which = name.partition(":")
        curves = [other for other in self.numbers if other.startswith(f"{CURVE}:")]
        key = "further_curve" if name in curves[1:] else kind
        for part in phrases.sentence(f"figures.{key}"):
            found += [part] if isinstance(part, str) else self._fact(part, kind, which)
        if self._drawn[name].lengthened:
            found += [" ", *(part for part in phrases.sentence("figures.lengthened") if isinstance(part, str))]
        letters = self._drawn[name].beyond if name != STATEMENT else ()
        if letters:
            listed = [part for letter in letters for part in (", ", letter)][1:]
            found.append(" ")
            for part in phrases.sentence("figures.beyond"):
                found += [part] if isinstance(part, str) else listed
        return tuple(found)

    def _fact(self, part: Letter | SentenceField, kind: str, which: str) -> Sequence[str | Formula]:
        """The point that the equation of a figure is about, its body, or the quantity of a curve."""
        if isinstance(part, Letter):
            return (Symbol(part.name),)
        if kind == CURVE:
            return (self.language.quantity(split_name(which), self.variant.form.symbols),)
        if part.name == "point":
            return (Symbol(self._vectors[view(kind).ORDER - 1].equations[int(which) - 1].point),)
        symbols = Symbols(self.variant.form, self.language, load_phrases(self.language.name), {})
        return symbols.body(which, part.form)

    def _shared(self, row: Sequence[str]) -> float:
        """The scale of the statement's figure in a row, mm per unit: the others have theirs."""
        taken = sum(self._unit(name) * self._width(name) for name in row if name != STATEMENT)
        free = sum(self._width(name) for name in row if name == STATEMENT)
        room = WIDTH - _BETWEEN * (len(row) - 1) - taken
        return min(_STATEMENT_UNIT, room / free) if free else (_STATEMENT_UNIT if room >= 0 else 0.0)

    def _fit(self, row: Sequence[str]) -> bool:
        """Whether figures have room beside each other."""
        return len(row) <= _MOST and self._shared(row) >= _SMALLEST

    def _width(self, name: str) -> float:
        """The width of a figure in its units, as it is written out."""
        return round(self._drawn[name].width, 2)

    def _unit(self, name: str) -> float:
        """Millimetres per unit of a figure: lengths are read from a plan, so that its scale is not free."""
        if name.endswith("_plan"):
            return _PLAN_UNIT
        drawing = self._drawn[name]
        unit = _WIDE / drawing.width
        if unit * drawing.height > _HIGH:
            unit = min(unit, _TALL / drawing.height)
        return round(min(max(_UNIT, min(_LARGEST, unit)), COLUMN / drawing.width), 3)


def draw_together(wanted: Sequence[tuple[SolutionFigures, Sequence[str]]]) -> None:
    """Draw what figures of some problems have not drawn yet of these names: together they cost less.

    Raises InputError if the figure of a statement cannot be drawn.
    """
    begun = [(figures, figures.begun(names)) for figures, names in wanted]
    drawn = iter(tried([making for _, makings in begun for making in makings.values()]))
    for (figures, makings), (_, names) in zip(begun, wanted, strict=True):
        found = {name: next(drawn) for name in makings}
        # Where there is nothing of the kind to draw (all velocities zero) the text says so.
        figures.keep(names, {name: one for name, one in found.items() if isinstance(one, Drawing)})


def solution_figure_faults(
    variant: Variant, motion: Motion, asked: Sequence[Quantity], language: Language, text: SolutionText
) -> Iterator[str]:
    """What is wrong with the figures of a solution but that of the statement, in words."""
    figures = SolutionFigures(variant, asked, language, (motion, 0), None, text)
    figures.draw(view_order(text))
    for figure in (figure for row in figures.rows() for figure in row if figure.name != STATEMENT):
        faults = [*figure_faults(figure.drawing), *vector_faults(figure.drawing)]
        # A plan is as large as its scale says.
        if round(figure.index_size, 1) < LEAST_INDEX and not figure.name.endswith("_plan"):
            faults.append(f"its indices have {figure.index_size:.1f} pt, fewer than {LEAST_INDEX:g}")
        yield from (f"the figure {figure.name} of the solution ({language.name}): {fault}" for fault in faults)
