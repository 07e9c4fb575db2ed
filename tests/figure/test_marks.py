"""Axes, right angles, welded corners, dimension lines: there where they belong, and nowhere else."""

from __future__ import annotations

from pathlib import Path as File

import numpy as np
import pytest

from variantgen.check.family import check_family
from variantgen.families.quantities import parse_quantity
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Arc, Drawing, Layer, Path, Strokes
from variantgen.figure.inspection.faults import inspect_labels
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Symbol
from variantgen.wording.language import load_language


def figure(variant: Variant, *ask: str) -> Drawing:
    asked = [parse_quantity(text, variant.form.sample) for text in ask] or asked_quantities(variant)
    return statement_figure(variant, solve_variants([variant], 0), 0, asked, load_language("en"))


def letters(drawing: Drawing) -> set[str]:
    return {label.formula.base for label in drawing.labels if isinstance(label.formula, Symbol)}


@pytest.mark.parametrize("family", ["four_bar", "rolling_wheel", "planetary_train", "ladder", "movable_pulley"])
def test_axes_are_drawn_where_components_are_asked(family: str) -> None:
    variant = one_variant(family, seed="axes")
    point = next(q.point for q in asked_quantities(variant) if q.point)
    assert not {"x", "y"} & letters(figure(variant, f"v_{point}"))
    for component in ("x", "angle"):
        drawn = figure(variant, f"v_{point}.{component}")
        assert {"x", "y"} <= letters(drawn)
        seen = inspect_labels(drawn)
        assert not (seen.overlaps or seen.crossed or seen.outside)


def corner_marks(drawing: Drawing) -> list[Path]:
    """Open squares of thin lines."""
    return [
        line
        for line in drawing.lines
        if isinstance(line, Path) and line.layer == Layer.MARK and len(line.points) == 3 and not line.closed
    ]


def test_a_right_angle_is_marked_between_its_rays() -> None:
    variant = one_variant("sliding_block_on_rotating_rod", seed="1", form="offset")
    drawing = figure(variant)
    (mark,) = corner_marks(drawing)
    first, corner, second = mark.points
    assert ((corner - first) * np.conj(second - corner)).real == pytest.approx(0, abs=1e-9)
    motion = solve_variants([variant], 0)
    e, o, b = (drawing.scale * complex(motion.z[name][0]) + drawing.origin for name in "EOB")
    # The square lies between the arms, with its outer corner on their bisector.
    bisector = (o - e) / abs(o - e) + (b - e) / abs(b - e)
    assert ((corner - e) * np.conj(bisector)).imag == pytest.approx(0, abs=1e-6)
    assert ((corner - e) * np.conj(bisector)).real > 0
    # No hinge where the rod is bent: a filled corner.
    assert not any(isinstance(line, Arc) and abs(line.centre - e) < 1e-6 for line in drawing.lines)
    assert any(
        isinstance(line, Path) and line.fill == "ink" and abs(line.points[0] - e) < 1e-6 for line in drawing.lines
    )


def test_a_wrong_right_angle_is_noticed(tmp_path: File) -> None:
    folder = tmp_path / "skew"
    folder.mkdir()
    (folder / "family.toml").write_text(
        """schema = 1
title = { en = "Bar", ru = "Стержень" }
length_unit = "cm"
ask = ["v_A"]
[parameters]
OA = { unit = "cm", from = 20, to = 60, step = 1 }
phi = { unit = "deg", from = 30, to = 60, step = 1 }
omega_OA = { unit = "rad/s", from = 1, to = 6, step = 0.5 }
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = "OA", angle = "phi" } }
[bodies]
OA = ["O", "A"]
[[joints]]
pivot = { point = "O" }
[[drivers]]
rotation = { body = "OA", omega = "omega_OA" }
[figure]
angles = [{ name = "phi", at = "O", from = "+x", to = "A" }]
right_angles = [{ at = "O", from = "+x", to = "A" }]
""",
        "utf-8",
    )
    for language in ("en", "ru"):
        (folder / f"statement.{language}.j2").write_text("{{ OA }} {{ phi }} {{ omega_OA }}.\n", "utf-8")
    failures = check_family(str(folder / "family.toml"), seeds=20).failures
    assert any("marked as right at O is not right" in failure for failure in failures)


@pytest.mark.parametrize("seed", range(8))
def test_a_dimension_line_has_the_length_it_measures(seed: int) -> None:
    variant = one_variant("quick_return_shaper", seed=str(seed))
    drawing = figure(variant)
    heads = [
        line.points for line in drawing.lines if isinstance(line, Path) and line.layer == Layer.MARK and line.closed
    ]
    tips = [points[0] for points in heads]
    wanted = drawing.scale * variant.si("h")
    gaps = [abs(a - b) for i, a in enumerate(tips) for b in tips[:i]]
    assert min(abs(gap - wanted) for gap in gaps) < 1e-6


def _crosses(arc: Arc, start: complex, end: complex) -> bool:
    """Whether an arc crosses a short stroke: its ends are inside and outside of the circle, in the angle of the arc."""
    inside = [abs(place - arc.centre) < arc.radius for place in (start, end)]
    middle = np.exp(1j * (arc.start + arc.sweep / 2))
    turns = [np.angle((place - arc.centre) / middle) for place in (start, end)]
    return inside[0] != inside[1] and all(abs(turn) < abs(arc.sweep) / 2 for turn in turns)


@pytest.mark.parametrize(
    ("family", "form"), [("slider_crank_with_second_rod", "oblique"), ("two_loop_mechanism", "inclined")]
)
@pytest.mark.parametrize("seed", range(8))
def test_the_arc_of_an_angle_with_a_guide_does_not_cross_its_hatching(family: str, form: str, seed: int) -> None:
    drawing = figure(one_variant(family, form=form, seed=seed))
    arcs = [line for line in drawing.lines if isinstance(line, Arc) and line.layer is Layer.MARK]
    strokes = [ends for line in drawing.lines if isinstance(line, Strokes) for ends in line.segments]
    assert arcs
    assert not [arc for arc in arcs for stroke in strokes if _crosses(arc, *stroke)]
