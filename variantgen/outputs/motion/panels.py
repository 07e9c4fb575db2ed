"""Panels of the plots on axes of matplotlib: curves of one unit, the mechanism with the paths of its points."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from variantgen.families.parameters.units import unit
from variantgen.figure.drawing import LETTER, Drawing, Layer
from variantgen.figure.moving import Paper
from variantgen.outputs.figures.mpl import draw_lines, points_per_unit
from variantgen.outputs.motion.plotted_curves import Panel, origin
from variantgen.outputs.motion.ranges import round_ticks, tick_texts
from variantgen.outputs.motion.subject import Subject
from variantgen.wording.formula import Equation, Symbol
from variantgen.wording.language import Language
from variantgen.wording.mathtext import to_mathtext

# Told apart without colours: style of the line, grey, width in points.
_PENS: tuple[tuple[Any, str, float], ...] = (
    ("-", "0.0", 1.3),
    ((0, (6, 2.2)), "0.0", 1.2),
    ((0, (7, 2, 1.2, 2)), "0.0", 1.2),
    ((0, (1.2, 1.5)), "0.0", 1.5),
    ("-", "0.58", 1.6),
    ((0, (4, 1.6)), "0.58", 1.6),
)
_HEAVIEST = 2.6  # points to the u
_PAPER_EDGE = 2.0  # beside the picture of the mechanism, u


def draw_panel(subject: Subject, axes: Any, panel: Panel, last: bool = True) -> None:
    """Curves of one unit, their values at the instant above the frame; the abscissa has a name where it is the last."""
    language, at = subject.language, subject.driver_sweep.sweep.instant
    ways = subject.ways
    low, high, _ = subject.range_of(panel)
    axes.axvline(ways[at], color="0.35", linewidth=0.6)
    if low < 0 < high:
        axes.axhline(0, color="0.75", linewidth=0.5, zorder=0.5)
    for curve, (style, grey, width) in zip(panel.curves, _cycled(len(panel.curves)), strict=True):
        said = to_mathtext(Equation(curve.formula, language.rounded(curve.now)))
        axes.plot(ways, curve.values, linestyle=style, color=grey, linewidth=width, label=said)
        axes.plot([ways[at]], [curve.now], "o", color=grey, markersize=3.6, clip_on=False, zorder=5)
    axes.set_ylim(low, high)
    set_ticks(axes.yaxis, round_ticks(low, high, 6, panel.unit.name == "deg"), language)
    letters = [to_mathtext(Symbol(letter)) for letter in panel.letters]
    axes.set_ylabel(", ".join([*letters, to_mathtext(language.unit(panel.unit))]), labelpad=1)
    limit_ways(subject, axes)
    if last:
        axes.set_xlabel(subject.abscissa_text, labelpad=1)
    axes.legend(
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        borderaxespad=0.0,
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
    low, high, angular = float(ways.min()), float(ways.max()), subject.driver_sweep.sweep.leading_driver.angular
    axes.set_xlim(low, high)
    set_ticks(axes.xaxis, round_ticks(low, high, 8 if angular else 6, angular), subject.language)


def set_ticks(axis: Any, ticks: Sequence[Any], language: Language) -> None:
    """Ticks with numbers in the habits of the language."""
    axis.set_ticks([float(tick) for tick in ticks], labels=tick_texts(ticks, language))


class MechanismPicture:
    """The mechanism at the instant with the paths of its points; coordinates in the unit of lengths."""

    def __init__(self, subject: Subject) -> None:
        self.subject = subject
        moving = subject.moving
        self.drawing, self.paper = moving.still(subject.driver_sweep.sweep.instant)
        self.tracks = [self.paper.at(z) for z in moving.paths.values()]
        self.corners = [0.0, complex(self.drawing.width, self.drawing.height)]
        self.corners += [z for trajectory in self.tracks for z in trajectory]

    @property
    def proportion(self) -> float:
        """Width over height."""
        every = np.array(self.corners)
        return float((np.ptp(every.real) + 2 * _PAPER_EDGE) / (np.ptp(every.imag) + 2 * _PAPER_EDGE))

    def draw(self, axes: Any) -> None:
        """Draw it on axes."""
        frame_paper(axes, self.corners, _PAPER_EDGE)
        for trajectory in self.tracks:
            axes.plot(trajectory.real, trajectory.imag, color="0.35", linewidth=0.6, zorder=1.5)
        for ground in self.subject.moving.ground:
            trajectory = self.paper.at(ground)
            axes.plot(trajectory.real, trajectory.imag, color="black", linewidth=0.9, zorder=1.6)
        draw_lines(axes, self.drawing.lines, drawing_weight(axes))
        _draw_labels(axes, self.drawing)
        _number_paper(self.subject, axes, self.paper)


def drawing_weight(axes: Any) -> float:
    """Points to the u that give lines their weight: to scale, but no thicker than in print."""
    return min(_HEAVIEST, points_per_unit(axes))


def frame_paper(axes: Any, corners: Iterable[complex], margin: float) -> None:
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


def _draw_labels(axes: Any, drawing: Drawing) -> None:
    """Labels with a rim of paper, which parts them from the paths."""
    from matplotlib.patheffects import withStroke

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
            path_effects=[withStroke(linewidth=1.8, foreground="white")],
        )


def _number_paper(subject: Subject, axes: Any, paper: Paper) -> None:
    """Ticks in the unit of lengths, counted from the origin."""
    measured = unit(subject.variant.family.length_unit)
    _, zero = origin(
        subject.variant, subject.driver_sweep.sweep.motion, subject.asked, subject.driver_sweep.sweep.instant
    )
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
