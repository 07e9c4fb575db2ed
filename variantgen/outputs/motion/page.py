"""The page of the plots: the mechanism with the paths of its points, a panel per unit, a caption."""

from __future__ import annotations

import math
from typing import Any

from variantgen.outputs.motion.caption import SIZE, caption_lines
from variantgen.outputs.motion.panels import MechanismPicture, draw_panel
from variantgen.outputs.motion.plotted_curves import panels
from variantgen.outputs.motion.subject import Subject

WIDTH = 7.2  # of the page, inches
_ROW, _MARGINS = 2.05, (0.62, 0.14)  # height of a row of panels, inches; left and right of a panel
_BROAD, _TALLEST = 1.9, 3.1  # proportion of a picture that wants a row of its own; largest height of that, inches
_HEAD, _LEGEND, _FOOT, _LINE, _GAP = 0.42, 0.40, 0.45, 0.155, 0.15


def page(subject: Subject, remark: str) -> Any:
    """A figure of matplotlib; ``remark`` stands beside the title.

    The mechanism has a row of its own where its picture is broad and where the number of panels is even.
    """
    from matplotlib.figure import Figure

    shown, constants = panels(subject.variant, subject.driver_sweep, subject.asked, subject.language)
    clipped = any(subject.range_of(panel)[2] for panel in shown)
    caption = caption_lines(subject, constants, clipped, WIDTH - sum(_MARGINS))
    picture = MechanismPicture(subject)
    broad = len(shown) % 2 == 0 or picture.proportion > _BROAD
    own = min(_TALLEST, (WIDTH - sum(_MARGINS)) / picture.proportion) + _GAP if broad else 0.0
    cells = len(shown) + (0 if broad else 1)
    rows = math.ceil(cells / 2)
    height = _HEAD + own + rows * (_ROW + _LEGEND) + _FOOT + _LINE * len(caption) + 0.12
    figure = Figure(figsize=(WIDTH, height))
    title = subject.variant.family.title(subject.language.name)
    figure.text(_MARGINS[0] / WIDTH, 1 - 0.2 / height, title, size=12.5, va="center")
    figure.text(1 - _MARGINS[1] / WIDTH, 1 - 0.2 / height, remark, size=8, va="center", ha="right", color="0.4")
    for number, line in enumerate(caption):
        figure.text(_MARGINS[0] / WIDTH, (0.10 + _LINE * (len(caption) - 1 - number)) / height, line, size=SIZE)
    top = height - _HEAD
    half, whole = WIDTH / 2 - sum(_MARGINS), WIDTH - sum(_MARGINS)
    if broad:
        picture.draw(_axes(figure, _MARGINS[0], top - own + _GAP, whole, own - _GAP))
    else:
        picture.draw(_axes(figure, _MARGINS[0], top - _ROW - _LEGEND, half, _ROW + _LEGEND))
    for cell, panel in enumerate(shown, 0 if broad else 1):
        row, column = divmod(cell, 2)
        bottom = top - own - (row + 1) * (_ROW + _LEGEND)
        # A panel that would be alone in its row takes all of it.
        width = whole if cell == cells - 1 and column == 0 else half
        axes = _axes(figure, _MARGINS[0] + column * WIDTH / 2, bottom, width, _ROW)
        draw_panel(subject, axes, panel, row == rows - 1)
    return figure


def _axes(figure: Any, left: float, bottom: float, width: float, height: float) -> Any:
    """Axes at a place in inches."""
    across, up = figure.get_size_inches()
    return figure.add_axes((left / across, bottom / up, width / across, height / up))
