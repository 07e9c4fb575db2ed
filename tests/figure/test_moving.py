"""The figure in many positions: it lies where it says, at one scale, and what rests does not move."""

from __future__ import annotations

import numpy as np
import pytest

from variantgen.figure.drawing import Arc, Layer, Path
from variantgen.figure.moving import Moving
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.scene import fixed_points
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.driver_sweep import driver_sweep
from variantgen.wording.language import load_language

FAMILIES = [
    "four_bar",
    "slider_crank",
    "planetary_train",
    "rolling_wheel",
    "cam_disc",
    "hydraulic_hoist",
    "three_rod_plate",
]


def moving(family: str) -> tuple[Moving, int]:
    variant = one_variant(family, seed="moving")
    asked = asked_quantities(variant)
    sweep = driver_sweep(variant, asked, 91).sweep
    return Moving(variant, sweep.motion, asked, load_language("en")), sweep.instant


def hinges(lines: object) -> set[complex]:
    found = [line for line in lines if isinstance(line, Arc) and abs(line.radius - HINGE) < 1e-9]  # type: ignore[attr-defined]
    return {complex(round(line.centre.real, 3), round(line.centre.imag, 3)) for line in found}


def rounded(place: complex) -> complex:
    return complex(round(place.real, 3), round(place.imag, 3))


@pytest.mark.parametrize("family", FAMILIES)
def test_the_picture_lies_where_it_says(family: str) -> None:
    figure, instant = moving(family)
    drawing, paper = figure.still(instant)
    corners = {rounded(p) for line in drawing.lines if isinstance(line, Path) for p in line.points}
    centres = {rounded(line.centre) for line in drawing.lines if isinstance(line, Arc)}
    drawn = figure.paths.keys() - set(figure.variant.form.figure.stems)  # a bearing has no point
    for name, z in ((name, figure.paths[name]) for name in sorted(drawn)):
        assert rounded(complex(paper.at(z[instant : instant + 1])[0])) in corners | centres, name
    # Neither the probe nor marks of data are left.
    assert not any(
        isinstance(line, Path) and len(line.points) == 3 and line.points[0] == line.points[2] for line in drawing.lines
    )
    assert not any(line.layer == Layer.MARK for line in drawing.lines)


@pytest.mark.parametrize("family", FAMILIES)
def test_a_film_keeps_scale_and_place(family: str) -> None:
    figure, instant = moving(family)
    indices = [*range(0, 91, 15), instant]
    resting, frames, labels, paper = figure.film(indices, instant)
    assert labels
    held = fixed_points(figure.motion.scene)
    members = {name for body in figure.motion.scene.bodies.values() for name in body}
    for index, lines in zip(indices, frames, strict=True):
        drawn = hinges(lines) | hinges(resting)
        for name in (held & members) - set(figure.variant.form.figure.hidden):
            assert rounded(complex(paper.at(figure.motion.z[name][index : index + 1])[0])) in drawn, (name, index)
        assert all(Layer.GROUND < line.layer < Layer.MARK for line in lines)
    # The circle that keeps the scale is not in the film.
    widest = (
        max(line.radius for line in (*resting, *frames[0]) if isinstance(line, Arc)) if family != "four_bar" else 0.0
    )
    low, high = figure.corners(paper)
    assert widest < 0.5 * abs(high - low)


def test_walls_reach_as_far_as_sliders_go() -> None:
    figure, instant = moving("slider_crank")
    resting, _, _, paper = figure.film(range(91), instant)
    places = paper.at(figure.motion.z["B"])
    way = places[np.argmax(places.real + places.imag)] - places[np.argmin(places.real + places.imag)]
    way /= abs(way)
    along = [
        sorted((point * way.conjugate()).real for point in line.points)
        for line in resting
        if isinstance(line, Path) and line.layer == Layer.GROUND and len(line.points) == 2
        if abs(((line.points[1] - line.points[0]) * way.conjugate()).imag) < 1e-6
    ]
    low, high = max(along, key=lambda ends: ends[1] - ends[0])
    every = (places * way.conjugate()).real
    assert low < every.min() - 2 and high > every.max() + 2
    assert high - low < np.ptp(every) + 25  # and not much farther


def test_a_slot_in_a_moving_body_moves() -> None:
    """The middle of the arc of a yoke is a point of it."""
    figure, instant = moving("arc_yoke")
    indices = range(0, 91, 9)
    resting, frames, _, paper = figure.film(indices, instant)
    assert not any(isinstance(line, Arc) and line.layer == Layer.GROUND for line in resting)
    for index, lines in zip(indices, frames, strict=True):
        centres = {rounded(line.centre) for line in lines if isinstance(line, Arc) and line.layer == Layer.GROUND}
        assert centres == {rounded(complex(paper.at(figure.motion.z["D"][index : index + 1])[0]))}


def test_paths_are_those_of_the_moving_points() -> None:
    figure, _ = moving("four_bar")
    assert set(figure.paths) == {"A", "B"}
    radius = np.abs(figure.paths["A"] - figure.motion.z["O"])
    assert np.ptp(radius) < 1e-12
