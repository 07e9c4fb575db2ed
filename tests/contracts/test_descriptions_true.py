"""What the texts of figures say is true: places, senses, directions, sides, against the solved motion."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tests.described_figures import DescribedFigure, described_figures, is_between, pattern, said_arrows, sector
from variantgen.families.hints import DIRECTIONS
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.mechanism.drivers.circling import Circling
from variantgen.mechanism.drivers.extension import Extension
from variantgen.mechanism.drivers.relative_travel import RelativeTravel
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.drivers.vector_motion import VectorMotion
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.motion import take_scene
from variantgen.mechanism.relative import relative_motion
from variantgen.variants.printed_data import given_names, shown_points

FAMILIES = family_names()


@pytest.mark.parametrize("name", FAMILIES)
def test_positions_are_true_and_complete(name: str) -> None:
    for each in described_figures(name):
        z = {each.named(point): each.z[point] for point in shown_points(each.variant, each.asked)}
        seen: set[str] = set()
        for item in each.items("positions"):
            point, place = item.split(" ", 1)
            fits = {
                key: found["origin"]
                for key, phrase in each.language.words("figure_place").items()
                if (found := pattern(phrase, origin=r"[A-Z]\d?").match(place))
            }
            assert len(fits) == 1, (item, fits)
            [(key, origin)] = fits.items()
            assert key == sector(z[point] - z[origin]), (item, each.variant.printed)
            assert not seen or origin in seen or is_between(each, z, origin), "seen from a point that is not known yet"
            seen |= {point, origin}
        rest = set(z) - seen
        assert not each.items("positions") or all(is_between(each, z, point) for point in rest), (rest, each.figure.alt)


@pytest.mark.parametrize("name", FAMILIES)
def test_every_given_rate_has_its_arrow(name: str) -> None:
    for each in described_figures(name):
        rates = {
            each.named(parameter.symbol)
            for key in given_names(each.variant, each.asked)
            if (parameter := each.variant.form.parameters[key]).is_rate and each.variant.printed[key] != 0
        }
        constants = {
            each.named(parameter.symbol) for parameter in each.variant.form.parameters.values() if parameter.constant
        }
        assert rates <= set(said_arrows(each)) <= rates | constants, each.figure.alt


def letters(each: DescribedFigure) -> str:
    """The letters of angular velocities and accelerations in the language of a figure."""
    return "ωα" if each.language.name == "en" else "ωε"


def rotations(each: DescribedFigure) -> dict[str, float]:
    """Solved rates of rotation by the phrase of their sense: first omega, then epsilon, by body."""
    found = {}
    for driver in each.motion.scene.drivers:
        if isinstance(driver, Rotation):
            for kind, table in (("ω", each.motion.omega), ("ε", each.motion.epsilon)):
                rate = table[driver.body] - (table[driver.relative_to] if driver.relative_to else 0.0)
                found[f"{kind} {driver.body}"] = float(rate[each.place])
    return found


@pytest.mark.parametrize("name", FAMILIES)
def test_senses_of_rotation_are_those_of_the_solved_motion(name: str) -> None:
    for each in described_figures(name):
        arrows = {symbol: item for symbol, item in said_arrows(each).items() if symbol[0] in letters(each)}
        solved = {key: rate for key, rate in rotations(each).items() if rate != 0}
        assert len(arrows) == len(solved), each.figure.alt
        # Told in the order of the drivers, the angular velocity before the angular acceleration.
        for (symbol, item), (key, rate) in zip(arrows.items(), solved.items(), strict=True):
            assert symbol[0] == {"ω": letters(each)[0], "ε": letters(each)[1]}[key[0]]
            right, wrong = each.words["counter_clockwise"], each.words["clockwise"]
            if rate < 0:
                right, wrong = wrong, right
            assert re.search(rf"(?<![\w-]){right}", item), item
            assert not re.search(rf"(?<![\w-]){wrong}", item), item


def vectors(each: DescribedFigure) -> list[complex]:
    """Given vectors on paper, by driver, velocity before acceleration; the velocity of a free fall is not given."""
    scene = take_scene(each.motion.scene, each.place, each.motion.size)
    falls = any(parameter.constant for parameter in each.variant.form.parameters.values())
    found = []
    for driver in scene.drivers:
        if isinstance(driver, Travel | VectorMotion):
            found += [] if falls else [(driver.v, driver.angle)]
            found += [(driver.a, driver.angle if isinstance(driver, Travel) else driver.a_angle)]
    return [complex(scene.frame.place(float(r) * np.exp(1j * float(angle)))) for r, angle in found if r != 0]


STRAIGHT = [
    name
    for name in FAMILIES
    if any(d.component in (Travel, VectorMotion) for form in load_family(name).forms.values() for d in form.drivers)
]


@pytest.mark.parametrize("name", STRAIGHT)
def test_straight_arrows_point_where_the_drivers_do(name: str) -> None:
    for each in described_figures(name):
        ways = vectors(each)
        if not ways:  # another form, which turns
            continue
        items = [item for symbol, item in said_arrows(each).items() if symbol[0] not in letters(each)]
        if not any(q.order == 2 for q in each.asked):
            assert len(items) <= len(ways)
            continue
        assert len(items) == len(ways), each.figure.alt
        for item, way in zip(items, ways, strict=True):
            endings = [key for key, text in each.language.words("figure_way").items() if item.endswith(" " + text)]
            # Of "up" and "to the right and slightly up" the longer one is meant.
            longest = max(endings, key=lambda key: len(each.language.words("figure_way")[key]))
            assert longest == sector(way), item


@pytest.mark.parametrize("name", ["sliding_block_on_rotating_rod", "point_on_rotating_disc", "parallelogram_with_disc"])
def test_arrows_of_relative_motion_are_those_of_the_solved_motion(name: str) -> None:
    checked = 0
    for each in described_figures(name):
        z = each.z
        for driver in each.motion.scene.drivers:
            if not isinstance(driver, RelativeTravel | Circling):
                continue
            relative = relative_motion(each.motion, driver.point, driver.body).velocity[each.place]
            item = next(item for symbol, item in said_arrows(each).items() if symbol[0] == "v")
            if isinstance(driver, Circling):
                arm = z[driver.point] - z[driver.centre]
                turn = (arm.conjugate() * relative).imag
                sense = each.words["counter_clockwise" if turn > 0 else "clockwise"]
                assert re.search(rf"(?<![\w-]){sense}", item), item
            elif found := pattern(each.words["relative_travel"]).match(item):
                target = z[found["target"]] - z[driver.point]
                assert (target.conjugate() * relative).real > 0, item
            else:
                way = each.language.words("figure_way")[sector(complex(relative))]
                assert item.endswith(" " + way), item
            checked += 1
    assert checked


def test_arrows_of_a_cylinder_point_as_its_length_changes() -> None:
    for each in described_figures("hydraulic_hoist"):
        [driver] = each.motion.scene.drivers
        assert isinstance(driver, Extension)
        step = each.z[driver.end] - each.z[driver.start]
        rate = (step.conjugate() * (each.motion.v[driver.end] - each.motion.v[driver.start])[each.place]).real
        target = driver.end if rate > 0 else driver.start
        [item] = [item for symbol, item in said_arrows(each).items() if symbol == "u"]
        assert item == each.words["extension_arrow"].format(symbol="u", target=target)


@pytest.mark.parametrize("name", FAMILIES)
def test_axes_named_as_rays_of_angles_are_true(name: str) -> None:
    axes = {"ray_right": 1, "ray_up": 1j, "ray_left": -1, "ray_down": -1j}
    for each in described_figures(name):
        hints = [mark for mark in each.variant.form.figure.angles if mark.name in given_names(each.variant, each.asked)]
        items = each.items("marks")
        frame = take_scene(each.motion.scene, each.place, each.motion.size).frame
        assert len(items) >= len(hints)  # the angles first, then the other marks
        for mark, item in zip(hints, items, strict=False):
            found = pattern(each.words["angle"], corner=".*?").match(item)
            assert found, item
            assert found["symbol"] == each.named(each.variant.form.parameters[mark.name].symbol)
            for end, text in ((mark.start, found["first"]), (mark.end, found["second"])):
                ray = complex(frame.place(DIRECTIONS[end])) if end in DIRECTIONS else each.z[end] - each.z[mark.at]
                for key, axis in axes.items():
                    if text == each.words[key]:
                        assert abs(ray / abs(ray) - axis) < 1e-6, item
                if re.fullmatch(r"(?:[A-Z]\d?){2}", text):
                    assert text == each.named(mark.at) + each.named(end)


def before_side(phrase: str) -> str:
    """What stands right before the side in a phrase."""
    return phrase.split("{side}", maxsplit=1)[0].rsplit("}", 1)[1]


@pytest.mark.parametrize(
    "name", ["rolling_wheel", "wheel_between_racks", "pulley_and_wheel", "spool", "wheel_with_rod"]
)
def test_lines_touch_wheels_on_the_side_of_the_contact(name: str) -> None:
    for each in described_figures(name):
        for joint in each.motion.scene.joints:
            if isinstance(joint, Rolling):
                key = sector(each.z[joint.contact] - each.z[joint.centre])
                assert key in {"e", "n", "w", "s"}
                phrase = each.words["rolling" if joint.on is None else "rolling_rack"]
                assert before_side(phrase) + each.language.words("figure_side")[key] in each.figure.alt, each.figure.alt


@pytest.mark.parametrize("name", ["movable_pulley", "winch_with_pulley", "pulley_and_wheel", "spool"])
def test_ropes_hang_from_the_side_on_which_they_are(name: str) -> None:
    """Vertical pieces: over fixed pulleys, round movable ones below, off drums to the side where the load hangs."""
    for each in described_figures(name):
        sides, text = each.language.words("figure_side"), each.figure.alt
        phrases = {key: each.words[key].split("{touch}")[0] for key in ("rope_pulley", "rope_disc", "rope_larger_rim")}
        if name in ("movable_pulley", "winch_with_pulley"):
            pulley = pattern(phrases["rope_pulley"] + each.words["rope_round"]).pattern.removesuffix(r"\Z")
            over = [found["side"] for found in re.finditer(pulley.replace(".+?", "[^()]+?"), text)]
            assert set(over) == {sides["n"]} or (each.variant.form.name == "differential" and not over), text
            movable = each.words["rope_round"].format(side=sides["s"])
            assert text.count(movable) == 1
        if name == "pulley_and_wheel":
            key = "w" if each.z["B"].real < each.z["O"].real else "e"
            rim = phrases["rope_larger_rim"].split("{disc")[0]
            assert re.search(f"{rim}[^()]+" + re.escape(each.words["rope_leaves"].format(side=sides[key])), text), text
        if name == "spool":
            over = "ne" if each.z["B"].real > each.z["O"].real else "nw"
            assert each.words["rope_round"].format(side=sides[over]) in text, text
