"""The statement of a variant: a template of the family, filled; given data; asked quantities.

A template yields prose with formulas in between. The result is a sequence of strings and formulas; strings are data
for every output and are never parsed as markup.
"""

from __future__ import annotations

import re
from collections.abc import Sequence, Set
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.families.family import Form
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import Quantity
from variantgen.variants.printed_data import given_names, shown_points
from variantgen.variants.variant import Variant, is_speeding_up, solve_variants
from variantgen.wording.formula import Equation, Formula, Measured, Symbol, UnitText, letters
from variantgen.wording.formula.tree import ANGLE
from variantgen.wording.graph_words import graph_instant, graph_sentences
from variantgen.wording.language import Language
from variantgen.wording.law_formula import event_of, interval_of, law_equations
from variantgen.wording.scene_data import guide_sentences, scene_data, with_formulas
from variantgen.wording.template import StatementTemplate, load_template
from variantgen.wording.text import Text

# Code points of the private use area enclose the number of a formula on its way through the template.
_OPEN, _CLOSE = "\ue000", "\ue001"
_MARK = re.compile(f"{_OPEN}(\\d+){_CLOSE}")


class Statement(Struct, frozen=True):
    """What a student reads: the text, the given data, the asked quantities with their units."""

    text: Text
    given: tuple[Equation, ...]
    asked: tuple[Formula, ...]


def statement(variant: Variant, asked: Sequence[Quantity], language: Language) -> Statement:
    """The statement of a variant. Raises InputError if the template is missing or faulty."""
    case = _case(variant, asked, language)
    return Statement((*_text(case), *graph_sentences(case.form, language)), tuple(_given(case, variant)), _asked(case))


def given(variant: Variant, asked: Sequence[Quantity], language: Language) -> list[Equation]:
    """The printed data: every parameter that the asked quantities need, as ``symbol = value unit``.

    The figure shows the sense of rates, so their magnitudes are printed. Accelerations are left out when only
    velocities are asked, angles and lengths of points that are not shown too.
    """
    return _given(_case(variant, asked, language), variant)


def _given(case: _Case, variant: Variant) -> list[Equation]:
    """The data of one of the variants of a case; angles of the position stand before the rates."""
    places: list[Equation] = []
    rates: list[Equation] = []
    for name, symbol, unit_text, is_rate in _data(case):
        value = variant.printed[name]
        if name in case.form.figure.graph:
            continue
        number = case.language.decimal(abs(value) if is_rate else value)
        (rates if is_rate else places).append(Equation(symbol, Measured(number, unit_text)))
    if variant.family.is_scene:
        own = scene_data(variant, case.asked, case.language)
        places, rates = places + own[0], rates + law_equations(case.form, case.language) + own[1]
    return places + _found(case, variant) + graph_instant(variant, case.language) + rates


def _found(case: _Case, variant: Variant) -> list[Equation]:
    """Angles of the solved position, to a hundredth of a degree: more than any tolerance needs."""
    corners = case.form.figure.found
    if not corners:
        return []
    z, degrees = solve_variants([variant], 0).z, case.language.unit(unit("deg"))
    return [
        Equation(Symbol(ANGLE + start + at + end), Measured(case.language.fixed(abs(angle), 2), degrees))
        for start, at, end in corners
        for angle in (float(np.degrees(np.angle((z[end] - z[at]) / (z[start] - z[at]))[0])),)
    ]


class _Case(Struct, frozen=True):
    """All that a text depends on; ``variant`` is one of those that have the same text.

    ``zero`` are the parameters that are zero, ``words`` those of choices, ``speeds`` whether what each driver gives
    gets faster.
    """

    form: Form
    asked: tuple[Quantity, ...]
    language: Language
    zero: tuple[str, ...]
    words: tuple[tuple[str, str], ...]
    speeds: tuple[bool, ...]
    variant: Variant

    @property
    def _kind(self) -> tuple[object, ...]:
        return self.form, self.asked, self.language, self.zero, self.words, self.speeds

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Case) and self._kind == other._kind

    def __hash__(self) -> int:
        return hash(self._kind)


def _case(variant: Variant, asked: Sequence[Quantity], language: Language) -> _Case:
    form = variant.form
    return _Case(
        form,
        tuple(asked),
        language,
        tuple(name for name, value in variant.printed.items() if value == 0),
        tuple((name, variant.word(name)) for name, p in form.parameters.items() if p.words),
        _speeds(variant),
        variant,
    )


def _asked(case: _Case) -> tuple[Formula, ...]:
    """The symbols of what is asked."""
    return tuple(case.language.quantity(quantity, case.form.symbols) for quantity in case.asked)


def _data(case: _Case) -> tuple[tuple[str, Symbol, UnitText, bool], ...]:
    """The parameters that are printed: name, symbol, unit, and whether the figure shows the sign."""
    found = []
    for name in given_names(case.variant, case.asked):
        parameter, language = case.form.parameters[name], case.language
        assert parameter.unit is not None
        symbol = language.symbol(parameter.symbol, case.form.symbols)
        found.append((name, symbol, language.unit(parameter.unit), parameter.is_rate))
    return tuple(found)


def _text(case: _Case) -> Text:
    """The filled template. A scene has words of the program."""
    variant, language = case.variant, case.language
    if variant.family.is_scene:
        words = language.words("sheet")
        begun = words[_scene_words(case.form)]
        guides = guide_sentences(variant, case.asked, language)
        if any(law.rate is not None and law.rate.start is not None for law in case.form.laws.values()):
            guides = (f" {words['law_start']}", *guides)
        if case.form.found_instant is not None:
            parts: dict[str, Formula] = {"event": event_of(variant, language)}
            parts["interval"] = interval_of(variant, language)
            return (*with_formulas(words["found_scene"], parts), *guides)
        if not any(quantity.is_of_interval for quantity in case.asked):
            return (begun, *guides)
        by_place = case.form.interval is not None and case.form.interval.is_of_place
        before, _, after = words["interval_by_place" if by_place else "interval"].partition("{interval}")
        return (begun, *guides, f" {before}", interval_of(variant, language), after)
    return _filled(case, load_template(template_path(variant, language)))


def _scene_words(form: Form) -> str:
    """The key of the words for a scene: without laws, with laws of time, with the velocity by the place."""
    by_place = [law for law in form.laws.values() if law.rate is not None and law.rate.is_by_place]
    if by_place:
        return "law_scene_by_place" if by_place[0].is_length else "law_scene_by_angle"
    return "law_scene" if form.laws else "scene"


@lru_cache(maxsize=1000)
def _filled(case: _Case, template: StatementTemplate) -> Text:
    """The text of a template: few texts differ, as data are printed beside them."""
    variant, asked, language, path = case.variant, case.asked, case.language, template.path
    formulas: list[Formula] = []

    def mark(formula: Formula) -> str:
        formulas.append(formula)
        return f"{_OPEN}{len(formulas) - 1}{_CLOSE}"

    context = _context(case)
    _check_own(template, context.keys())
    for name in sorted(template.variables - context.keys()):
        context[name] = _letters_symbol(name, variant, path)
    marked = {name: mark(value) if isinstance(value, Symbol) else value for name, value in context.items()}
    text = template.fill(marked)
    text = re.sub(r"\s+", " ", text).strip()
    runs = tuple(formulas[int(part)] if i % 2 else part for i, part in enumerate(_MARK.split(text)) if part or i % 2)
    _check_data(runs, variant, asked, language, path)
    return runs


def _check_own(template: StatementTemplate, known: Set[str]) -> None:
    """Raise InputError if a template sets a name that has a meaning already: the text would show another symbol."""
    problems = [
        Problem(
            f"line {line}: the name has a meaning already",
            file=str(template.path),
            value=name,
            remedy="set another name",
        )
        for name, line in template.own.items()
        if name in known
    ]
    if problems:
        raise InputError(problems)


def _check_data(runs: Text, variant: Variant, asked: Sequence[Quantity], language: Language, path: Path) -> None:
    """Raise InputError if the text names a datum that is not given (a zero acceleration, say)."""
    said = set(runs)
    known = given_names(variant, asked)
    for name, parameter in variant.form.parameters.items():
        symbol = language.symbol(parameter.symbol, variant.form.symbols)
        if parameter.given and name not in known and name not in variant.form.bodies and symbol in said:
            raise InputError(
                Problem(
                    "the text names a quantity that is not given here",
                    file=str(path),
                    value=name,
                    remedy=f'put it under {{% if not zero("{name}") %}} or {{% if accelerations %}}',
                )
            )


def template_path(variant: Variant, language: Language) -> Path:
    """The statement template of a family in a language. Raises InputError if there is none."""
    folder = variant.family.folder
    path = folder / f"statement.{language.name}.j2" if folder else None
    if path is None or not path.is_file():
        where = str(path or variant.family.name)
        raise InputError(
            Problem(
                f"no statement in the language {language.name}",
                file=where,
                remedy="write this file or change the language",
            )
        )
    return path


def _context(case: _Case) -> dict[str, Any]:
    variant, form, asked = case.variant, case.form, case.asked
    context: dict[str, Any] = {name: case.language.symbol(name, form.symbols) for name in variant.family.names}
    context["form"] = form.name
    context["accelerations"] = any(q.order == 2 for q in asked)
    context["relative"] = any("_" in q.kind for q in asked)
    context["shown"] = shown_points(variant, asked)
    context["choice"] = dict(case.words)
    context["speeding"] = any(case.speeds[:1])
    context["speeds"] = list(case.speeds)
    context["zero"] = lambda name: variant.printed[name] == 0
    return context


def _speeds(variant: Variant) -> tuple[bool, ...]:
    """Whether the motion that each driver gives gets faster: its velocity and acceleration have the same sense."""
    values = variant.form.values({name: variant.si(name) for name in variant.form.parameters})
    return tuple(bool(gets_faster) for gets_faster in is_speeding_up(variant.form, values))


def _letters_symbol(name: str, variant: Variant, path: Path) -> Symbol:
    """A name like OABC, put together from names of points."""
    spelled = [letter + number for letter, number in letters(name)]
    if "".join(spelled) != name or any(part not in variant.form.points for part in spelled):
        raise InputError(
            Problem(
                "the template uses an unknown name", file=str(path), value=name, remedy="use points, bodies, parameters"
            )
        )
    return Symbol(name)
