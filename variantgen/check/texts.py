"""Statements and figures: complete in every language, in agreement with each other, sound."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import replace
from decimal import Decimal

from variantgen.check.report import Report
from variantgen.errors import VariantgenError
from variantgen.families.family import Family
from variantgen.families.hints import DIRECTIONS
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.figure.build import statement_figure
from variantgen.figure.faults import figure_faults
from variantgen.mechanism.motion import Motion, take_scene
from variantgen.variants.needed import given_names
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Formula, Symbol, letters
from variantgen.wording.language import Language, languages, load_language
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.statement import Statement, statement

_EQUAL = 1e-6  # relative: what a mark may differ from its parameter by rounding
_FIGURES = 20  # variants per form whose figure is drawn and compared with the statement


def check_languages(family: Family, report: Report) -> None:
    """A title and the names of bodies in every language (a statement is looked for with the variants)."""
    for name in languages():
        if not family.titles.get(name):
            report.failures.append(f'title: none in the language {name}; write title = {{ {name} = "..." }}')
        known = load_phrases(name).bodies
        for noun in sorted({noun for form in family.forms.values() for noun in form.nouns.values()} - set(known)):
            report.failures.append(f"nouns: {noun!r} has no name in the language {name}; known: {', '.join(known)}")


def check_texts(variants: Sequence[Variant], motion: Motion, report: Report) -> None:
    """Statements in every language and figures of the first variants of a form; one finding of a kind is enough."""
    if variants[0].family.folder is None:
        return  # a one-off scene file has no statement
    asked = [parse_quantity(text, variants[0].form.sample) for text in variants[0].form.ask]
    for name in languages():
        language = load_language(name)
        for i, variant in enumerate([_at_constant_speed(variants[0]), *variants[:_FIGURES]]):
            found = _failures(variant, asked, language, motion, max(0, i - 1))
            report.failures += found
            if found:
                break


def check_quantities(variant: Variant, report: Report) -> None:
    """The statement and the figure of a variant for each single quantity that may be asked."""
    if variant.family.folder is None:
        return
    form = variant.form
    given = {parameter.symbol for parameter in form.parameters.values() if parameter.given}
    motion = solve_variants([variant], 0)
    for name in (name for name in form.askable if "." not in name and name not in given):
        asked = [parse_quantity(name, form.sample)]
        try:
            for language_name in languages():
                statement(variant, asked, load_language(language_name))
            statement_figure(variant, motion, 0, asked, load_language(languages()[0]))
        except VariantgenError as error:
            report.failures.append(f"form {form.name!r}, asked {name} alone: {error}")


def _false_marks(variant: Variant, motion: Motion, place: int) -> list[str]:
    """Marks of the figure whose size is not that of their parameter."""
    values = variant.form.values({name: variant.si(name) for name in variant.form.parameters})
    hints, z = variant.form.figure, {name: complex(motion.z[name][place]) for name in motion.z}
    frame = take_scene(motion.scene, place, motion.size).frame

    def ray(corner: str, name: str) -> complex:
        return complex(frame.place(DIRECTIONS[name])) if name in DIRECTIONS else z[name] - z[corner]

    found = [
        (mark.name, abs(cmath.phase(ray(mark.at, mark.end) / ray(mark.at, mark.start))), "angle")
        for mark in hints.angles
    ]
    found += [(mark.name, abs(z[mark.end] - z[mark.start]), "length") for mark in hints.lengths]
    skew = [
        f"the angle marked as right at {mark.at} is not right"
        for mark in hints.right_angles
        if abs(math.cos(cmath.phase(ray(mark.at, mark.end) / ray(mark.at, mark.start)))) > _EQUAL
    ]
    found += [(disc.name, float(disc.radius.value(values)), "radius") for disc in hints.discs if disc.name]
    return skew + [
        f"the {kind} marked {name} is not the given one"
        for name, size, kind in found
        if not _same(size, float(values[name]), kind)
    ]


def _same(size: float, value: float, kind: str) -> bool:
    if kind == "angle":
        return abs(math.cos(size) - math.cos(value)) < _EQUAL
    return abs(size - abs(value)) < _EQUAL * (size + abs(value))


def _at_constant_speed(variant: Variant) -> Variant:
    """The variant with all given accelerations zero: its text must not speak of them."""
    second = {name for name, parameter in variant.form.parameters.items() if parameter.of_second_order}
    return replace(variant, printed={n: Decimal(0) if n in second else v for n, v in variant.printed.items()})


def _failures(variant: Variant, asked: Sequence[Quantity], language: Language, motion: Motion, place: int) -> list[str]:
    """The statement names every given and asked quantity, and so does the figure."""
    where = f"statement.{language.name}.j2, form {variant.form.name!r}, seed {place}"
    try:
        said = statement(variant, asked, language)
    except VariantgenError as error:
        return [f"{where}: {error}"]
    drawing = statement_figure(variant, motion, place, asked, language)
    found = [f"figure, form {variant.form.name!r}, seed {place}: {fault}" for fault in figure_faults(drawing)]
    if not drawing.alt:
        found.append(f"{where}: the figure is not told in words")
    drawn: set[Formula] = {label.formula for label in drawing.labels}
    found += [f"{where}: {fault}" for fault in _false_marks(variant, motion, place)]
    found += [f"{where}: the figure does not show {name}" for name in _unshown(variant, asked, language, drawn)]
    for point in sorted({q.point for q in asked} - {""}):
        if Symbol(point) not in drawn:
            found.append(f"{where}: the figure does not name {point}")
    return found + _unsaid(said, variant, asked, language, where)


def _unshown(variant: Variant, asked: Sequence[Quantity], language: Language, drawn: set[Formula]) -> list[str]:
    """Given data that the figure should show and does not; constants and times have no place in it."""
    found = []
    for name in given_names(variant, asked):
        parameter = variant.form.parameters[name]
        symbol = language.symbol(parameter.symbol, variant.form.symbols)
        timeless = parameter.unit is None or parameter.unit.measures != "time"
        if timeless and not parameter.constant and not _is_named(symbol, drawn):
            found.append(name)
    return found


def _unsaid(said: Statement, variant: Variant, asked: Sequence[Quantity], language: Language, where: str) -> list[str]:
    """Rates and angles that are given, but not explained in the text."""
    if not said.text:
        return [f"{where}: the statement is empty"]
    spoken = {part for part in said.text if isinstance(part, Symbol)}
    found = []
    for name in given_names(variant, asked):
        parameter = variant.form.parameters[name]
        symbol = language.symbol(parameter.symbol, variant.form.symbols)
        is_length = parameter.unit is not None and parameter.unit.measures == "length"
        if not is_length and symbol not in spoken:
            found.append(f"{where}: the text does not say what {name} is")
    return found


def _is_named(symbol: Symbol, drawn: set[Formula]) -> bool:
    """A symbol is in the figure as a label, or as two labelled points (the length OA of a link)."""
    ends = [Symbol(letter + number) for letter, number in letters(symbol.base)] if not symbol.index else []
    return symbol in drawn or (len(ends) == 2 and all(end in drawn for end in ends))
