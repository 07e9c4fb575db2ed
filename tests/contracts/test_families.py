"""One body over every family of the catalogue: worked cases, many seeds, both languages, figures."""

from __future__ import annotations

import numpy as np
import pytest

from variantgen.check import check_family
from variantgen.families.cases import load_cases
from variantgen.families.load import family_names, load_family
from variantgen.families.quantities import parse_quantity
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Arc, Drawing, Label, Layer
from variantgen.variants.draw import Drawing as VariantDrawing
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import to_plain, to_typst
from variantgen.wording.language import languages, load_language
from variantgen.wording.statement import statement

FAMILIES = family_names()
GOLDEN = {
    "four_bar": {"K26", "M26", "M35"},
    "sleeve_on_crank": {"K27"},
    "rolling_wheel": {"M24", "M31"},
    "spool": {"M34"},
}


@pytest.mark.parametrize("name", FAMILIES)
def test_check_is_green(name: str) -> None:
    report = check_family(name, seeds=200)
    assert report.failures == []
    assert report.acceptance >= 0.02
    assert report.worst_deviation < 1e-7


@pytest.mark.parametrize("name", sorted(GOLDEN))
def test_golden_cases_are_there(name: str) -> None:
    cases = {case.id: case for case in load_cases(load_family(name))}
    assert cases.keys() >= GOLDEN[name]
    for case in cases.values():
        assert case.source
        assert max(case.deviations(load_family(name).length_unit).values()) < 1e-12


def test_printed_values_differ_from_the_exact_ones_only_where_an_erratum_says_so() -> None:
    for name in FAMILIES:
        for case in load_cases(load_family(name)):
            apart = [key for key, value in case.printed.items() if abs(value - case.exact[key]) > 0.006 * abs(value)]
            assert bool(apart) == bool(case.erratum), (case.id, apart)


def drawn(name: str, count: int) -> list[tuple[Variant, Drawing]]:
    """Variants of all forms of a family with their figures."""
    language = load_language("en")
    found = []
    for form in load_family(name).forms.values():
        from dataclasses import replace

        family = replace(load_family(name), forms={form.name: form})
        variants = VariantDrawing(family, None).after([("figure", i) for i in range(count)], [0] * count)
        motion = solve_variants(variants, 0)
        for i, variant in enumerate(variants):
            asked = [parse_quantity(text, form.sample) for text in form.ask]
            found.append((variant, statement_figure(variant, motion, i, asked, language)))
    return found


def overlap(first: Label, second: Label) -> bool:
    gap = first.at - second.at
    return abs(gap.real) < 0.5 * (first.size[0] + second.size[0]) and abs(gap.imag) < 0.5 * (
        first.size[1] + second.size[1]
    )


@pytest.mark.parametrize("name", FAMILIES)
def test_labels_do_not_overlap_and_stay_on_the_paper(name: str) -> None:
    for variant, figure in drawn(name, 60):
        for i, label in enumerate(figure.labels):
            assert label.at.real - label.size[0] / 2 >= 0
            assert label.at.real + label.size[0] / 2 <= figure.width
            assert label.at.imag - label.size[1] / 2 >= 0
            assert label.at.imag + label.size[1] / 2 <= figure.height
            for other in figure.labels[:i]:
                assert not overlap(label, other), (variant.printed, to_plain(label.formula), to_plain(other.formula))


@pytest.mark.parametrize("name", FAMILIES)
def test_statements_in_both_languages_say_the_same(name: str) -> None:
    for variant, _ in drawn(name, 3):
        asked = [parse_quantity(text, variant.form.sample) for text in variant.form.ask]
        said = {lang: statement(variant, asked, load_language(lang)) for lang in languages()}
        assert set(said) >= {"en", "ru"}
        # The same formulas occur (in whatever order), the same data are given.
        formulas = {
            lang: sorted({to_typst(part) for part in s.text if not isinstance(part, str)}) for lang, s in said.items()
        }
        assert formulas["en"] == formulas["ru"]
        assert len(said["en"].given) == len(said["ru"].given)


@pytest.mark.parametrize("name", FAMILIES)
def test_a_velocity_problem_says_nothing_about_accelerations(name: str) -> None:
    for variant, _ in drawn(name, 2):
        velocities = [q for text in variant.form.ask if (q := parse_quantity(text, variant.form.sample)).order == 1]
        for lang in languages():
            language = load_language(lang)
            said = statement(variant, velocities, language)
            text = "".join(part if isinstance(part, str) else to_plain(part) for part in said.text)
            assert "ускорени" not in text
            assert "acceleration" not in text
            assert not any("ε" in to_plain(e.left) or to_plain(e.left).startswith("a_") for e in said.given)
            figure = statement_figure(variant, solve_variants([variant], 0), 0, velocities, language)
            assert not any(to_plain(label.formula)[0] in "εa" for label in figure.labels)


@pytest.mark.parametrize("name", FAMILIES)
def test_arcs_of_omega_and_epsilon_cannot_be_taken_for_each_other(name: str) -> None:
    """Each label is nearer to its own arc than to the other, and the arcs lie in different directions."""
    for variant, figure in drawn(name, 60):
        arcs = [line for line in figure.lines if isinstance(line, Arc) and line.layer == Layer.VECTOR]
        labels = [label for label in figure.labels if to_plain(label.formula)[0] in "ωε"]
        assert len(arcs) == len(labels)
        if len(arcs) < 2:
            continue
        turn = np.angle(np.exp(1j * (arcs[0].start + arcs[0].sweep / 2 - arcs[1].start - arcs[1].sweep / 2)))
        assert abs(turn) > np.radians(90), variant.printed
        inner, outer = sorted(arcs, key=lambda arc: arc.radius)
        for label in labels:
            gaps = [min(abs(label.at - arc.at(t)) for t in np.linspace(0, 1, 20)) for arc in (inner, outer)]
            own = 0 if to_plain(label.formula)[0] == "ω" else 1
            assert gaps[own] < gaps[1 - own], (variant.printed, to_plain(label.formula))


@pytest.mark.parametrize("name", FAMILIES)
def test_the_sense_of_arcs_is_the_solved_one(name: str) -> None:
    for variant, figure in drawn(name, 20):
        motion = solve_variants([variant], 2)
        arcs = sorted(
            (line for line in figure.lines if isinstance(line, Arc) and line.layer == Layer.VECTOR),
            key=lambda a: a.radius,
        )
        driver = motion.scene.drivers[0]
        if not arcs:
            continue
        body = driver.body  # type: ignore[attr-defined]
        rates = [r for r in (motion.omega[body][0], motion.epsilon[body][0]) if r != 0]
        assert [np.sign(arc.sweep) for arc in arcs] == [np.sign(rate) for rate in rates]
        for language_name, words in (("en", ("speeds up", "slows down")), ("ru", ("ускоренное", "замедленное"))):
            asked = [parse_quantity(text, variant.form.sample) for text in variant.form.ask]
            said = statement(variant, asked, load_language(language_name))
            text = "".join(part if isinstance(part, str) else "" for part in said.text)
            if len(rates) == 2:
                assert (words[0] in text, words[1] in text) == (
                    (rates[0] > 0) == (rates[1] > 0),
                    (rates[0] > 0) != (rates[1] > 0),
                )


def test_figures_are_to_scale() -> None:
    # The hinge circles of the four-bar are where the solved points are: same shape, one scale, no distortion.
    for variant, figure in drawn("four_bar", 20):
        motion = solve_variants([variant], 0)
        circles = [line.centre for line in figure.lines if hasattr(line, "centre") and line.fill == "paper"]
        solved = [complex(motion.z[p][0]) for p in ("O", "A", "B", "C")]
        assert len(circles) == 4
        order = min(
            ([circles[i] for i in order] for order in permutations(4)),
            key=lambda places: misfit(places, solved),
        )
        assert misfit(order, solved) < 1e-9


def permutations(count: int) -> list[tuple[int, ...]]:
    from itertools import permutations as every

    return list(every(range(count)))


def misfit(places: list[complex], solved: list[complex]) -> float:
    """Residual of ``place = scale * z + shift`` with a real positive scale, relative."""
    p, z = np.array(places), np.array(solved)
    p, z = p - p.mean(), z - z.mean()
    scale = float(np.real(np.vdot(z, p)) / np.real(np.vdot(z, z)))
    return float(np.max(np.abs(p - scale * z)) / np.max(np.abs(p))) if scale > 0 else np.inf
