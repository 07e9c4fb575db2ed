"""Figures of one step: the vectors of one equation at its point, or the velocities of one body with its centre."""

from __future__ import annotations

import cmath
import math
from functools import cache
from itertools import combinations, pairwise

import pytest

from tests.figure.reading import FORMS, arrows, dots
from variantgen.exam.solution_figures import STATEMENT, SolutionFigure, SolutionFigures, view_order
from variantgen.figure.drawing import Arc, Drawing, Layer, Path, Strokes
from variantgen.figure.inspection.faults import figure_faults, misread_labels, short_arrows
from variantgen.mechanism.motion import Motion
from variantgen.methods.solution_options import SolutionOptions
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import to_plain
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import SolutionText
from variantgen.wording.solution.explain import explain

SEEDS = ("1", "2", "3")
HALF = 85.0  # mm, half the width of the text
SHORTEST, UNIT = 8.0, 0.83  # mm on paper, where a unit is this long; most figures are larger
LANGUAGE = load_language("en")


@cache
def solved(
    name: str, form: str, seed: str, methods: tuple[str, ...] = ()
) -> tuple[Motion, SolutionText, dict[str, SolutionFigure]]:
    """The motion, the solution of a variant and its figures but that of the statement."""
    variant = one_variant(name, form=form, seed=seed)
    asked = asked_quantities(variant)
    motion = solve_variants([variant], max(quantity.order for quantity in asked))
    text = explain(variant, motion, 0, asked, LANGUAGE, SolutionOptions(methods))
    figures = SolutionFigures(variant, asked, LANGUAGE, (motion, 0), None, text)
    figures.draw(view_order(text))
    return motion, text, {f.name: f for row in figures.rows() for f in row if f.name != STATEMENT}


def place_of(motion: Motion, point: str, drawing: Drawing) -> complex:
    """Where a point is on the paper."""
    return drawing.scale * complex(motion.z[point][0]) + drawing.origin


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("name", "form"), FORMS)
def test_every_arrow_is_seen_and_its_name_stands_with_it(name: str, form: str, seed: str) -> None:
    for view, figure in solved(name, form, seed)[2].items():
        assert not short_arrows(figure.drawing), view
        assert not misread_labels(figure.drawing), view
        assert not [fault for fault in figure_faults(figure.drawing) if "too" not in fault], view


def test_figures_are_half_as_wide_as_the_text_unless_they_are_tall() -> None:
    shown = [figure for name, form in FORMS for figure in solved(name, form, "1")[2].values()]
    sizes = [(figure.unit * figure.drawing.width, figure.unit * figure.drawing.height) for figure in shown]
    small = [(figure.name, size) for figure, size in zip(shown, sizes, strict=True) if max(size) < HALF]
    assert len(small) < 0.05 * len(shown), small
    assert all(round(figure.index_size, 1) >= 7.0 for figure in shown if not figure.name.endswith("_plan"))


def test_a_wheel_is_drawn_with_the_hatched_ground_below_it() -> None:
    drawing = solved("spool", "", "1")[2]["acceleration_equation:1"].drawing
    low = min(line.centre.imag - line.radius for line in drawing.lines if isinstance(line, Arc) and line.full)
    hatched = [line for line in drawing.lines if isinstance(line, Strokes)]
    assert any(abs(start.imag - low) < 0.1 for line in hatched for start, _ in line.segments)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("name", "form"), FORMS)
def test_an_equation_is_drawn_at_its_point_in_true_directions(name: str, form: str, seed: str) -> None:
    motion, text, figures = solved(name, form, seed)
    for order, kind in enumerate(("velocity_equation", "acceleration_equation")):
        for view in (view for view in figures if view.startswith(kind)):
            equation = text.vectors[order].equations[int(view.split(":")[1]) - 1]
            figure = figures[view]
            place = place_of(motion, equation.point, figure.drawing)
            found = arrows(figure.drawing, Layer.SLIDER)
            moving = [arrow.vector for arrow in equation.terms if abs(arrow.vector) > 1e-9]
            longest = max(abs(vector) for vector in moving)
            scale = max(abs(tip - start) for start, tip in found) / longest
            for start, tip in found:
                assert abs(tip - start) * figure.unit > SHORTEST, view
                # At the point, or beside an arrow on which it would lie.
                assert abs(((start - place) * (tip - start).conjugate()).real) < 1e-6 * abs(tip - start) ** 2, view
                assert abs(start - place) < 8, view
            for vector in moving:
                same = [tip - start for start, tip in found if abs(cmath.phase((tip - start) / vector)) < 1e-6]
                length = scale * abs(vector)
                assert any(abs(abs(a) - length) < 1e-6 * longest * scale for a in same) or (
                    length * UNIT < SHORTEST + 0.1 and same and figure.drawing.lengthened
                ), view


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_velocities_are_perpendicular_to_the_rays_to_a_centre_on_the_paper(name: str, form: str) -> None:
    for view, figure in solved(name, form, "1")[2].items():
        if not view.startswith("velocity_centre:"):
            continue
        motion, drawing = solved(name, form, "1")[0], figure.drawing
        body = view.split(":")[1]
        omega = float(motion.omega[body][0])
        letters = {to_plain(label.formula)[0] for label in drawing.labels}
        if abs(omega) < 1e-9 * max(abs(float(rate[0])) for rate in motion.omega.values()):
            assert "P" not in letters
            continue
        assert "P" in letters
        members = [p for p in motion.scene.bodies[body] if abs(motion.v[p][0]) > 1e-9]
        centre = complex(motion.z[members[0]][0]) + 1j * complex(motion.v[members[0]][0]) / omega
        at = drawing.scale * centre + drawing.origin
        points = {p: place_of(motion, p, drawing) for p in motion.scene.bodies[body]}
        inside = 0 < at.real < drawing.width and 0 < at.imag < drawing.height
        if inside:
            seen = [*dots(drawing), *points.values()]
            near = min(abs(place - at) for place in seen)
            assert near < 1e-6 or near > 5, view  # at its place, or behind a break
        for start, tip in arrows(drawing, Layer.SLIDER):
            point = min((*points.values(), *dots(drawing)), key=lambda place: abs(place - start))
            arm = (at - point) * (tip - start).conjugate()
            assert abs(arm.real) < 1e-6 * abs(arm), view


def test_the_figure_belongs_to_the_method() -> None:
    shown = {
        method: {to_plain(label.formula) for f in solved("slider_crank", "offset", "107", (method,))[2].values()
                 if f.name.startswith("velocity") for label in f.drawing.labels}
        for method in ("velocity_centre", "projections", "velocity_pole")
    }  # fmt: skip
    assert {"P", "v_A", "v_B", "ω_AB"} <= shown["velocity_centre"]
    assert {"v_A", "v_B"} == {label for label in shown["projections"] if label[0] in "vP"}
    assert {"v_A", "v_B", "v_B/A"} == {label for label in shown["velocity_pole"] if label[0] in "vP"}


def test_supports_keep_the_pose_of_the_statement() -> None:
    variant = one_variant("four_bar", form="crank", seed="174")
    asked = asked_quantities(variant)
    motion = solve_variants([variant], 2)
    text = explain(variant, motion, 0, asked, LANGUAGE)
    figures = SolutionFigures(variant, asked, LANGUAGE, (motion, 0), None, text)
    figures.draw(view_order(text))
    drawn = {f.name: f.drawing for row in figures.rows() for f in row}
    sides = []
    for drawing in (drawn[STATEMENT], drawn["velocity_centre:AB"]):
        at = place_of(motion, "O", drawing)
        pairs = [line.points for line in drawing.lines if isinstance(line, Path) and len(line.points) == 2]
        ends = [end - at for start, end in pairs if 0.9 < abs(start - at) < 1.2]
        sides.append({complex(round(end.real, 3), round(end.imag, 3)) for end in ends if abs(end) < 5.5})
    assert len(sides[0]) == 2
    assert sides[0] == sides[1]


@pytest.mark.parametrize(
    ("name", "form"), [("three_rod_plate", ""), ("guided_plate", ""), ("two_loop_mechanism", "inclined")]
)
def test_an_equation_that_is_used_twice_is_drawn_once(name: str, form: str) -> None:
    text, figures = solved(name, form, "2")[1:]
    drawn = [
        (equation.point, frozenset(arrow.name for arrow in equation.terms))
        for order, kind in enumerate(("velocity_equation", "acceleration_equation"))
        for view in figures
        if view.startswith(kind)
        for equation in [text.vectors[order].equations[int(view.split(":")[1]) - 1]]
    ]
    assert drawn
    assert len(set(drawn)) == len(drawn)


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_an_angle_is_drawn_as_large_as_its_value_says(name: str, form: str) -> None:
    for view, figure in solved(name, form, "1")[2].items():
        arcs = [
            math.degrees(abs(line.sweep))
            for line in figure.drawing.lines
            if isinstance(line, Arc) and line.layer is Layer.MARK
        ]
        values = [text for label in figure.drawing.labels if (text := to_plain(label.formula)).endswith("°")]
        for value in values:
            assert any(abs(arc - float(value.removesuffix("°"))) < 0.02 for arc in arcs), (view, value)


def gap(at: complex, start: complex, end: complex) -> float:
    """The distance of a place from a straight line between two others."""
    way = (end - start) / abs(end - start)
    along = ((at - start) * way.conjugate()).real
    return abs(at - start - min(max(along, 0.0), abs(end - start)) * way)


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_an_arc_goes_from_one_line_to_another(name: str, form: str) -> None:
    for view, figure in solved(name, form, "1")[2].items():
        paths = [line.points for line in figure.drawing.lines if isinstance(line, Path)]
        lines = [pair for points in paths for pair in pairwise(points) if pair[0] != pair[1]]
        for arc in figure.drawing.lines:
            if isinstance(arc, Arc) and arc.layer is Layer.MARK and not arc.full:
                for end in (arc.at(0.0), arc.at(1.0)):
                    assert min(gap(end, *pair) for pair in lines) < 1.2, (view, arc)  # u: a line beside the side


def test_arcs_at_one_vertex_are_apart() -> None:
    """Of a small angle, whose arc is wider, and of a larger one around it."""
    for seed in SEEDS:
        drawing = solved("arc_yoke", "", seed)[2]["velocity_equation:1"].drawing
        arcs = [line for line in drawing.lines if isinstance(line, Arc) and line.layer is Layer.MARK]
        for first, second in combinations(arcs, 2):
            assert first.centre != second.centre or abs(first.radius - second.radius) > 3.0


@pytest.mark.parametrize(
    ("name", "form", "view", "letter", "line"),
    [
        ("falling_rod", "", "velocity_equation:1", "φ", "CA"),  # by which the rod has turned
        ("two_loop_mechanism", "level", "velocity_projections:AB", "ψ", "AB"),  # of the rod with the level guide
    ],
)
def test_the_letter_of_an_angle_of_a_step_is_in_its_figure(
    name: str, form: str, view: str, letter: str, line: str
) -> None:
    motion, _, figures = solved(name, form, "1")
    drawing = figures[view].drawing
    start, end = (complex(motion.z[point][0]) for point in line)
    slope = math.degrees(abs(cmath.phase((end - start) ** 2))) / 2  # acute, with the horizontal
    arcs = [math.degrees(abs(arc.sweep)) for arc in drawing.lines if isinstance(arc, Arc) and arc.layer is Layer.MARK]
    assert letter in {to_plain(label.formula) for label in drawing.labels}
    assert any(abs(arc - slope) < 0.02 for arc in arcs)


@pytest.mark.parametrize("form", ["straight", "oblique"])
def test_the_rod_of_a_yoke_slides_in_a_hatched_bearing(form: str) -> None:
    motion, _, figures = solved("scotch_yoke", form, "1")
    for drawing in (figure.drawing for view, figure in figures.items() if "equation" in view):
        bearing = place_of(motion, "S", drawing)
        strokes = [line for line in drawing.lines if isinstance(line, Strokes)]
        assert sum(abs(start - bearing) < 8.0 for line in strokes for start, _ in line.segments) >= 6


def marked_at(motion: Motion, point: str, drawing: Drawing) -> list[float]:
    """The angles (deg) whose arcs stand at a point."""
    place = place_of(motion, point, drawing)
    arcs = [line for line in drawing.lines if isinstance(line, Arc) and line.layer is Layer.MARK]
    return [math.degrees(abs(arc.sweep)) for arc in arcs if abs(arc.centre - place) < 1e-6]


@pytest.mark.parametrize("seed", ["3", "4", "5"])
def test_an_angle_at_a_point_that_is_not_drawn_stands_where_its_lines_meet(seed: str) -> None:
    """Not at the centre of the slot, past which nothing leads in the direction of the crank."""
    motion, _, figures = solved("arc_yoke", "", seed)
    crank = complex(motion.z["A"][0] - motion.z["O"][0])
    guide = complex(motion.z["D"][0] - motion.z["B"][0])
    acute = math.degrees(abs(cmath.phase((crank / guide) ** 2))) / 2
    drawing = figures["velocity_equation:1"].drawing
    if "φ" in {to_plain(label.formula) for label in drawing.labels}:
        assert any(abs(angle - acute) < 0.02 for angle in marked_at(motion, "A", drawing))
    assert not any(abs(angle - acute) < 0.02 for angle in marked_at(motion, "D", drawing))


def test_the_angles_of_the_equations_are_marked_without_the_velocity_centre() -> None:
    """Four-bar linkage: those of the coupler with the links at its ends; not the given one, of which they are made."""
    motion, _, figures = solved("four_bar", "crank", "1")
    drawing = next(figure.drawing for view, figure in figures.items() if view.startswith("acceleration_equation"))
    z = {point: complex(motion.z[point][0]) for point in "OABC"}
    inner = math.degrees(abs(cmath.phase((z["C"] - z["B"]) / (z["A"] - z["B"]))))
    assert any(abs(angle - (180 - inner)) < 0.02 for angle in marked_at(motion, "B", drawing))
    assert "φ" not in {to_plain(label.formula) for label in drawing.labels}


@pytest.mark.parametrize("seed", SEEDS)
def test_the_given_angle_of_a_cam_is_marked_from_its_radius(seed: str) -> None:
    """The disc is drawn without the line OC, of which the angle is one with the line OD."""
    motion, _, figures = solved("cam_disc", "flat", seed)
    drawing = figures["velocities"].drawing
    z = {point: complex(motion.z[point][0]) for point in "OCD"}
    angle = math.degrees(abs(cmath.phase((z["C"] - z["O"]) / (z["D"] - z["O"]))))
    assert any(abs(arc - angle) < 0.02 for arc in marked_at(motion, "O", drawing))
    ends = {place_of(motion, "O", drawing), place_of(motion, "C", drawing)}
    lines = [line.points for line in drawing.lines if isinstance(line, Path) and len(line.points) == 2]
    assert any(all(min(abs(end - point) for point in line) < 1e-6 for end in ends) for line in lines)


def test_the_triangle_of_a_velocity_centre_is_marked() -> None:
    # Offset slider-crank: the angles of AP and AB with the path of B, by which both have one projection on it.
    drawing = solved("slider_crank", "offset", "1")[2]["velocity_centre:AB"].drawing
    labels = {to_plain(label.formula) for label in drawing.labels}
    assert {"O", "A", "B", "P", "φ", "ψ"} <= labels


def test_three_rates_show_the_links_as_vectors_with_their_graph() -> None:
    _, text, figures = solved("four_bar", "crank", "7", ("three_rates",))
    # The same for the position, whose angles it shows, for velocities and for accelerations.
    assert list(figures) == ["rate_chain:O-C"]
    assert sum("rate_chain:O-C" in section.views for section in text.sections) == 3
    drawing = figures["rate_chain:O-C"].drawing
    labels = [to_plain(label.formula) for label in drawing.labels]
    assert all(labels.count(letter) == 2 for letter in "OABC123")
    assert {"x", "y"} <= set(labels)
    graph = [tip - start for start, tip in arrows(drawing, Layer.VECTOR)]
    assert len(graph) == 3
    assert all(way.imag == 0 < way.real for way in graph)


def test_the_angle_mu_stands_at_each_point_beside_an_acceleration_centre() -> None:
    motion, _, figures = solved("plate_acceleration_centre", "square", "149")
    (figure,) = figures.values()
    drawing = figure.drawing
    (body,) = motion.omega
    mu = math.atan2(abs(float(motion.epsilon[body][0])), float(motion.omega[body][0]) ** 2)
    labels = [to_plain(label.formula) for label in drawing.labels]
    arcs = [line for line in drawing.lines if isinstance(line, Arc) and line.layer is Layer.MARK]
    assert "Q" in labels
    assert all(abs(abs(arc.sweep) - mu) < 1e-6 for arc in arcs)
    assert labels.count("μ") == len(arcs) == sum(label.startswith("a_") for label in labels) >= 3


@pytest.mark.parametrize("form", ["two_loads", "load_and_axle"])
def test_the_pulley_alone_is_drawn_with_what_its_threads_do(form: str) -> None:
    drawing = solved("movable_pulley", form, "1")[2]["contact_velocities:pulley"].drawing
    labels = {to_plain(label.formula) for label in drawing.labels}
    assert {"v_D", "v_C", "v_G", "ω"} <= labels
    assert not labels & {"A", "v_A", "v_B", "v_M"}


@pytest.mark.parametrize("form", ["central", "offset"])
def test_an_angle_of_a_rod_is_not_sought_in_the_figure_of_the_wheel(form: str) -> None:
    _, text, _ = solved("wheel_with_rod", form, "1")
    geometry, *_ = text.sections
    assert geometry.views == ("velocity_centre:AB",), "the angle is at B, which the wheel does not have"


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("form", "view"), [("slider", "limit_positions:O-A-B"), ("rocker", "limit_positions:O-A-B-C")])
def test_in_the_limit_positions_crank_and_rod_are_in_line(form: str, view: str, seed: str) -> None:
    motion, text, figures = solved("limit_positions", form, seed)
    assert sum(view in section.views for section in text.sections) == 1
    drawing = figures[view].drawing
    o, a, b = (place_of(motion, point, drawing) for point in "OAB")
    crank, rod = abs(a - o), abs(b - a)
    dashed = [line.points for line in drawing.lines if isinstance(line, Path) and line.dash == "dashed"]
    (far, near) = (points for points in dashed if len(points) > 1)
    # Once stretched, once folded: OB = AB + OA, OB = AB - OA with A beyond O.
    assert (far[0], abs(far[1] - o)) == (pytest.approx(o), pytest.approx(rod + crank))
    assert abs(near[1] - o) == pytest.approx(rod - crank)
    assert near[0] == pytest.approx(o - crank * (near[1] - o) / (rod - crank))
    for limit in (far[1], near[1]):
        if form == "rocker":  # B goes on a circle about C
            c = place_of(motion, "C", drawing)
            assert abs(limit - c) == pytest.approx(abs(b - c))
        else:  # both on one line with B
            along = (far[1] - near[1]) / abs(far[1] - near[1])
            assert ((limit - b) * along.conjugate()).imag == pytest.approx(0, abs=1e-6)
    assert {"A_1", "B_1", "A_2", "B_2"} <= {to_plain(label.formula) for label in drawing.labels}


@pytest.mark.parametrize(("name", "form", "centre"), [("rolling_wheel", "", "O"), ("wheel_with_rod", "central", "O")])
def test_what_a_wheel_rolls_on_is_hatched_below_it(name: str, form: str, centre: str) -> None:
    motion, _, figures = solved(name, form, "1")
    drawn = 0
    for drawing in (figure.drawing for figure in figures.values()):
        place = place_of(motion, centre, drawing)
        circles = [line for line in drawing.lines if isinstance(line, Arc) and line.full]
        radius = max((rim.radius for rim in circles if abs(rim.centre - place) < 1e-6), default=0.0)
        if radius < 5:  # no more than the hinge
            continue
        drawn += 1
        strokes = [stroke for line in drawing.lines if isinstance(line, Strokes) for stroke in line.segments]
        near = [s for s in strokes if max(abs(end - place) for end in s) < 1.1 * radius]
        assert len(near) > 3
        assert all(abs(end - place) > radius - 1e-6 for stroke in near for end in stroke)
    assert drawn > 1


def test_the_foot_of_a_short_perpendicular_has_its_letter() -> None:
    # BH is 3.5 cm beside AH of 62 cm: too short for the mark of a right angle.
    motion, _, figures = solved("two_cranks_and_rod", "", "31331")
    drawing = next(iter(figures.values())).drawing
    a, b, o, c = (place_of(motion, name, drawing) for name in "ABOC")
    level = a + ((b - a) / (c - o)).real * (c - o)
    assert 1.8 < abs(b - level) < 3.2
    (label,) = [label for label in drawing.labels if to_plain(label.formula) == "H"]
    assert abs(label.at - level) < 6
