"""The motion of a variant as a film (GIF): the mechanism moves, a dot runs along one plot."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from typing import Any

import numpy as np

from variantgen.figure.drawing import LETTER, Layer
from variantgen.outputs.figures.mpl import draw_lines, points_per_unit
from variantgen.outputs.motion.panels import draw_panel, drawing_weight, frame_paper
from variantgen.outputs.motion.plotted_curves import panels
from variantgen.outputs.motion.subject import Subject
from variantgen.wording.mathtext import to_mathtext

_FRAMES = 60
_SIZE = (7.2, 3.5)  # inches
_DPI = 100
_PAUSE = 70  # milliseconds per picture
_GREYS = 12
_FRONT = 7.0  # order of drawing


def film(subject: Subject) -> bytes:
    """The film: a full turn, or to and fro over the range that can be reached."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=_SIZE, dpi=_DPI)
    canvas = FigureCanvasAgg(figure)
    indices = film_indices(subject)
    stage = _Stage(subject, figure, sorted(set(indices)))
    pictures: dict[int, Any] = {}
    for index in sorted(set(indices)):
        stage.show(index)
        canvas.draw()
        pictures[index] = np.asarray(canvas.buffer_rgba())[..., 0].copy()
    return _gif([pictures[index] for index in indices])


def film_indices(subject: Subject) -> list[int]:
    """Positions in the order of the film: from the instant on, in the sense of the given motion, and back to it."""
    sweep = subject.driver_sweep.sweep
    low, high = float(sweep.way[0]), float(sweep.way[-1])
    if sweep.closed:
        ways = low + (np.linspace(0.0, high - low, _FRAMES, endpoint=False) - low) % (high - low)
    else:
        step = 2 * (high - low) / _FRAMES
        legs = [(0.0, high), (high, low), (low, 0.0)]
        parts = [np.linspace(a, b, max(1, round(abs(b - a) / step)), endpoint=False) for a, b in legs if a != b]
        ways = np.concatenate(parts)
    return [int(np.argmin(np.abs(sweep.way - way))) for way in ways]


def _gif(pictures: Sequence[Any]) -> bytes:
    """Grey pictures as an endless film."""
    from PIL import Image

    frames = [Image.fromarray(picture).quantize(_GREYS) for picture in pictures]
    stream = BytesIO()
    frames[0].save(stream, "GIF", save_all=True, append_images=frames[1:], duration=_PAUSE, loop=0, optimize=True)
    return stream.getvalue()


class _Stage:
    """The figure of the film: what rests is drawn once, what moves is drawn for each picture."""

    def __init__(self, subject: Subject, figure: Any, indices: Sequence[int]) -> None:
        self.subject = subject
        sweep, moving = subject.driver_sweep.sweep, subject.moving
        resting, frames, labels, paper = moving.film(indices, sweep.instant)
        self.frames = dict(zip(indices, frames, strict=True))
        self.axes = figure.add_axes((0.015, 0.03, 0.46, 0.94))
        self.axes.set_axis_off()
        tracks = {name: paper.at(z) for name, z in moving.paths.items()}
        frame_paper(
            self.axes, [*moving.corners(paper), *(z for trajectory in tracks.values() for z in trajectory)], 7.0
        )
        for trajectory in tracks.values():
            self.axes.plot(trajectory.real, trajectory.imag, color="0.5", linewidth=0.7, zorder=1.5)
        for ground in moving.ground:
            trajectory = paper.at(ground)
            self.axes.plot(trajectory.real, trajectory.imag, color="black", linewidth=1.0, zorder=1.6)
        self.weight = drawing_weight(self.axes)
        draw_lines(self.axes, [line for line in resting if line.layer == Layer.GROUND], self.weight)
        # Bases of hinges are in front of the links that turn about them.
        draw_lines(self.axes, [line for line in resting if line.layer != Layer.GROUND], self.weight, _FRONT)
        self.names = [(to_mathtext(formula), places) for formula, _, places in moving.names(labels, paper)]
        self.size = min(11.0, max(8.0, 0.95 * LETTER * points_per_unit(self.axes)))
        self.added: list[Any] = []
        shown, _ = panels(subject.variant, subject.driver_sweep, subject.asked, subject.language)
        self.panel = next((panel for panel in shown if not panel.letters), shown[0] if shown else None)
        self.dots: list[Any] = []
        if self.panel is not None:
            plot = figure.add_axes((0.575, 0.14, 0.405, 0.72))
            draw_panel(subject, plot, self.panel)
            self.dots = [
                plot.plot([0], [curve.now], "o", color="black", markerfacecolor="white", markersize=6, zorder=9)[0]
                for curve in self.panel.curves
            ]

    def show(self, index: int) -> None:
        """Change what moves to another position."""
        for artist in self.added:
            artist.remove()
        self.added = draw_lines(self.axes, self.frames[index], self.weight)
        for text, places in self.names:
            place = places[index]
            self.added.append(
                self.axes.text(
                    place.real, place.imag, text, size=self.size, ha="center", va="center", zorder=10 + int(Layer.LABEL)
                )
            )
        if self.panel is not None:
            way = self.subject.ways[index]
            for dot, curve in zip(self.dots, self.panel.curves, strict=True):
                dot.set_data([way], [curve.values[index]])
