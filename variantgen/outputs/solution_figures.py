"""The figures of a solution: that of the statement and those which its steps name, in rows, with captions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.errors import InputError
from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import Drawing
from variantgen.figure.views import view
from variantgen.mechanism.motion import Motion
from variantgen.methods.plan_scale import MILLIMETRES
from variantgen.outputs.typesetter import figure_data
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language
from variantgen.wording.solution.document import SolutionText
from variantgen.wording.solution.phrases import load_phrases

STATEMENT = "statement"
_MOST = 3  # figures in a row
_UNIT, _SMALLEST = 0.62, 0.5  # mm per unit of a figure of the mechanism: usual, and beside others at least
_PLAN_UNIT = MILLIMETRES  # mm per unit of a plan: lengths that the text tells are measured in it
_WIDTH, _GUTTER = 180.0, 4.0  # mm


def view_order(text: SolutionText) -> list[str]:
    """The kinds of figures that a solution needs, each once, in the order of the steps; the statement's first."""
    return list(dict.fromkeys([STATEMENT, *(name for section in text.sections for name in section.views)]))


class Figures:
    """The figures of one problem; ``numbers`` are those of the kinds that could be drawn, from 1 on."""

    def __init__(
        self,
        variant: Variant,
        asked: Sequence[Quantity],
        motion: Motion,
        place: int,
        language: Language,
        names: Sequence[str],
    ) -> None:
        self._language = language
        self._drawn: list[tuple[str, Drawing]] = []
        for name in names:
            try:
                drawing = view(name).draw(variant, motion, place, asked, language)
            except InputError:
                if name == STATEMENT:
                    raise
                continue  # there is nothing of the kind to draw (all velocities zero): the text says so
            self._drawn.append((name, drawing))
        self.numbers = {name: number for number, (name, _) in enumerate(self._drawn, start=1)}

    def rows(self) -> list[list[dict[str, Any]]]:
        """Rows of figures with width in mm, millimetres per unit, and caption."""
        rows: list[list[tuple[str, Drawing]]] = [[]]
        for found in self._drawn:
            if rows[-1] and not _fits([*rows[-1], found]):
                rows.append([])
            rows[-1].append(found)
        return [[self._data(name, drawing, _shared(row)) for name, drawing in row] for row in rows]

    def _data(self, name: str, drawing: Drawing, shared: float) -> dict[str, Any]:
        phrases = load_phrases(self._language.name)
        title = "".join(part for part in phrases.sentence(f"figures.{name}") if isinstance(part, str))
        return {
            "caption": f"{phrases.words['figure']}\N{NO-BREAK SPACE}{self.numbers[name]}. {title}",
            "figure": figure_data(drawing),
            "unit": _PLAN_UNIT if _is_plan(name) else round(shared, 3),
        }


def _is_plan(name: str) -> bool:
    """Whether lengths are read from a figure, so that its scale is not free."""
    return name.endswith("_plan")


def _shared(row: Sequence[tuple[str, Drawing]]) -> float:
    """The scale of the figures of the mechanism in a row, mm per unit."""
    plans = sum(_PLAN_UNIT * drawing.width for name, drawing in row if _is_plan(name))
    free = sum(drawing.width for name, drawing in row if not _is_plan(name))
    room = _WIDTH - _GUTTER * (len(row) - 1) - plans
    return min(_UNIT, room / free) if free else (_UNIT if room >= 0 else 0.0)


def _fits(row: Sequence[tuple[str, Drawing]]) -> bool:
    """Whether figures have room beside each other."""
    return len(row) <= _MOST and _shared(row) >= _SMALLEST
