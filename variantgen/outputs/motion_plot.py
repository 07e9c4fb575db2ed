"""Plots of the motion of a variant over the way of its driver (``show --motion``): PDF, SVG, PNG; GIF is a film.

Needs matplotlib (the extra ``plots``). Same input, same bytes: no dates, no random names.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from variantgen.errors import InputError, Problem, ToolMissingError, nearest
from variantgen.families.quantities import Quantity
from variantgen.families.units import unit
from variantgen.figure.drawing import LETTER, Drawing, Layer
from variantgen.figure.moving import Moving, Paper
from variantgen.mechanism.sweep import End
from variantgen.outputs.motion_axes import round_ticks, tick_texts, visible_range
from variantgen.outputs.motion_curves import Curve, Panel, origin, panels
from variantgen.outputs.pen import draw_lines, points_per_unit
from variantgen.variants.course import Course, course
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Equation, Formula, Index, Measured, Symbol
from variantgen.wording.language import Language, load_language
from variantgen.wording.mathtext import to_mathtext

FORMATS = ("pdf", "svg", "png", "gif")
WIDTH = 7.2  # of the page, inches
_ROW, _MARGINS = 2.05, (0.62, 0.14)  # height of a row of panels, inches; left and right of a panel
_HEAD, _LEGEND, _FOOT, _LINE = 0.42, 0.40, 0.42, 0.155
_CAPTION = 8.5  # size of the letters of the caption
# Told apart without colours: style of the line, grey, width in points.
_PENS: tuple[tuple[Any, str, float], ...] = (
    ("-", "0.0", 1.3),
    ((0, (6, 2.2)), "0.0", 1.2),
    ((0, (7, 2, 1.2, 2)), "0.0", 1.2),
    ((0, (1.2, 1.5)), "0.0", 1.5),
    ("-", "0.58", 1.6),
    ((0, (4, 1.6)), "0.58", 1.6),
)
STYLE = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9.5,
    "axes.linewidth": 0.6,
    "axes.unicode_minus": True,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "path.simplify": False,
    "pdf.fonttype": 42,
    "svg.fonttype": "path",
    "svg.hashsalt": "variantgen",
}


@dataclass(frozen=True)
class Subject:
    """What is plotted: the variant over its course, in a language."""

    variant: Variant
    course: Course
    asked: Sequence[Quantity]
    language: Language

    @property
    def hidden(self) -> tuple[str, ...]:
        """Points that the figure does not show."""
        return self.variant.form.figure.hidden

    @property
    def moving(self) -> Moving:
        """The figures of all positions."""
        return Moving(self.variant, self.course.sweep.motion, self.asked, self.language)

    def range_of(self, panel: Panel) -> tuple[float, float, bool]:
        """Limits of the ordinate of a panel, and whether very large values are cut off."""
        sweep = self.course.sweep
        dead = sweep.ends[0] is End.DEAD_POINT, sweep.ends[1] is End.DEAD_POINT
        return visible_range([curve.values for curve in panel.curves], sweep.instant, dead)

    @property
    def abscissa(self) -> Formula:
        """The symbol of the way: a printed angle, an angle turned or a displacement since the instant."""
        if self.course.given:
            return self.language.symbol(self.course.given, self.variant.form.symbols)
        words = [self.variant.form.symbols.get(name, name) for name in self.course.target]
        index = (Index("".join(words)),) if any(words) else ()
        return Symbol("phi" if self.course.sweep.lead.angular else "s", index)

    @property
    def abscissa_symbol(self) -> str:
        """The same in mathtext, as a change where an angle is counted from the instant."""
        change = "" if self.course.given or not self.course.sweep.lead.angular else r"$\Delta$"
        return change + to_mathtext(self.abscissa)

    @property
    def abscissa_text(self) -> str:
        """The label of the abscissa with its unit, in mathtext."""
        measured = unit("deg" if self.course.sweep.lead.angular else self.variant.family.length_unit)
        return f"{self.abscissa_symbol}, {to_mathtext(self.language.unit(measured))}"

    @property
    def ways(self) -> Any:
        """The abscissa of all positions in its printed unit, shape (K,)."""
        if self.course.sweep.lead.angular:
            return self.course.values
        measured = unit(self.variant.family.length_unit)
        return np.array([measured.from_si(float(value)) for value in self.course.values])


def write_motion(variant: Variant, asked: Sequence[Quantity], language_name: str, path: Path, remark: str = "") -> None:
    """Write the plots of a variant; the format follows the ending of the path.

    Raises InputError for another ending, a variant that does not move and a path that cannot be written, and
    ToolMissingError without matplotlib.
    """
    form = path.suffix.lstrip(".").lower()
    if form not in FORMATS:
        raise InputError(Problem("unknown format", key="--motion", value=path.name, remedy=nearest(form, FORMATS)))
    made = motion_bytes(variant, asked, load_language(language_name), form, remark)
    try:
        path.write_bytes(made)
    except OSError as error:
        raise InputError(Problem(f"cannot be written: {error.strerror}", key="--motion", value=str(path))) from None


def motion_bytes(variant: Variant, asked: Sequence[Quantity], language: Language, form: str, remark: str = "") -> bytes:
    """The plots of a variant as a document of one of the ``FORMATS``. Raises as :func:`write_motion` does."""
    try:
        import matplotlib as mpl
    except ImportError:
        raise ToolMissingError(
            "plots of the motion need matplotlib: install it with  pip install 'variantgen[plots]'"
        ) from None
    subject = Subject(variant, course(variant, asked), asked, language)
    with mpl.rc_context():
        # Settings of the machine must not change the page.
        mpl.rcdefaults()
        mpl.rcParams.update(STYLE)
        if form == "gif":
            from variantgen.outputs.motion_film import film

            return film(subject)
        figure = _page(subject, remark)
        stream = BytesIO()
        dates = {"pdf": {"CreationDate": None}, "svg": {"Date": None}, "png": {}}[form]
        figure.savefig(stream, format=form, metadata=dates, dpi=200)
        return stream.getvalue()


def _page(subject: Subject, remark: str) -> Any:
    """The page: the mechanism with the paths of its points, a panel per unit, a caption."""
    from matplotlib.figure import Figure

    shown, constants = panels(subject.variant, subject.course, subject.asked, subject.language)
    wide = len(shown) % 2 == 0  # then the mechanism has a row of its own
    rows = math.ceil(len(shown) / 2) if wide else math.ceil((len(shown) + 1) / 2)
    figure = Figure()
    clipped = [subject.range_of(panel)[2] for panel in shown]
    caption = caption_lines(subject, constants, any(clipped))
    own = 1.5 * _ROW if wide else 0.0
    height = _HEAD + own + rows * (_ROW + _LEGEND) + _FOOT + _LINE * len(caption) + 0.12
    figure.set_size_inches(WIDTH, height)
    title = subject.variant.family.title(subject.language.name)
    figure.text(_MARGINS[0] / WIDTH, 1 - 0.2 / height, title, size=12.5, va="center")
    figure.text(1 - _MARGINS[1] / WIDTH, 1 - 0.2 / height, remark, size=8, va="center", ha="right", color="0.4")
    for number, line in enumerate(caption):
        figure.text(_MARGINS[0] / WIDTH, (0.10 + _LINE * (len(caption) - 1 - number)) / height, line, size=_CAPTION)
    half = WIDTH / 2
    top = height - _HEAD
    if wide:
        draw_mechanism(subject, _axes(figure, _MARGINS[0], top - own, WIDTH - sum(_MARGINS), own))
        top -= own + 0.12
    cells = [(column, row) for row in range(rows) for column in (0, 1)]
    if not wide:
        column, row = cells.pop(0)
        draw_mechanism(subject, _axes(figure, _MARGINS[0], top - _ROW - _LEGEND, half - sum(_MARGINS), _ROW + _LEGEND))
    for (column, row), panel in zip(cells, shown, strict=False):
        bottom = top - (row + 1) * (_ROW + _LEGEND)
        place = (column * half + _MARGINS[0], bottom, half - sum(_MARGINS), _ROW)
        last = row == rows - 1
        draw_panel(subject, _axes(figure, *place), panel, last)
    return figure


def _axes(figure: Any, left: float, bottom: float, width: float, height: float) -> Any:
    """Axes at a place in inches."""
    across, up = figure.get_size_inches()
    return figure.add_axes((left / across, bottom / up, width / across, height / up))


def draw_panel(subject: Subject, axes: Any, panel: Panel, last: bool = True) -> None:
    """Curves of one unit, their values at the instant above the frame; the abscissa has a name where it is the last."""
    language, at = subject.language, subject.course.sweep.instant
    ways = subject.ways
    low, high, _ = subject.range_of(panel)
    axes.axvline(ways[at], color="0.35", linewidth=0.6)
    if low < 0 < high:
        axes.axhline(0, color="0.75", linewidth=0.5, zorder=0.5)
    for curve, (style, grey, width) in zip(panel.curves, _cycled(len(panel.curves)), strict=True):
        said = to_mathtext(Equation(curve.formula, language.rounded(curve.now)))
        axes.plot(ways, curve.values, linestyle=style, color=grey, linewidth=width, label=said)
        axes.plot([ways[at]], [curve.now], "o", color=grey, markersize=3.6)
    axes.set_ylim(low, high)
    set_ticks(axes.yaxis, round_ticks(low, high, 6, panel.unit.name == "deg"), language)
    letters = [to_mathtext(Symbol(letter)) for letter in panel.letters]
    axes.set_ylabel(", ".join([*letters, to_mathtext(language.unit(panel.unit))]), labelpad=1)
    limit_ways(subject, axes)
    if last:
        axes.set_xlabel(subject.abscissa_text, labelpad=1)
    axes.legend(
        loc="lower left",
        bbox_to_anchor=(-0.03, 0.985),
        ncols=2 if len(panel.curves) in (2, 4) else 3,
        frameon=False,
        fontsize=8.5,
        handlelength=2.0,
        handletextpad=0.4,
        columnspacing=1.0,
        labelspacing=0.15,
        borderpad=0.2,
    )


def _cycled(count: int) -> list[tuple[Any, str, float]]:
    return [_PENS[i % len(_PENS)] for i in range(count)]


def limit_ways(subject: Subject, axes: Any) -> None:
    """Limits and ticks of the abscissa."""
    ways = subject.ways
    low, high = float(ways.min()), float(ways.max())
    axes.set_xlim(low, high)
    set_ticks(axes.xaxis, round_ticks(low, high, 8, subject.course.sweep.lead.angular), subject.language)


def set_ticks(axis: Any, ticks: Sequence[Any], language: Language) -> None:
    """Ticks with numbers in the habits of the language."""
    axis.set_ticks([float(tick) for tick in ticks], labels=tick_texts(ticks, language))


def draw_mechanism(subject: Subject, axes: Any) -> None:
    """The mechanism at the instant with the paths of its points; coordinates in the unit of lengths."""
    sweep, moving = subject.course.sweep, subject.moving
    drawing, paper = moving.still(sweep.instant)
    tracks = {name: paper.at(z) for name, z in moving.paths.items()}
    corners = [*_corners(drawing), *(z for track in tracks.values() for z in track)]
    frame_paper(axes, corners)
    for track in tracks.values():
        axes.plot(track.real, track.imag, color="0.35", linewidth=0.6, zorder=1.5)
    draw_lines(axes, drawing.lines)
    _draw_labels(axes, drawing)
    _number_paper(subject, axes, paper)


def frame_paper(axes: Any, corners: Iterable[complex], margin: float = 2.0) -> None:
    """Limits in u that show all corners with equal scales, the whole axes in use."""
    every = np.array(list(corners))
    low, high = complex(every.real.min(), every.imag.min()), complex(every.real.max(), every.imag.max())
    box = axes.get_position()
    across, up = axes.figure.get_size_inches()
    width, height = box.width * across, box.height * up
    need = max((high.real - low.real + 2 * margin) / width, (high.imag - low.imag + 2 * margin) / height)
    middle = (low + high) / 2
    axes.set_xlim(middle.real - need * width / 2, middle.real + need * width / 2)
    axes.set_ylim(middle.imag - need * height / 2, middle.imag + need * height / 2)


def _corners(drawing: Drawing) -> list[complex]:
    """Lower left and upper right corner of a drawing."""
    return [0.0, complex(drawing.width, drawing.height)]


def _draw_labels(axes: Any, drawing: Drawing) -> None:
    size = min(11.0, max(7.5, 0.95 * LETTER * points_per_unit(axes)))
    for label in drawing.labels:
        axes.text(
            label.at.real,
            label.at.imag,
            to_mathtext(label.formula),
            size=size,
            ha="center",
            va="center",
            zorder=10 + int(Layer.LABEL),
        )


def _number_paper(subject: Subject, axes: Any, paper: Paper) -> None:
    """Ticks in the unit of lengths, counted from the origin."""
    measured = unit(subject.variant.family.length_unit)
    _, zero = origin(subject.variant, subject.course.sweep.motion, subject.asked, subject.course.sweep.instant)
    start = complex(paper.at(np.array(zero)))
    scale = paper.scale * float(measured.factor)
    for axis, limits, begin, most in (
        (axes.xaxis, axes.get_xlim(), start.real, 9),
        (axes.yaxis, axes.get_ylim(), start.imag, 6),
    ):
        ticks = round_ticks((limits[0] - begin) / scale, (limits[1] - begin) / scale, most)
        texts = tick_texts(ticks, subject.language)
        axis.set_ticks([begin + scale * float(tick) for tick in ticks], labels=texts)
    axes.tick_params(labelsize=7.5, length=2.5, pad=2)
    name = to_mathtext(subject.language.unit(measured))
    axes.set_ylabel(f"{to_mathtext(Symbol('x'))}, {to_mathtext(Symbol('y'))}, {name}", labelpad=1)


def caption_lines(subject: Subject, constants: Sequence[Curve], clipped: bool) -> list[str]:
    """The caption in lines, formulas in mathtext."""
    words, language = subject.language.words("motion"), subject.language
    symbols, sweep = subject.variant.form.symbols, subject.course.sweep
    said = [words["curves"]]
    if not subject.course.given:
        key = "turned" if sweep.lead.angular else ("moved" if len(subject.course.target) == 1 else "extended")
        points = to_mathtext(language.symbol("".join(subject.course.target), symbols))
        said.append(words[key].format(symbol=subject.abscissa_symbol, point=points))
    name, _ = origin(subject.variant, sweep.motion, subject.asked, sweep.instant)
    axes = {letter: to_mathtext(Symbol(letter)) for letter in ("x", "y")}
    said.append(words["axes"].format(origin=to_mathtext(language.symbol(name, symbols)), **axes))
    said += end_sentences(subject)
    if np.any(~sweep.clear[1:-1]):
        said.append(words["passed"])
    if clipped:
        said.append(words["clipped"])
    if constants:
        values = [Measured(language.rounded(curve.now), language.unit(curve.unit)) for curve in constants]
        equations = [to_mathtext(Equation(c.formula, value)) for c, value in zip(constants, values, strict=True)]
        said.append(f"{words['constant']} {', '.join(equations)}.")
    return _wrapped(" ".join(said), WIDTH - _MARGINS[0] - _MARGINS[1])


def _wrapped(text: str, width: float) -> list[str]:
    """Lines that are at most so many inches wide; formulas have no spaces, so that none is broken."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextToPath

    font, meter = FontProperties(size=_CAPTION), TextToPath()
    lines = [""]
    for word in text.split(" "):
        longer = f"{lines[-1]} {word}".strip()
        if meter.get_text_width_height_descent(longer, font, "$" in longer)[0] <= 72 * width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def end_sentences(subject: Subject) -> list[str]:
    """What bounds the range of the abscissa, where it is not a turn or a choice of the plot."""
    words = subject.language.words("motion")
    ends = subject.course.sweep.ends
    left, right = ends if subject.course.values[-1] >= subject.course.values[0] else ends[::-1]
    told = (End.DEAD_POINT, End.JOINT)
    if left is right and left in told:
        return [words["both"].format(end=words[left.value])]
    sides = (("left", left), ("right", right))
    return [words[side].format(end=words[end.value]) for side, end in sides if end in told]
