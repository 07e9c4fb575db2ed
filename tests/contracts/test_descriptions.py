"""One body over every family: the text in words says what the figure shows, truly, and nothing else."""

from __future__ import annotations

import importlib
import importlib.util
import math
import re
import string
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import pytest

from variantgen.families.hints import DIRECTIONS
from variantgen.families.load import family_names, load_family
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Drawing
from variantgen.mechanism.component import discover
from variantgen.mechanism.drivers.circling import Circling
from variantgen.mechanism.drivers.extension import Extension
from variantgen.mechanism.drivers.relative_travel import RelativeTravel
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.drivers.vector_motion import VectorMotion
from variantgen.mechanism.motion import Motion, take_scene
from variantgen.mechanism.relative import relative_motion
from variantgen.variants.draw import Drawing as VariantDrawing
from variantgen.variants.needed import given_names, shown_points
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import About, letters, to_plain
from variantgen.wording.language import Language, languages, load_language

FAMILIES = family_names()
KINDS = [*discover("variantgen.mechanism.joints"), *discover("variantgen.mechanism.drivers")]
SEEDS = 3
COMPASS = ("e", "ene", "ne", "nne", "n", "nnw", "nw", "wnw", "w", "wsw", "sw", "ssw", "s", "sse", "se", "ese")


@dataclass(frozen=True)
class Told:
    """A figure in one language with what it was made of."""

    variant: Variant
    asked: list[Quantity]
    motion: Motion
    place: int
    language: Language
    figure: Drawing

    @property
    def z(self) -> dict[str, complex]:
        return {name: complex(self.motion.z[name][self.place]) for name in self.motion.z}

    @property
    def words(self) -> dict[str, str]:
        return dict(self.language.words("figure"))

    @property
    def labels(self) -> set[str]:
        return {to_plain(label.formula) for label in self.figure.labels}

    def named(self, name: str) -> str:
        return to_plain(self.language.symbol(name, self.variant.form.symbols))

    def items(self, key: str) -> list[str]:
        """The items of a sentence like ``Positions: a; b.``; none where there is no such sentence."""
        head, tail = self.words[key].split("{items}")
        found = re.search(re.escape(head) + "(.*?)" + re.escape(tail) + "(?: |$)", self.figure.alt)
        return found[1].split("; ") if found else []


@cache
def told(name: str, velocities: bool = False) -> list[Told]:
    """Every form and language, a few variants each; with ``velocities`` only what needs no accelerations is asked."""
    found = []
    for form in load_family(name).forms.values():
        family = replace(load_family(name), forms={form.name: form})
        variants = VariantDrawing(family, None).after([("told", i) for i in range(SEEDS)], [0] * SEEDS)
        motion = solve_variants(variants, 2)
        asked = [parse_quantity(text, form.sample) for text in form.ask]
        if velocities:
            asked = [q for q in asked if q.order == 1]
        for language in map(load_language, languages()):
            for i, variant in enumerate(variants if asked else []):
                figure = statement_figure(variant, motion, i, asked, language)
                found.append(Told(variant, asked, motion, i, language, figure))
    return found


def pattern(phrase: str, **groups: str) -> re.Pattern[str]:
    """A phrase as a pattern that fits a whole item; its slots are the named groups."""
    parts = []
    for text, slot, _, _ in string.Formatter().parse(phrase):
        parts.append(re.escape(text))
        if slot:
            parts.append(f"(?P<{slot}>{groups.get(slot, '.+?')})")
    return re.compile("".join(parts) + r"\Z")


def asked_together(name: str, quantity: str) -> list[Told]:
    """The first form of a family in each language, with one quantity asked."""
    form = next(iter(load_family(name).forms.values()))
    variants = VariantDrawing(load_family(name), None).after([("told", 0)], [0])
    asked = [parse_quantity(quantity, form.sample)]
    motion = solve_variants(variants, 2)
    spoken = [load_language(lang) for lang in languages()]
    return [
        Told(variants[0], asked, motion, 0, language, statement_figure(variants[0], motion, 0, asked, language))
        for language in spoken
    ]


def words_of(text: str) -> set[str]:
    """Names and symbols in a text: everything in Latin or Greek letters and digits."""
    return set(
        re.findall(r"[A-Za-zα-ωΑ-Ω][A-Za-zα-ω0-9]*(?:_[A-Za-zа-яА-Яα-ω0-9]+(?: [A-Z]\d?(?![a-z0-9A-Z]))?)?", text)
    )


@pytest.mark.parametrize("name", FAMILIES)
def test_text_is_whole_and_short(name: str) -> None:
    for each in told(name):
        text = each.figure.alt
        assert 100 < len(text) <= 900, text
        assert 3 <= len(re.findall(r"\.(?: |$)", text)) <= 8, text
        assert text[0].isupper()
        assert text[-1] == "."
        assert not re.search(r"[{}]|None|  | [,.;)]|\( |\(\)|;\.|:\.", text), text


@pytest.mark.parametrize("velocities", [False, True])
@pytest.mark.parametrize("name", FAMILIES)
def test_everything_labelled_is_named_and_nothing_else(name: str, velocities: bool) -> None:
    for each in told(name, velocities):
        text = each.figure.alt
        points = {each.named(point) for point in shown_points(each.variant, each.asked)}
        assert points <= each.labels
        said = words_of(text)
        spelled = {"".join(part) for word in said if "_" not in word for part in letters(word)}
        for label in each.labels:
            standing = re.search(rf"(?<!\w){re.escape(label)}(?!\w)", text)
            assert standing or (label in points and label in spelled), (label, text)
        # Letters and symbols of the text are those of the figure; names of bodies are spelled with its points.
        if each.language.name == "ru":
            names = said
        else:
            names = {word for word in said if re.search(r"[A-Zα-ω0-9_]", word[1:] or word) or len(word) == 1} - {"a"}
        for word in names:
            parts = {"".join(part) for part in letters(word)} if "_" not in word else set()
            assert word in each.labels or (parts and parts <= points), (word, text)


@pytest.mark.parametrize(("quantity", "shown"), [("v_B.x", True), ("v_B.angle", True), ("v_B", False)])
def test_axes_are_told_where_they_are_drawn(quantity: str, shown: bool) -> None:
    for each in asked_together("slider_crank", quantity):
        assert ({"x", "y"} <= each.labels) is shown
        assert (each.words["axes"] in each.items("marks")) is shown


@pytest.mark.parametrize("name", ["point_on_rotating_disc", "sliding_block_on_rotating_rod"])
def test_right_angles_are_told_and_right(name: str) -> None:
    marked = [each for each in told(name) if each.variant.form.figure.right_angles]
    assert marked
    for each in marked:
        said = [item for item in each.items("marks") if pattern(each.words["right_angle"], corner=".*?").match(item)]
        for mark, item in zip(each.variant.form.figure.right_angles, said, strict=True):
            start, end = (each.z[name] - each.z[mark.at] for name in (mark.start, mark.end))
            assert abs((start * end.conjugate()).real) < 1e-9 * abs(start * end)
            assert each.words["at_corner"].format(corner=mark.at) in item


@pytest.mark.parametrize("name", FAMILIES)
def test_nothing_asked_is_told(name: str) -> None:
    for each in told(name):
        for quantity in each.asked:
            formula = each.language.quantity(quantity, each.variant.form.symbols)
            symbol = to_plain(formula.symbol if isinstance(formula, About) else formula)
            assert not re.search(rf"(?<!\w){re.escape(symbol)}(?!\w)", each.figure.alt), (symbol, each.figure.alt)


@pytest.mark.parametrize("name", FAMILIES)
def test_each_language_keeps_to_its_letters(name: str) -> None:
    for each in told(name):
        if each.language.name == "ru":
            assert not re.search(r"[a-z]{2}", each.figure.alt.replace("rel", "")), each.figure.alt
        else:
            assert not re.search("[А-Яа-яЁё]", each.figure.alt), each.figure.alt


@pytest.mark.parametrize("name", FAMILIES)
def test_languages_say_the_same(name: str) -> None:
    by_variant: dict[int, list[Told]] = {}
    for each in told(name):
        by_variant.setdefault(id(each.variant), []).append(each)
    for group in by_variant.values():
        for key in ("parts", "positions", "marks", "arrows"):
            assert len({len(each.items(key)) for each in group}) == 1, [each.figure.alt for each in group]
        assert len({each.figure.alt.count(".") for each in group}) == 1


def sector(vector: complex) -> str:
    """The direction of a vector in degrees, from a table: within 1 of an axis, within 22.5 of it, or else."""
    angle = math.degrees(math.atan2(vector.imag, vector.real)) % 360
    bounds = (1, 22.5, 67.5, 89, 91, 112.5, 157.5, 179, 181, 202.5, 247.5, 269, 271, 292.5, 337.5, 359)
    return COMPASS[sum(angle >= bound for bound in bounds) % 16]


@pytest.mark.parametrize("name", FAMILIES)
def test_positions_are_true_and_complete(name: str) -> None:
    for each in told(name):
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


def is_between(each: Told, z: dict[str, complex], point: str) -> bool:
    """Whether the parts say of a point that it lies between the ends of a bar, and it does."""
    phrase = pattern(each.words["points_on_bar"], bar=r"(?:[A-Z]\d?){2}", points=r"[^()]+").pattern.removesuffix(r"\Z")
    for found in re.finditer(phrase, each.figure.alt):
        first, second = ("".join(part) for part in letters(found["bar"]))
        if point in words_of(found["points"]):
            part = (z[point] - z[first]) / (z[second] - z[first])
            return 0 < part.real < 1 and abs(part.imag) < 1e-9
    return False


def said_arrows(each: Told) -> dict[str, str]:
    """What the text says of each given rate, by its symbol."""
    symbols = sorted(each.labels, key=len, reverse=True)
    return {next(s for s in symbols if item.startswith(s + " ")): item for item in each.items("arrows")}


@pytest.mark.parametrize("name", FAMILIES)
def test_every_given_rate_has_its_arrow(name: str) -> None:
    for each in told(name):
        rates = {
            each.named(parameter.symbol)
            for key in given_names(each.variant, each.asked)
            if (parameter := each.variant.form.parameters[key]).is_rate and each.variant.printed[key] != 0
        }
        constants = {
            each.named(parameter.symbol) for parameter in each.variant.form.parameters.values() if parameter.constant
        }
        assert rates <= set(said_arrows(each)) <= rates | constants, each.figure.alt


def rotations(each: Told) -> dict[str, float]:
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
    for each in told(name):
        arrows = {symbol: item for symbol, item in said_arrows(each).items() if symbol[0] in "ωε"}
        solved = {key: rate for key, rate in rotations(each).items() if rate != 0}
        assert len(arrows) == len(solved), each.figure.alt
        # Told in the order of the drivers, the angular velocity before the angular acceleration.
        for (symbol, item), (key, rate) in zip(arrows.items(), solved.items(), strict=True):
            assert symbol[0] == key[0]
            right, wrong = each.words["counter_clockwise"], each.words["clockwise"]
            if rate < 0:
                right, wrong = wrong, right
            assert re.search(rf"(?<![\w-]){right}", item), item
            assert not re.search(rf"(?<![\w-]){wrong}", item), item


def vectors(each: Told) -> list[complex]:
    """Given vectors on paper, by driver, velocity before acceleration; the velocity of a free fall is not given."""
    scene = take_scene(each.motion.scene, each.place, each.motion.size)
    falls = any(parameter.constant for parameter in each.variant.form.parameters.values())
    found = []
    for driver in scene.drivers:
        if isinstance(driver, Travel | VectorMotion):
            found += [] if falls else [(driver.v, driver.angle)]
            found += [(driver.a, driver.angle if isinstance(driver, Travel) else driver.a_angle)]
    return [complex(scene.frame.place(float(r) * np.exp(1j * float(angle)))) for r, angle in found if r != 0]


@pytest.mark.parametrize("name", FAMILIES)
def test_straight_arrows_point_where_the_drivers_do(name: str) -> None:
    for each in told(name):
        ways = vectors(each)
        if not ways:
            continue
        items = [item for symbol, item in said_arrows(each).items() if symbol[0] not in "ωε"]
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
    for each in told(name):
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
    for each in told("hydraulic_hoist"):
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
    for each in told(name):
        hints = [mark for mark in each.variant.form.figure.angles if mark.name in given_names(each.variant, each.asked)]
        items = each.items("marks")
        frame = take_scene(each.motion.scene, each.place, each.motion.size).frame
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


@pytest.mark.parametrize("lang", languages())
@pytest.mark.parametrize("stem", KINDS)
def test_every_joint_and_driver_has_its_phrase(stem: str, lang: str) -> None:
    phrases = load_language(lang).words("figure")
    assert any(key == stem or key.startswith(stem + "_") for key in phrases), f"[figure] {stem} = ... in {lang}.toml"
    name = f"variantgen.figure.telling.kinds.{stem}"
    if importlib.util.find_spec(name) is None:
        assert stem in phrases, "a kind without a module of its own is told by the phrase of its name"
    else:
        assert callable(importlib.import_module(name).tell)


def slots(phrase: str) -> set[str]:
    return {slot for _, slot, _, _ in string.Formatter().parse(phrase) if slot}


@pytest.mark.parametrize("table", ["figure", "figure_place", "figure_way", "figure_side", "figure_line"])
def test_languages_have_the_same_phrases_with_the_same_slots(table: str) -> None:
    spoken = [load_language(lang).words(table) for lang in languages()]
    for words in spoken[1:]:
        assert list(words) == list(spoken[0])
        assert {key: slots(text) for key, text in words.items()} == {key: slots(t) for key, t in spoken[0].items()}


@pytest.mark.parametrize("lang", languages())
def test_directions_have_different_words(lang: str) -> None:
    language = load_language(lang)
    for table in ("figure_place", "figure_way"):
        assert sorted(language.words(table)) == sorted(COMPASS)
        assert len(set(language.words(table).values())) == len(COMPASS)
