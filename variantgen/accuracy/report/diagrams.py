"""The diagrams: error against time per variant, error against condition number, error against time of a passage."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from variantgen.accuracy.integration.compare import DIRECT, PassageErrors
from variantgen.accuracy.integration.integrate import METHODS
from variantgen.accuracy.measure import Errors, discovered
from variantgen.accuracy.report.plot_style import STABILISED, PlotStyle, plot_styles
from variantgen.accuracy.report.result_rows import ResultRow, by_class
from variantgen.accuracy.run import Measurement, PassageResult
from variantgen.errors import missing_package
from variantgen.mechanism.arithmetic import EPS

NAMES = ("work_precision", "conditioning", "motion")
_LEAST = 1e-21  # errors below are drawn there
_INCHES = (7.5, 8.6)
_SETTINGS = {
    "font.size": 8,
    "axes.titlesize": 8.5,
    "axes.linewidth": 0.6,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "lines.linewidth": 0.9,
    "legend.fontsize": 7.5,
    "pdf.fonttype": 42,
    "svg.fonttype": "none",
}


def need_matplotlib() -> None:
    """Raise ToolMissingError where matplotlib is not installed."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise missing_package("the diagrams need", "matplotlib", "accuracy") from None


def draw(measured: Measurement, folder: Path) -> list[str]:
    """Draw all diagrams into a folder, as PDF and PNG; returns the names of the files."""
    need_matplotlib()
    import matplotlib

    made = []
    with matplotlib.rc_context(_SETTINGS):
        for name, make in zip(NAMES, (_work_precision, _conditioning, _motion), strict=True):
            figure = make(measured)
            for suffix in ("pdf", "png"):
                path = folder / f"{name}.{suffix}"
                metadata = {"CreationDate": None} if suffix == "pdf" else {"Software": None}
                figure.savefig(path, dpi=150, metadata=metadata)
                made.append(path.name)
    return made


def _panels(count: int, columns: int, inches: tuple[float, float]) -> tuple[Any, list[Any]]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=inches, layout="constrained")
    axes = figure.subplots(math.ceil(count / columns), columns, sharex=True, sharey=True, squeeze=False)
    flat = list(axes.ravel())
    for axis in flat:
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.grid(visible=True, which="major", linewidth=0.3, color="0.85")
        axis.tick_params(which="both", direction="in", width=0.5)
    for axis in flat[count:]:
        axis.set_axis_off()
    for k in range(count - columns, count):
        flat[k].tick_params(labelbottom=True)
    return figure, flat[:count]


def _mark(axis: Any, x: float, y: float, look: PlotStyle, label: str = "") -> None:
    axis.plot(
        [x], [y], marker=look.marker, linestyle="none", markersize=5.5, color=look.colour,
        markerfacecolor=look.colour if look.filled else "white", markeredgewidth=1.0, zorder=3 + look.filled,
    )  # fmt: skip


def _handles(styles: dict[str, PlotStyle], names: dict[str, str]) -> list[Any]:
    from matplotlib.lines import Line2D

    return [
        Line2D(
            [], [], linestyle="none", marker=look.marker, markersize=5.5, color=look.colour, label=names[name],
            markerfacecolor=look.colour if look.filled else "white",
        )
        for name, look in styles.items()
    ]  # fmt: skip


def _titles() -> dict[str, str]:
    return {name: str(way.SHORT) for name, way in discovered().items()}


def _work_precision(measured: Measurement) -> Any:
    """Error against time per variant, a panel for each class: median, and a line up to the largest error."""
    figure, axes = _panels(len(measured.classes), 3, _INCHES)
    styles = plot_styles(list(discovered()))
    for axis, case in zip(axes, measured.classes, strict=True):
        axis.set_title(case.title, loc="left")
        for line in by_class(case):
            _way(axis, line, styles[line.way])
        axis.axhline(EPS, color="0.4", linewidth=0.6, linestyle=(0, (1, 2)))
    roomy = axes[min(1, len(axes) - 1)]  # near dead points no double comes down there
    roomy.annotate("ε of doubles", (1.0, EPS), xycoords=("axes fraction", "data"), xytext=(-3, 2),
                   textcoords="offset points", ha="right", fontsize=6.5, color="0.3")  # fmt: skip
    axes[0].set_ylim(_LEAST, 1e3)
    axes[0].set_xlim(0.03, 1e4)
    figure.supxlabel("time per variant, microseconds", fontsize=8.5)
    figure.supylabel(
        "relative error of the accelerations: median (mark) to largest (end of the line); −n %: share without a result",
        fontsize=8.5,
    )
    figure.legend(handles=_handles(styles, _titles()), loc="outside upper center", ncols=4, frameon=False)
    return figure


def _way(axis: Any, line: ResultRow, look: PlotStyle) -> None:
    """One way in one class, with the share of the variants for which it fails."""
    if not (math.isfinite(line.acceleration) and math.isfinite(line.microseconds)):
        return
    median, most = (min(max(y, _LEAST), 1e3) for y in (line.acceleration, line.acceleration_most))
    axis.plot([line.microseconds] * 2, [median, most], color=look.colour, linewidth=0.8, zorder=2)
    axis.plot([line.microseconds], [most], marker="_", color=look.colour, markersize=5, zorder=2)
    _mark(axis, line.microseconds, median, look)
    lost = line.variants - line.solved
    if lost:
        # Production and the closed form stand close together: their shares are written to either side.
        shift, side = {"production": (5, "left"), "closed_form": (-4, "right")}.get(line.way, (0, "center"))
        axis.annotate(
            f"−{max(1.0, 100 * lost / line.variants):.0f} %", (line.microseconds, median), xytext=(shift, -10),
            textcoords="offset points", ha=side, fontsize=6, color=look.colour,
        )  # fmt: skip


def _conditioning(measured: Measurement) -> Any:
    """Error against condition number, a panel for each way: all variants of all classes."""
    names = list(discovered())
    figure, axes = _panels(len(names), 2, (_INCHES[0], 9.4))
    markers = plot_styles([case.title for case in measured.classes])
    span = np.array([1.0, 1e25])
    for axis, name in zip(axes, names, strict=True):
        axis.set_title(discovered()[name].SHORT, loc="left")
        for case in measured.classes:
            _cloud(axis, [e for e in case.errors if e.way == name], markers[case.title])
        axis.plot(span, EPS * span, color="black", linewidth=0.7)
        axis.plot(span, 32 * EPS * span, color="black", linewidth=0.7, linestyle="--")
    axes[0].set_xlim(0.7, 1e17)
    axes[0].set_ylim(_LEAST, 1e3)
    figure.supxlabel("condition number κ of the accelerations", fontsize=8.5)
    figure.supylabel("relative error of the accelerations", fontsize=8.5)
    handles = _handles(markers, {case.title: case.title for case in measured.classes})
    handles += _line_handles({"-": "κ ε", "--": "32 κ ε"})
    figure.legend(handles=handles, loc="outside upper center", ncols=4, frameon=False)
    return figure


def _cloud(axis: Any, errors: Iterable[Errors], look: PlotStyle) -> None:
    points = [(kappa[1], row[2]) for e in errors for kappa, row in zip(e.kappas, e.rows, strict=True)]
    if points:
        x, y = np.array(points).T
        axis.plot(
            x, np.clip(y, _LEAST, 1e3), linestyle="none", marker=look.marker, markersize=2.6, color=look.colour,
            markerfacecolor=look.colour if look.filled else "none", markeredgewidth=0.5,
        )  # fmt: skip


def _motion(measured: Measurement) -> Any:
    """Error against time of a whole passage, a panel for each: a line over the tolerances for each method."""
    columns = 2
    rows = math.ceil(len(measured.trips) / columns)
    figure, axes = _panels(len(measured.trips), columns, (_INCHES[0], 1.2 + 2.5 * rows))
    styles = plot_styles([DIRECT, *METHODS])
    for axis, trip in zip(axes, measured.trips, strict=True):
        axis.set_title(f"{trip.title} (stiffness ratio {_power(trip.stiffness)})", loc="left")
        for method, look in styles.items():
            for stabilisation in STABILISED:
                _trajectory(axis, trip, method, stabilisation, look)
    axes[0].set_ylim(1e-17, 1e2)
    figure.supxlabel("time for the whole passage, seconds", fontsize=8.5)
    figure.supylabel("largest relative error of the velocities at the instants", fontsize=8.5)
    words = {"none": "not stabilised", "Baumgarte": "Baumgarte", "projection": "projected"}
    handles = _handles(styles, {name: name for name in styles})
    handles += _line_handles({line: words[key] for key, line in STABILISED.items()})
    figure.legend(handles=handles, loc="outside upper center", ncols=5, frameon=False)
    return figure


def _line_handles(words: dict[str, str]) -> list[Any]:
    from matplotlib.lines import Line2D

    return [Line2D([], [], color="black", linestyle=line, label=label) for line, label in words.items()]


def _trajectory(axis: Any, trip: PassageResult, method: str, stabilisation: str, look: PlotStyle) -> None:
    """The results of a method over the tolerances, where there are any."""
    found = [r for r in trip.results if r.method == method and r.stabilisation == stabilisation and _drawn(r)]
    if not found:
        return
    axis.plot(
        [r.seconds for r in found], [max(r.velocity, 1e-17) for r in found], linestyle=STABILISED[stabilisation],
        marker=look.marker, markersize=6 if method == DIRECT else 3.2, color=look.colour, linewidth=0.7,
        markerfacecolor=look.colour if look.filled else "white", markeredgewidth=0.7,
    )  # fmt: skip


def _drawn(result: PassageErrors) -> bool:
    return not result.failed and math.isfinite(result.velocity)


def _power(x: float) -> str:
    exponent = math.floor(math.log10(x)) if x > 0 else 0
    return f"{x:.0f}" if abs(exponent) < 3 else f"{x / 10**exponent:.1f}·10$^{{{exponent}}}$"
