"""Statements and figures: complete in every language, in agreement with each other, sound."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

from msgspec.structs import replace

from variantgen.check.cranks import wrong_cranks
from variantgen.check.glossary import family_words
from variantgen.check.languages import differing
from variantgen.check.letters import ambiguous_letters
from variantgen.check.printed import print_mismatches
from variantgen.check.report import Report
from variantgen.check.senses import wrong_senses
from variantgen.check.statement_reading import read_sheet
from variantgen.errors import VariantgenError
from variantgen.families.family import Family
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.figure.build import statement_figure
from variantgen.figure.inspection.arrow_faults import inspect_arrows
from variantgen.figure.inspection.faults import figure_faults, unmarked_points
from variantgen.mechanism.motion import Motion
from variantgen.resources import languages
from variantgen.variants.printed_data import given_names, shown_points
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Formula, Symbol, letters
from variantgen.wording.language import Language, load_language
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.statement import Statement, statement

_FIGURES = 20  # variants per form whose figure is drawn and compared with the statement
_TURNED = 8  # those of them whose cranks are turned full circle, a tenth of a second each


def check_languages(family: Family, report: Report) -> None:
    """A title and the names of bodies in every language (a statement is looked for with the variants).

    A scene of one's own has the name of its file for a title.
    """
    for where, message in family_words(family):
        report.remark(f"{where}: {message}")
    for name in languages():
        if not family.titles.get(name) and not family.is_scene:
            report.fail(f'none in the language {name}; write title = {{ {name} = "..." }}', "title")
        known = load_phrases(name).bodies
        for noun in sorted({noun for form in family.forms.values() for noun in form.nouns.values()} - set(known)):
            report.fail(f"{noun!r} has no name in the language {name}; known: {', '.join(known)}", "nouns")


def check_texts(variants: Sequence[Variant], motion: Motion, report: Report) -> None:
    """Statements in every language and figures of the first variants of a form, and whether all of them agree."""
    if variants[0].family.is_scene:
        return  # a one-off scene file has no statement
    asked = [parse_quantity(text, variants[0].form.sample) for text in variants[0].form.ask]
    for name in languages():
        language = load_language(name)
        for message in ambiguous_letters(variants[0].form, asked, language):
            report.fail(message, f"statement.{name}.j2", message)
        for i, variant in enumerate([_at_constant_speed(variants[0]), *variants[:_FIGURES]]):
            found = _failures(variant, asked, language, motion, max(0, i - 1))
            for where, message in found:
                report.fail(message, where)
            if found:
                break
    _check_agreement(variants[:_FIGURES], asked, motion, report)
    _look_at_arrows(variants[:_FIGURES], asked, motion, report)


def _look_at_arrows(variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, report: Report) -> None:
    """Remark on arrows that cross lines or may be misread: each kind of fault once for a form, with its count."""
    seen: dict[str, list[str]] = {}
    for place, variant in enumerate(variants):
        drawing = statement_figure(variant, motion, place, asked, load_language(languages()[0]))
        faults_of = inspect_arrows(drawing).by_kind
        places = {point: drawing.scale * complex(motion.z[point][place]) for point in shown_points(variant, asked)}
        unmarked = unmarked_points(drawing, {point: at + drawing.origin for point, at in places.items()})
        faults_of["unmarked"] = [f"nothing is drawn at the point {point}" for point in unmarked]
        for kind, faults in faults_of.items():
            seen.setdefault(kind, []).extend(f"figure, {_where(variant, place)}: {fault}" for fault in faults)
    for found in seen.values():
        if found:
            others = f" (so do {len(found) - 1} more)" if len(found) > 1 else ""
            report.remark(f"{found[0]}{others}")


def _check_agreement(variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, report: Report) -> None:
    """What is printed is solved, words for senses agree with the numbers, the languages say the same."""
    spoken = [load_language(name) for name in languages()]
    for place, variant in enumerate(variants):
        try:
            said = [statement(variant, asked, language) for language in spoken]
        except VariantgenError:
            return  # it has been told with the statements
        form, where = variant.form, _where(variant, place)
        sheets = [read_sheet(text, form, language) for text, language in zip(said, spoken, strict=True)]
        for kind, message in print_mismatches(variant, motion, place, sheets):
            report.fail(message, where, kind)
        for sheet in sheets:
            for kind, message in wrong_senses(sheet, variant, motion, place):
                report.fail(message, f"statement.{sheet.language}.j2, {where}", f"{sheet.language} {kind}")
        for language, (kind, message) in wrong_cranks(sheets, motion, place) if place < _TURNED else ():
            report.fail(message, f"statement.{language}.j2, {where}", f"{language} {kind}")
        for found in differing(sheets, given_names(variant, asked), form):
            if found.sure:
                report.fail(found.message, f"statement.{found.language}.j2, {where}", f"{found.language} {found.kind}")
            else:
                report.remark(f"statement.{found.language}.j2: {found.message}; is it meant?")


def _where(variant: Variant, place: int) -> str:
    """The form and the seed of a variant, for messages."""
    return f"form {variant.form.name!r}, seed {place}" if variant.form.name else f"seed {place}"


def check_quantities(variant: Variant, report: Report) -> None:
    """The statement and the figure of a variant for each single quantity that may be asked."""
    if variant.family.is_scene:
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
            report.fail(str(error), f"form {form.name!r}, asked {name} alone" if form.name else f"asked {name} alone")


def _at_constant_speed(variant: Variant) -> Variant:
    """The variant with all accelerations zero that are given as numbers: its text must not speak of them."""
    graphed = variant.form.figure.graph
    second = variant.form.of_accelerations_alone - set(graphed)
    return replace(variant, printed={n: Decimal(0) if n in second else v for n, v in variant.printed.items()})


def _failures(
    variant: Variant, asked: Sequence[Quantity], language: Language, motion: Motion, place: int
) -> list[tuple[str, str]]:
    """The statement names every given and asked quantity, and so does the figure: places and messages of failures."""
    where = f"statement.{language.name}.j2, {_where(variant, place)}"
    try:
        said = statement(variant, asked, language)
    except VariantgenError as error:
        return [(where, str(error))]
    drawing = statement_figure(variant, motion, place, asked, language)
    found = [(f"figure, {_where(variant, place)}", str(fault)) for fault in figure_faults(drawing)]
    if not drawing.alt:
        found.append((where, "the figure is not told in words"))
    drawn: set[Formula] = {label.formula for label in drawing.labels}
    found += [(where, f"the figure does not show {name}") for name in _unshown(variant, asked, language, drawn)]
    for point in sorted({q.point for q in asked} - {""}):
        if Symbol(point) not in drawn:
            found.append((where, f"the figure does not name {point}"))
    for body in variant.form.bodies:
        symbol = language.symbol(body, variant.form.symbols)
        if symbol.base.isdecimal() and symbol in said.text and symbol not in drawn:
            found.append((where, f"the figure does not show the number {symbol.base} of {body}"))
    return found + [(where, message) for message in _unsaid(said, variant, asked, language)]


def _unshown(variant: Variant, asked: Sequence[Quantity], language: Language, drawn: set[Formula]) -> list[str]:
    """Given data that the figure should show and does not; constants and times have no place in it."""
    found, alone = [], variant.form.of_accelerations_alone
    for name in given_names(variant, asked):
        parameter = variant.form.parameters[name]
        symbol = language.symbol(parameter.symbol, variant.form.symbols)
        timeless = parameter.unit is None or parameter.unit.measures != "time"
        # An acceleration in a law of time stands in the text; the figure would show the sense of a negative one.
        is_of_law = parameter.of_second_order and name not in alone and min(parameter.printed) >= 0
        if timeless and not parameter.constant and not is_of_law and not _is_named(symbol, drawn):
            found.append(name)
    return found


def _unsaid(said: Statement, variant: Variant, asked: Sequence[Quantity], language: Language) -> list[str]:
    """Rates and angles that are given, but not explained in the text."""
    if not said.text:
        return ["the statement is empty"]
    spoken = {part for part in said.text if isinstance(part, Symbol)}
    found = []
    for name in given_names(variant, asked):
        parameter = variant.form.parameters[name]
        symbol = language.symbol(parameter.symbol, variant.form.symbols)
        is_length = parameter.unit is not None and parameter.unit.measures == "length"
        if not is_length and symbol not in spoken and name not in variant.form.figure.graph:
            found.append(f"the text does not say what {name} is")
    return found


def _is_named(symbol: Symbol, drawn: set[Formula]) -> bool:
    """A symbol is in the figure as a label, or as two labelled points (the length OA of a link)."""
    ends = [Symbol(letter + number) for letter, number in letters(symbol.base)] if not symbol.index else []
    return symbol in drawn or (len(ends) == 2 and all(end in drawn for end in ends))
