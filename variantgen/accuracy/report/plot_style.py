"""How algorithms and methods look in print: distinguished by marker and line, not by colour alone."""

from __future__ import annotations

from msgspec import Struct


class PlotStyle(Struct, frozen=True):
    """Marker, whether it is filled, colour (dark enough for grey print), line."""

    marker: str
    filled: bool
    colour: str
    line: str = "none"


_MARKERS = ("o", "s", "^", "D", "v", "P", "X", "<", ">", "h")
_COLOURS = ("#000000", "#9a3b00", "#0b5a8a", "#3d6b1f", "#7a2a6a", "#555555", "#8a6a00", "#1f6f6f")
STABILISED = {"none": "-", "Baumgarte": "--", "projection": ":"}


def plot_styles(names: list[str]) -> dict[str, PlotStyle]:
    """A look for each name, the first one filled and black."""
    return {
        name: PlotStyle(_MARKERS[k % len(_MARKERS)], k == 0, _COLOURS[k % len(_COLOURS)])
        for k, name in enumerate(names)
    }
