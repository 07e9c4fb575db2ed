"""One body over every family of the catalogue: worked cases, many seeds, both languages, figures."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import permutations

import numpy as np
import pytest
from msgspec.structs import replace

from tests.tools import NIGHTLY
from variantgen.check.family import check_family
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Arc, Drawing, Label, Layer
from variantgen.figure.inspection.arrow_faults import inspect_arrows
from variantgen.figure.inspection.faults import figure_faults, inspect_labels, leaders
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.resources import languages
from variantgen.variants.draw import FamilySampler as VariantDrawing
from variantgen.variants.printed_data import given_names
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Formula, to_plain, to_typst
from variantgen.wording.language import load_language
from variantgen.wording.notation import Notation
from variantgen.wording.statement import statement

FAMILIES = family_names()
SEEDS = 200 if NIGHTLY else 80
FIGURES = 60  # of a form
PLATES_AND_ROD = {"triangle_plate", "plate_acceleration_centre", "falling_rod"}  # few given data by nature


@pytest.mark.parametrize("name", FAMILIES)
def test_check_is_green(name: str) -> None:
    report = check_family(name, seeds=SEEDS)
    assert report.failures == []
    assert report.cases
    for form in report.forms:
        assert form.own_acceptance >= 0.02
        assert form.deviation < 1e-7
    assert sum(form.valid for form in report.forms) >= (1000 if name in PLATES_AND_ROD else 10_000)


def test_there_are_enough_families() -> None:
    assert len(FAMILIES) >= 28


Figures = list[list[tuple[Variant, Drawing]]]


@pytest.fixture(scope="module", params=FAMILIES)
def figures(request: pytest.FixtureRequest) -> Figures:
    """Variants of a family with their figures, form by form: all tests of one family use the same."""
    return drawn(request.param)


def first(figures: Figures, count: int) -> list[tuple[Variant, Drawing]]:
    """So many of each form."""
    return [found for of_form in figures for found in of_form[:count]]


def drawn(name: str) -> Figures:
    """Variants of all forms of a family with their figures."""
    language = load_language("en")
    found = []
    for form in load_family(name).forms.values():
        family = replace(load_family(name), forms={form.name: form})
        variants = VariantDrawing(family, None).after([("figure", i) for i in range(FIGURES)], [0] * FIGURES)
        motion = solve_variants(variants, 0)
        asked = [parse_quantity(text, form.sample) for text in form.ask]
        found.append([(v, statement_figure(v, motion, i, asked, language)) for i, v in enumerate(variants)])
    return found


def test_labels_and_arrows_are_clear_of_each_other_and_of_lines_and_on_the_paper(figures: Figures) -> None:
    every = first(figures, FIGURES)
    for variant, figure in every:
        seen = inspect_labels(figure)
        assert not (seen.overlaps or seen.crossed or seen.outside), (variant.form.name, variant.printed, seen)
        assert figure_faults(figure) == []
    # Arrows find room nearly always.
    crossed = [fault for _, figure in every for faults in inspect_arrows(figure).by_kind.values() for fault in faults]
    assert len(crossed) <= 0.05 * len(every), crossed


def test_data_are_printed_in_the_usual_order(figures: Figures) -> None:
    order = ["length", "angle", "time", "angular velocity", "velocity", "angular acceleration", "acceleration"]
    groups = [0, 1, 2, 3, 3, 4, 4]
    for variant, _ in first(figures, 2):
        asked = [parse_quantity(text, variant.form.sample) for text in variant.form.ask]
        given = [variant.form.parameters[n] for n in given_names(variant, asked)]
        found = [groups[order.index(p.unit.measures)] for p in given if p.unit and not p.constant]
        assert found == sorted(found)


def neutral(formula: Formula) -> str:
    """A formula without what differs between languages: the index of relative motion, the letter of the tangent."""
    return to_typst(formula).replace("отн", "rel").replace('"К"', '"Cor"').replace("_(tau)", "_(t)")


def test_statements_in_both_languages_say_the_same(figures: Figures) -> None:
    for variant, _ in first(figures, 3):
        asked = [parse_quantity(text, variant.form.sample) for text in variant.form.ask]
        said = {lang: statement(variant, asked, load_language(lang, Notation("alpha"))) for lang in languages()}
        assert set(said) >= {"en", "ru"}
        # The same formulas occur (in whatever order), the same data are given.
        formulas = {
            lang: sorted({neutral(part) for part in s.text if not isinstance(part, str)}) for lang, s in said.items()
        }
        assert formulas["en"] == formulas["ru"]
        assert len(said["en"].given) == len(said["ru"].given)


def test_a_velocity_problem_says_nothing_about_accelerations(figures: Figures) -> None:
    for variant, _ in first(figures, 2):
        velocities = [q for text in variant.form.ask if (q := parse_quantity(text, variant.form.sample)).order == 1]
        if not velocities:
            assert variant.form.may_ask  # a form that asks for accelerations only says what else may be asked
            continue
        constants = {variant.form.parameters[n].symbol for n, p in variant.form.parameters.items() if p.constant}
        for lang in languages():
            language = load_language(lang)
            said = statement(variant, velocities, language)
            text = "".join(part if isinstance(part, str) else to_plain(part) for part in said.text)
            if not constants:  # the text of a free fall speaks of g
                assert "ускорени" not in text
                assert "acceleration" not in text
            letter = "α" if lang == "en" else "ε"  # an angle alpha is delta in English
            assert not any(letter in to_plain(e.left) or to_plain(e.left).startswith("a_") for e in said.given)
            figure = statement_figure(variant, solve_variants([variant], 0), 0, velocities, language)
            shown = {to_plain(label.formula) for label in figure.labels} - constants
            assert not any(text[0] == letter or text.startswith("a_") for text in shown)


def ends_at(place: complex, label: Label) -> bool:
    step = place - label.at
    return abs(step.real) < 0.5 * label.size[0] + 0.8 and abs(step.imag) < 0.5 * label.size[1] + 0.8


def arcs_and_labels(figure: Drawing) -> list[tuple[Arc, Label]]:
    """The arcs of given rotation, each with the label that is nearest to it."""
    arcs = [line for line in figure.lines if isinstance(line, Arc) and line.layer == Layer.VECTOR]
    labels = [x for x in figure.labels if to_plain(x.formula)[0] in "ωα" and x.at.imag > figure.graphs]
    assert len(arcs) == len(labels)

    def gap(arc: Arc, label: Label) -> float:
        # A label far off has a leader, which begins at what it names.
        led = [line.points[0] for line in leaders(figure) if ends_at(line.points[-1], label)]
        return min(abs((led[0] if led else label.at) - arc.at(t)) for t in np.linspace(0, 1, 30))

    found = [(min(arcs, key=lambda arc: gap(arc, label)), label) for label in labels]
    # No label is nearer to another's arc than to its own: each arc has exactly one.
    assert len({id(arc) for arc, _ in found}) == len(arcs), [to_plain(label.formula) for label in labels]
    return found


def given_rates(variant: Variant) -> dict[str, float]:
    """Solved rates by the plain text of the symbol of their parameter, for each given rotation."""
    motion = solve_variants([variant], 2)
    language = load_language("en")
    found = {}
    for template, driver in zip(variant.form.drivers, motion.scene.drivers, strict=True):
        if not isinstance(driver, Rotation):
            continue
        for kind, table in (("omega", motion.omega), ("epsilon", motion.epsilon)):
            rate = table[driver.body][0] - (table[driver.relative_to][0] if driver.relative_to else 0.0)
            names = template.fields[kind].names if kind in template.fields else set()
            for name in sources(variant.form.derived, names):
                parameter = variant.form.parameters[name]
                if parameter.unit and parameter.unit.dimension == ((0, -1) if kind == "omega" else (0, -2)):
                    found[to_plain(language.symbol(parameter.symbol, variant.form.symbols))] = rate
    return found


def sources(derived: Mapping[str, FamilyExpression], names: Iterable[str]) -> set[str]:
    found: set[str] = set()
    for name in names:
        found |= sources(derived, derived[name].names) if name in derived else {name}
    return found


def test_arcs_of_rotation_are_told_apart_and_have_the_solved_sense(figures: Figures) -> None:
    for variant, figure in first(figures, 20):
        arcs = {to_plain(label.formula): arc for arc, label in arcs_and_labels(figure)}
        rates = given_rates(variant)
        assert set(arcs) == {symbol for symbol, rate in rates.items() if rate != 0}
        for symbol, arc in arcs.items():
            assert np.sign(arc.sweep) == np.sign(rates[symbol]), variant.printed
            # The two arcs of one body lie in different directions.
            other = arcs.get(symbol.replace("ω", "α"))
            if symbol.startswith("ω") and other is not None:
                middle, far = arc.start + arc.sweep / 2, other.start + other.sweep / 2
                assert abs(np.angle(np.exp(1j * (middle - far)))) > np.radians(90), variant.printed


def test_the_text_says_truly_whether_a_motion_speeds_up(figures: Figures) -> None:
    for variant, _ in first(figures, 10):
        motion = solve_variants([variant], 2)
        rates = [[float(np.ravel(d.rates(order)[0])[0]) for order in (1, 2)] for d in motion.scene.drivers]
        accelerated = [v * a > 0 for v, a in rates if v * a != 0]
        if len(motion.scene.drivers) != 1 or not accelerated:
            continue
        asked = [parse_quantity(text, variant.form.sample) for text in variant.form.ask]
        for language_name, words in (("en", (" increasing", " decreasing")), ("ru", ("ускоренн", "замедленн"))):
            said = statement(variant, asked, load_language(language_name))
            text = "".join(part if isinstance(part, str) else "" for part in said.text)
            assert (words[0] in text, words[1] in text) == (accelerated[0], not accelerated[0]), text


def test_figures_are_to_scale() -> None:
    # The hinge circles of the four-bar are where the solved points are: same shape, one scale, no distortion.
    for variant, figure in first(drawn("four_bar"), 20):
        motion = solve_variants([variant], 0)
        circles = [line.centre for line in figure.lines if hasattr(line, "centre") and line.fill == "paper"]
        solved = [complex(motion.z[p][0]) for p in ("O", "A", "B", "C")]
        assert len(circles) == 4
        order = min(
            ([circles[i] for i in order] for order in permutations(range(4))),
            key=lambda places: misfit(places, solved),
        )
        assert misfit(order, solved) < 1e-9


def misfit(places: list[complex], solved: list[complex]) -> float:
    """Residual of ``place = scale * z + shift`` with a real positive scale, relative."""
    p, z = np.array(places), np.array(solved)
    p, z = p - p.mean(), z - z.mean()
    scale = float(np.real(np.vdot(z, p)) / np.real(np.vdot(z, z)))
    return float(np.max(np.abs(p - scale * z)) / np.max(np.abs(p))) if scale > 0 else np.inf
