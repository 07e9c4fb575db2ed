"""The motion of a variant as the page Play shows it: figures of all positions, vectors, centres and curves as data.

Places are in figure units (u), x to the right and y down, as SVG counts; every list over the way of the driver has one
entry for each position, None where there is no value.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from itertools import pairwise
from typing import Any

import numpy as np
from msgspec.structs import replace

from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity, motion_order
from variantgen.figure.drawing import Layer, Line, Path
from variantgen.figure.moving import Paper
from variantgen.mechanism.centres import velocity_centre
from variantgen.mechanism.motion import ComplexField, Motion
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.methods.graphical.plan_scale import pole_letter
from variantgen.outputs.figures.svg import lettering
from variantgen.outputs.motion.caption import end_sentences
from variantgen.outputs.motion.plotted_curves import PlottedCurve, panels
from variantgen.outputs.motion.ranges import visible_range
from variantgen.outputs.motion.subject import Subject
from variantgen.studio.moving_lines import box_about, drawn, frames_of, pen, places, polyline
from variantgen.variants.driver_sweep import driver_sweep
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Equation, Measured, Symbol
from variantgen.wording.html import to_html
from variantgen.wording.language import load_language

_LONGEST = 18.0  # of a vector, but for a quarter of the positions, where it may grow beyond all bounds, u
_USUAL = 0.75
_LONGEST_NOW = 28.0  # at the instant of the problem, u
_SAME = 1e-6  # of the size of the mechanism, or of the largest vector
_FAR = 2.5  # from the middle of the picture, in its diagonals: centres beyond are not shown
_CURVES = 8
_KINDS = {
    "velocity": "vel",
    "angular velocity": "vel",
    "acceleration": "acc",
    "angular acceleration": "acc",
}


def motion_of(variant: Variant, asked: Sequence[Quantity], language: str) -> dict[str, Any]:
    """What the page needs to show a variant in motion. Raises InputError where nothing moves.

    Where no acceleration is asked the drivers move uniformly: what is not printed is nobody's business.
    """
    if motion_order(asked) == 1:
        variant = _uniform(variant)
    spoken = load_language(language)
    subject = Subject(variant, driver_sweep(variant, asked), asked, spoken)
    sweep, moving = subject.driver_sweep.sweep, subject.moving
    still, frames, labels, paper = moving.film(range(len(sweep.way)), sweep.instant)
    paths = [paper.at(z) for z in moving.paths.values()]
    ground = [paper.at(z) for z in moving.ground]
    velocities, accelerations = _vectors(subject, paper, "v"), _vectors(subject, paper, "a")
    ends = [np.array(one.pop("ends"), dtype=np.complex128) for one in (velocities, accelerations)]
    box = box_about(still, [*paths, *ends, np.array(moving.corners(paper))])
    return {
        "title": variant.family.title(language),
        "box": box,
        "ground": drawn(line for line in still if line.layer == Layer.GROUND) + [pen(polyline(z)) for z in ground],
        "bases": drawn(line for line in still if line.layer != Layer.GROUND),
        **frames_of(frames),
        "driver": _driver(subject, frames[sweep.instant], paper),
        "names": [
            {"text": lettering(name), "point": places(point), "at": places(z)}
            for name, point, z in moving.names(labels, paper)
        ],
        "paths": [polyline(z) for z in paths],
        "centres": _centres(subject, paper, box),
        "velocities": velocities,
        "accelerations": accelerations,
        **_curves(subject),
        "way": _way(subject),
    }


def _uniform(variant: Variant) -> Variant:
    """A variant whose drivers have no accelerations."""
    none = dict.fromkeys(variant.form.of_accelerations_alone, Decimal(0))
    return replace(variant, printed={**variant.printed, **none})


def _driver(subject: Subject, lines: Sequence[Line], paper: Paper) -> list[str]:
    """The line of the link that is driven, in each position; nothing where it is not drawn as one line."""
    motion, target = subject.driver_sweep.sweep.motion, subject.driver_sweep.target
    if len(target) != 1 or target[0] not in motion.scene.bodies:
        return []
    at = subject.driver_sweep.sweep.instant
    members = [name for name in motion.scene.bodies[target[0]] if name in subject.shown]
    links = [line.points for line in lines if isinstance(line, Path) and line.layer == Layer.LINK]
    for first in members:
        for second in members:
            ends = (complex(paper.at(motion.z[first])[at]), complex(paper.at(motion.z[second])[at]))
            if any(len(p) == 2 and abs(p[0] - ends[0]) + abs(p[1] - ends[1]) < 1e-3 for p in links):
                both = zip(paper.at(motion.z[first]), paper.at(motion.z[second]), strict=True)
                return [polyline(np.array(pair)) for pair in both]
    return []


def _vectors(subject: Subject, paper: Paper, kind: str) -> dict[str, Any]:
    """Velocities (``v``) or accelerations (``a``) of the moving points, to one scale, and the plan of them.

    ``start`` is where a vector begins in the plan, if not at the pole: the parts of a motion along a moving body follow
    each other from the end of the transport part to that of the whole. ``edges`` joins the numbers of points of one
    body, for the plan; ``ends`` (u) is what the picture has to have room for.
    """
    sweep, symbols = subject.driver_sweep.sweep, subject.variant.form.symbols
    motion, clear = sweep.motion, sweep.clear
    table = motion.v if kind == "v" else motion.a
    none: ComplexField = np.zeros(len(clear), dtype=np.complex128)
    found = [(point, f"{kind}_{point}", "", table[point], none) for point in _telling(subject, table)]
    for point, body in sliding_points(motion.scene).items():
        if point in subject.shown:
            parts = relative_motion(motion, point, body)
            rel, cor = (parts.velocity, none) if kind == "v" else (parts.acceleration, parts.coriolis)
            if rel is not None and cor is not None:
                found.append((point, f"{kind}_rel_{point}", "rel", rel, table[point] - rel))
                if kind == "a":
                    found.append((point, f"a_cor_{point}", "cor", cor, table[point] - rel - cor))
    sizes = np.max([np.where(clear, np.abs(one[3]), 0.0) for one in found] or [np.zeros(len(clear))], axis=0)
    usual = float(np.quantile(sizes[clear], _USUAL)) if clear.any() else 0.0
    if not usual:
        return {"vectors": [], "edges": [], "ends": [], "pole": ""}
    scale = min(_LONGEST / usual, _LONGEST_NOW / max(float(sizes[sweep.instant]), 1e-9 * usual))
    shown, ends = [], []
    for point, name, part, z, start in found:
        at, by = paper.at(motion.z[point]), np.where(clear, scale * z, np.nan)
        ends += (at + by)[clear & (np.abs(by) <= _LONGEST)].tolist()
        shown.append(
            {
                "text": lettering(subject.language.symbol(name, symbols)),
                "end": "" if part else lettering(_small(subject, point)),
                "kind": part,
                "at": places(at),
                "by": places(by),
                "start": places(np.where(clear, scale * start, np.nan)) if part else None,
            }
        )
    whole = [point for point, _, part, *_ in found if not part]
    pole = pole_letter(whole) if kind == "v" else "pi"
    edges = _edges(motion.scene.bodies, whole)
    return {"vectors": shown, "edges": edges, "ends": ends, "pole": lettering(Symbol(pole))}


def _small(subject: Subject, point: str) -> Symbol:
    """The letter of a point in a plan."""
    symbol = subject.language.symbol(point, subject.variant.form.symbols)
    return Symbol(symbol.base.lower(), symbol.index)


def _telling(subject: Subject, table: Mapping[str, ComplexField]) -> list[str]:
    """The moving points with different vectors: of a body that only shifts, one."""
    names = [name for name in subject.moving.paths if name in table]
    largest = max((float(np.nanmax(np.abs(table[name]))) for name in names), default=0.0)
    first = sorted(names, key=lambda name: all(quantity.point != name for quantity in subject.asked))
    found: list[str] = []
    for name in first:
        if all(float(np.nanmax(np.abs(table[name] - table[other]))) > _SAME * largest for other in found):
            found.append(name)
    return [name for name in names if name in found]


def _edges(bodies: Mapping[str, Sequence[str]], points: Sequence[str]) -> list[tuple[int, int]]:
    """Pairs of neighbours among the points of each body, by their numbers."""
    found = []
    for members in bodies.values():
        own = [points.index(name) for name in members if name in points]
        found += list(pairwise(own))
    return list(dict.fromkeys(found))


def _centres(subject: Subject, paper: Paper, box: Sequence[float]) -> list[dict[str, Any]]:
    """The velocity centres that move, with their paths in the plane of the paper."""
    sweep, symbols = subject.driver_sweep.sweep, subject.variant.form.symbols
    motion: Motion = sweep.motion
    middle, far = complex(box[0] + box[2] / 2, -box[1] - box[3] / 2), _FAR * float(np.hypot(box[2], box[3]))
    found = []
    for body in motion.omega:
        centre = velocity_centre(motion, body)
        place = paper.at(centre.z)
        seen = centre.finite & sweep.clear & (np.abs(place - middle) < far)
        place = np.where(seen, place, np.nan)
        if seen.any() and float(np.ptp(place.real[seen]) + np.ptp(place.imag[seen])) > 0.01:
            name = subject.language.symbol(f"P_{body}", symbols)
            found.append({"text": lettering(name), "at": places(place), "path": polyline(place)})
    return found


def _curves(subject: Subject) -> dict[str, Any]:
    """Curves of what is asked, each with its range; what stays constant in words."""
    language, sweep = subject.language, subject.driver_sweep.sweep
    shown, constant = panels(subject.variant, subject.driver_sweep, subject.asked, language)
    # What is asked before the coordinates of points.
    ordered = [panel for panel in shown if not panel.letters] + [panel for panel in shown if panel.letters]
    found = []
    for panel in ordered:
        for curve in panel.curves:
            low, high, _ = visible_range([curve.values], sweep.instant, (not sweep.closed, not sweep.closed))
            found.append(
                {
                    "symbol": to_html(curve.formula),
                    "unit": to_html(language.unit(curve.unit)),
                    "kind": _KINDS.get(curve.unit.measures, ""),
                    "values": [float(f"{v:.5g}") if np.isfinite(v) else None for v in curve.values],
                    "range": [low, high],
                }
            )
    return {"curves": found[:_CURVES], "constant": [_said(curve, subject) for curve in constant]}


def _said(curve: PlottedCurve, subject: Subject) -> str:
    language = subject.language
    return to_html(Equation(curve.formula, Measured(language.rounded(curve.now), language.unit(curve.unit))))


def _way(subject: Subject) -> dict[str, Any]:
    """The abscissa: symbol, unit, values, the instant, where it ends and why, seconds that it takes."""
    found, measured = subject.driver_sweep, subject.variant.family.length_unit
    leading, sweep = found.sweep.leading_driver, found.sweep
    change = "" if found.given or not leading.angular else "Δ"
    driver = sweep.motion.scene.drivers[leading.number]
    moving = bool(np.any([np.any(row != 0) for row in driver.rates(1)]))
    ends = [end.value if end.value in ("dead_point", "joint") else "" for end in sweep.ends]
    return {
        "symbol": change + to_html(subject.abscissa),
        "unit": "°" if leading.angular else to_html(subject.language.unit(unit(measured))),
        "values": [float(f"{value:.5g}") for value in subject.ways],
        "instant": sweep.instant,
        "closed": sweep.closed,
        "ends": ends,
        "why": " ".join(end_sentences(subject)),
        "seconds": float(np.ptp(sweep.way)) / leading.rate if moving else None,
    }
