"""Figures of velocities and accelerations: vectors to one scale, true senses, centres where perpendiculars meet."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from tests.contracts.test_families import arcs_and_labels
from tests.figure.reading import FORMS, arrows, dots, has_arrow, variants_of, view_drawings
from variantgen.exam.solution_figures import SolutionFigures
from variantgen.figure.build import Mechanism, statement_figure
from variantgen.figure.drawing import Drawing, Layer
from variantgen.figure.inspection.faults import inspect_labels
from variantgen.figure.motion.motion_board import LEAST
from variantgen.figure.motion.motion_data import MovingMechanism, motion_data
from variantgen.figure.motion.vectors import vectors_of
from variantgen.figure.views import accelerations, velocities, view_names
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.scene import fixed_points
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Symbol, to_plain
from variantgen.wording.language import load_language

EN = load_language("en")
SEEDS = 3


@cache
def drawings(name: str, form: str, order: int) -> list[tuple[Variant, Motion, int, Drawing]]:
    """The figures of several variants."""
    return view_drawings(name, form, order, (velocities, accelerations), SEEDS)


def size_of_vectors(motion: Motion, i: int, points: list[str], drawing: Drawing) -> float:
    """Figure units per m/s of arrows near shown points in the directions of their velocities.

    Those of the least length may be lengthened; where all are, there is no scale to measure.
    """
    found = arrows(drawing, Layer.SLIDER)
    ratios = []
    for point in points:
        v = complex(motion.v[point][i])
        place = drawing.scale * complex(motion.z[point][i]) + drawing.origin
        for start, tip in found:
            if abs(start - place) < 5 and abs(v) > 0 and abs(np.angle((tip - start) / v)) < 1e-9:
                ratios += [abs(tip - start) / abs(v)] if abs(tip - start) > LEAST + 1e-6 else []
    return max(ratios, default=0.0)


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_velocities_are_drawn_to_one_scale_in_their_directions(name: str, form: str) -> None:
    for variant, motion, i, drawing in drawings(name, form, 1):
        mechanism = MovingMechanism(variant, motion, i, asked_quantities(variant), EN)
        chain = motion_data(mechanism, 1).chain
        points = vectors_of(mechanism, 1).telling(chain.points)
        assert {q.point for q in mechanism.asked if q.kind == "v"} - chain.resting <= set(points)
        size = size_of_vectors(motion, i, points, drawing)
        found = arrows(drawing, Layer.SLIDER)
        for point in points:
            vector = size * complex(motion.v[point][i])
            if abs(vector) < LEAST:
                continue
            place = drawing.scale * complex(motion.z[point][i]) + drawing.origin
            # At the point, or moved a little across its direction off a line on which it would lie.
            assert any(
                abs(tip - start - vector) < 1e-4
                and abs(((start - place) * vector.conjugate()).real) < 1e-6 * abs(vector)
                and abs(start - place) < 5
                for start, tip in found
            ), (point, variant.printed)


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_arcs_have_the_true_senses_of_all_bodies_that_turn(name: str, form: str) -> None:
    for order, letter in ((1, "omega"), (2, "epsilon")):
        for variant, motion, i, drawing in drawings(name, form, order):
            rates = motion.omega if order == 1 else motion.epsilon
            largest = max(abs(float(rate[i])) for rate in rates.values())
            bound = 1e-9 * max(largest, max(abs(float(w[i])) for w in motion.omega.values()) ** 2)
            # A rate that the data call by its letter alone is that of the driven body.
            bare = any(parameter.symbol == letter for parameter in variant.form.parameters.values())
            stated = {d.fields["body"]: letter for d in variant.form.drivers if bare and "body" in d.fields}
            turning = {
                to_plain(EN.symbol(stated.get(body, f"{letter}_{body}"), variant.form.symbols)): float(rate[i])
                for body, rate in rates.items()
                if abs(float(rate[i])) > bound
            }
            found = {to_plain(label.formula): float(np.sign(arc.sweep)) for arc, label in arcs_and_labels(drawing)}
            assert found == {symbol: float(np.sign(rate)) for symbol, rate in turning.items()}, variant.printed


def crossing(motion: Motion, i: int, first: str, second: str) -> complex | None:
    """Where the perpendiculars to two velocities meet; None where they are nearly parallel."""
    z, w = (complex(motion.z[p][i]) for p in (first, second))
    n, m = (1j * complex(motion.v[p][i]) for p in (first, second))
    across = (n.conjugate() * m).imag
    if abs(across) < 0.05 * abs(n) * abs(m):
        return None
    return z + n * (((w - z).conjugate() * m).imag / across)


def test_centres_lie_where_perpendiculars_to_velocities_meet() -> None:
    shown = 0
    for name, form in FORMS:
        for variant, motion, i, drawing in drawings(name, form, 1):
            fixed = fixed_points(motion.scene)
            seen = shown_points(variant, asked_quantities(variant))
            letters = [to_plain(label.formula) for label in drawing.labels if to_plain(label.formula)[0] == "P"]
            places = dots(drawing) + [drawing.scale * complex(motion.z[p][i]) + drawing.origin for p in seen]
            for body, members in motion.scene.bodies.items():
                moving = [p for p in members if p in seen and abs(motion.v[p][i]) > 1e-9]
                if fixed & set(members) or len(moving) < 2:
                    continue
                meeting = crossing(motion, i, moving[0], moving[1])
                if meeting is None:
                    continue
                at = drawing.scale * meeting + drawing.origin
                if 0 < at.real < drawing.width and 0 < at.imag < drawing.height and letters:
                    near = min(abs(place - at) for place in places)
                    assert near < 1e-6 or any(f"P_{body}" not in text for text in letters), (name, form, body)
                    shown += near < 1e-6
    assert shown > 75


def test_a_centre_outside_the_paper_is_noted() -> None:
    beyond = 0
    for name, form in FORMS:
        for variant, _, _, drawing in drawings(name, form, 1):
            noted = {to_plain(letter) for letter in drawing.beyond}
            assert not noted & {to_plain(label.formula) for label in drawing.labels}, variant.printed
            beyond += len(noted)
    assert beyond
    variant = one_variant(
        "slider_crank", {"OA": 34, "AB": 78, "phi": 105, "v_B": 120, "a_B": 60}, form="driven_by_slider"
    )
    figures = SolutionFigures(variant, asked_quantities(variant), EN, (solve_variants([variant], 2), 0))
    figures.draw(["statement", "velocities"])
    captions = [list(figure.caption) for row in figures.rows() for figure in row]
    assert captions == [
        ["Fig.\xa01. ", "Given position"],
        ["Fig.\xa02. ", "Velocities", " ", "(outside the figure: ", Symbol("P"), ")"],
    ]


def test_instantaneous_translation_has_no_centre_and_no_arc() -> None:
    # M28: AB has equal velocities; BC has a centre.
    data = {"OA": 20, "AB": 40, "BC": 34.6, "phi": 90, "beta": 60, "omega_OA": 2, "epsilon_OA": 0}
    words = {"place": "same_side", "sense": "counter_clockwise"}
    variant = one_variant("slider_crank_with_second_rod", {**data, **words}, form="perpendicular")
    drawing = velocities.draw(variant, solve_variants([variant], 2), 0, asked_quantities(variant), EN)
    texts = {to_plain(label.formula) for label in drawing.labels}
    assert "P_BC" in texts
    assert "P_AB" not in texts
    assert "ω_BC" in texts
    assert "ω_AB" not in texts


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_asked_accelerations_are_drawn_in_their_directions(name: str, form: str) -> None:
    for variant, motion, i, drawing in drawings(name, form, 2):
        asked = [q.point for q in asked_quantities(variant) if q.kind == "a"]
        drawn = [tip - start for start, tip in arrows(drawing, Layer.SLIDER)]
        assert drawn
        mechanism = MovingMechanism(variant, motion, i, asked_quantities(variant), EN)
        named = vectors_of(mechanism, 2)
        parts = accelerations.components(motion_data(mechanism, 2), named)
        largest = max(abs(vector) for named in parts.values() for _, vector in named)
        for point in asked:
            vector = complex(motion.a[point][i])
            # The shortest arrow that is drawn is a tenth of the longest.
            same = [arrow for arrow in drawn if abs(vector) and abs(np.angle(arrow / vector)) < 1e-6]
            assert same or abs(vector) < 0.12 * largest, (point, variant.printed)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize(("name", "form"), FORMS)
def test_letters_find_room_on_the_paper(name: str, form: str, order: int) -> None:
    for _, _, _, drawing in drawings(name, form, order):
        seen = inspect_labels(drawing)
        assert not seen.overlaps
        assert not seen.outside
        assert drawing.width < 125  # the letters of English are wider: (a_C′/B)_n
        assert drawing.height < 120


@pytest.mark.parametrize(("name", "form"), [("four_bar", "crank"), ("ladder", "oblique"), ("spool", "")])
def test_the_mechanism_alone_shows_no_data(name: str, form: str) -> None:
    variants, motion, asked = variants_of(name, form, 1)
    board = Mechanism(variants[0], motion, 0, asked, EN).board(marks=False)
    plain = board.sketch.finish({})
    whole = statement_figure(variants[0], motion, 0, asked, EN)
    points = {to_plain(board.symbol(p)) for p in board.shown}
    texts = [{to_plain(label.formula) for label in drawing.labels} for drawing in (plain, whole)]
    assert points <= texts[0] <= texts[1]
    assert not any(text[0] in "ωεva" for text in texts[0])
    assert any(text[0] in "ωεva" for text in texts[1])
    assert not has_arrow(arrows(plain, Layer.VECTOR), 0, 0, np.inf)


def test_the_views_are_found() -> None:
    assert {"statement", "velocity_plan", "acceleration_plan", "velocities", "accelerations"} <= set(view_names())


@pytest.mark.parametrize(
    ("name", "form", "letters"),
    [("gear_pair_with_crank", "outside", {"K"}), ("wheel_between_racks", "two_moving", {"K", "L"})],
)
def test_points_of_contact_have_the_letters_of_the_solution(name: str, form: str, letters: set[str]) -> None:
    for _, motion, i, drawing in drawings(name, form, 1):
        names = {to_plain(label.formula) for label in drawing.labels}
        assert letters <= names
        assert {f"v_{letter}" for letter in letters} <= names
        assert len(dots(drawing)) >= len(letters)
        assert bool(motion.solved[i])


def test_an_asked_acceleration_centre_is_drawn() -> None:
    found = drawings("plate_acceleration_centre", "square", 2)
    assert any("Q" in {to_plain(label.formula) for label in drawing.labels} for *_, drawing in found)


def test_a_given_rate_bears_the_letter_of_the_statement() -> None:
    for _, _, _, drawing in drawings("falling_rod", "", 1):
        letters = {to_plain(label.formula) for label in drawing.labels}
        assert "ω" in letters
        assert "ω_AB" not in letters


@pytest.mark.parametrize(("order", "relative", "rest"), [(1, "u", ("v_B′",)), (2, "w", ("(a_B′)_t",))])
def test_the_end_of_a_rod_has_the_vectors_of_its_equation(order: int, relative: str, rest: tuple[str, ...]) -> None:
    # What is too short to be seen is left out: in one of the variants all are long enough.
    found = [
        {to_plain(label.formula) for label in drawing.labels}
        for _, _, _, drawing in drawings("hydraulic_hoist", "boom", order)
    ]
    assert any(relative in letters for letters in found)
    assert any({relative, *rest} <= letters for letters in found), found


@pytest.mark.parametrize(
    ("name", "form", "order", "named", "unnamed"),
    [
        # A body in translation has one velocity: as the statement calls it, or that of its guided point.
        ("wedge_and_rod", "vertical", 1, {"v", "v_A", "v_rel A"}, {"v_F", "v_D", "v_E", "v_B", "v_A′"}),
        ("wedge_and_rod", "inclined", 2, {"a", "a_A", "a_rel A"}, {"a_F", "a_A′"}),
        ("scotch_yoke", "oblique", 1, {"v_A", "v_B", "v_rel A"}, {"v_A′"}),
        # The parts of transport motion are those of the solution: about a fixed axis, about a moving pole.
        ("slotted_rocker", "swinging", 2, {"(a_A′)_t", "a_Cor A"}, {"a_A′", "a_B"}),
        ("sleeve_on_crank", "", 1, {"v_B", "v_C′/B", "v_rel C"}, {"v_C′", "v_D"}),
        ("sleeve_on_crank", "", 2, {"a_B", "(a_C′/B)_n", "(a_C′/B)_t", "a_Cor C"}, {"a_C′"}),
        ("arc_yoke", "", 2, {"(a_rel A)_t"}, {"a_rel A"}),
        ("triangle_plate", "scalene", 2, {"α", "a_B", "a_D"}, {"α_ABD"}),
        # A wheel held by its rim has the contact as its pole; a rod led by cranks has the velocity of its first hinge.
        ("wheel_with_rod", "driven_by_slider", 2, {"P", "a_P", "(a_A/P)_t", "a_O"}, {"(a_A/O)_t", "(a_O/P)_t"}),
        ("parallelogram_with_disc", "moving_point", 1, {"v_A", "v_rel M", "v_M"}, {"v_C"}),
    ],
)
def test_vectors_and_rates_have_the_names_of_the_solution(
    name: str, form: str, order: int, named: set[str], unnamed: set[str]
) -> None:
    for variant, _, _, drawing in drawings(name, form, order):
        names = {part for label in drawing.labels for part in to_plain(label.formula).split(" = ")}
        assert named <= names, variant.printed
        assert not unnamed & names, variant.printed
