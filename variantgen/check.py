"""The self-check of a family: worked cases, languages, many seeds, agreement of the two computations."""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np

from variantgen.errors import VariantgenError
from variantgen.families.cases import AGREES, load_cases
from variantgen.families.family import Family
from variantgen.families.load import load_family
from variantgen.families.quantities import parse_quantity
from variantgen.figure.build import statement_figure
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.verify import invariants, recompute
from variantgen.single import one_variant
from variantgen.variants.draw import Drawing, Tally
from variantgen.variants.needed import given_names
from variantgen.variants.screening import VERIFIED
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Formula, Symbol, letters
from variantgen.wording.language import languages, load_language
from variantgen.wording.statement import statement

_FIGURES = 20  # variants per form whose figure is drawn and compared with the statement


@dataclass
class Report:
    """What the check of one family found; ``failures`` is empty when all is well."""

    family: str
    failures: list[str] = field(default_factory=list)
    cases: list[str] = field(default_factory=list)
    variants: int = 0
    distinct: int = 0
    acceptance: float = 0.0
    rejected: dict[str, int] = field(default_factory=dict)
    worst_deviation: float = 0.0
    worst_invariant: float = 0.0
    seconds: float = 0.0

    def as_json(self) -> dict[str, Any]:
        """The report as plain data."""
        return dict(vars(self))

    def as_text(self) -> str:
        """The report in a few lines."""
        head = f"{self.family}: {'FAILED' if self.failures else 'ok'}  ({self.seconds:.2f} s)"
        lines = [head]
        if self.cases:
            lines.append(f"    worked cases: {', '.join(self.cases)}")
        if self.variants:
            lines.append(
                f"    {self.variants} variants, {self.distinct} distinct, acceptance {100 * self.acceptance:.1f} %,"
                f" independent computation within {self.worst_deviation:.1e},"
                f" invariants within {self.worst_invariant:.1e}"
            )
            worst = ", ".join(f"{name} {count}" for name, count in list(self.rejected.items())[:4] if count)
            lines.append(f"    rejected most: {worst or 'nothing'}")
        lines += [f"    ! {failure}" for failure in self.failures]
        return "\n".join(lines)


def check_family(name_or_path: str, seeds: int = 200, folders: tuple[Path, ...] = ()) -> Report:
    """Run all checks on a family; raises InputError if its files cannot be read, anything else is in the report."""
    start = time.perf_counter()
    family = load_family(name_or_path, folders)
    report = Report(family.name)
    _check_cases(family, report)
    if any(form.parameters for form in family.forms.values()):
        for form_name in family.forms:
            _check_draws(family, form_name, seeds, report)
    else:
        outcome = Outcome(int(solve_variants([one_variant(name_or_path, folders=folders)], 1).outcome[0]))
        if outcome is not Outcome.SOLVED:
            report.failures.append(outcome.text)
    report.seconds = round(time.perf_counter() - start, 3)
    return report


def _check_cases(family: Family, report: Report) -> None:
    for case in load_cases(family):
        wrong = {name: d for name, d in case.deviations(family.length_unit).items() if not d <= AGREES}
        report.cases.append(case.id)
        if wrong:
            found = case.computed(family.length_unit)
            for name in wrong:
                report.failures.append(
                    f"case {case.id} ({case.source}): {name} is {found[name]:.9g}, expected {case.exact[name]:.9g}"
                )


def _check_draws(family: Family, form_name: str, seeds: int, report: Report) -> None:
    tally = Tally()
    single = replace(family, forms={form_name: family.forms[form_name]})
    try:
        variants = Drawing(single, None, tally).after([("check", i) for i in range(seeds)], [0] * seeds)
    except VariantgenError as error:
        report.failures.append(f"form {form_name!r}: {error}")
        return
    motion = solve_variants(variants, 2)
    again = recompute(motion)
    deviation = float(np.max([again.velocity_error, again.acceleration_error]))
    report.worst_deviation = max(report.worst_deviation, deviation)
    report.worst_invariant = max(report.worst_invariant, float(invariants(motion).max()))
    if not deviation <= VERIFIED:  # also when it is not a number
        seed = int(again.acceleration_error.argmax())
        report.failures.append(
            f"form {form_name!r}, seed {seed}: solver and independent computation differ by {deviation:.1e}"
        )
    attempts = sum(variant.attempt for variant in variants)
    before = report.variants
    report.variants += seeds
    report.distinct += len({variant.identity for variant in variants})
    report.acceptance = (report.acceptance * before + seeds * seeds / attempts) / report.variants
    for name, count in tally.rejected.most_common():
        report.rejected[name] = report.rejected.get(name, 0) + count
    for language_name in languages():
        for i, variant in enumerate([_at_constant_speed(variants[0]), *variants[:_FIGURES]]):
            found = _text_failures(variant, language_name, motion, max(0, i - 1))
            report.failures += found
            if found:
                break


def _at_constant_speed(variant: Variant) -> Variant:
    """The variant with all given accelerations zero: its text must not speak of them."""
    second = {name for name, parameter in variant.form.parameters.items() if parameter.of_second_order}
    return replace(variant, printed={n: Decimal(0) if n in second else v for n, v in variant.printed.items()})


def _text_failures(variant: Variant, language_name: str, motion: Any, place: int) -> list[str]:
    """The statement in a language names every given and asked quantity, and so does the figure."""
    language = load_language(language_name)
    asked = [parse_quantity(text, variant.form.sample) for text in variant.form.ask]
    where = f"statement.{language_name}.j2, form {variant.form.name!r}, seed {place}"
    try:
        said = statement(variant, asked, language)
    except VariantgenError as error:
        return [f"{where}: {error}"]
    drawn = {label.formula for label in statement_figure(variant, motion, place, asked, language).labels}
    missing = []
    for name in given_names(variant, asked):
        parameter = variant.form.parameters[name]
        symbol = language.symbol(parameter.symbol, variant.form.symbols)
        if parameter.constant or (parameter.unit and parameter.unit.measures == "time"):
            continue
        if not _is_named(symbol, drawn):
            missing.append(f"{where}: the figure does not show {name}")
    for point in sorted({q.point for q in asked} - {""}):
        if Symbol(point) not in drawn:
            missing.append(f"{where}: the figure does not name {point}")
    return missing + ([] if said.text else [f"{where}: the statement is empty"])


def _is_named(symbol: Symbol, drawn: set[Formula]) -> bool:
    """A symbol is in the figure as a label, or as two labelled points (the length OA of a link)."""
    ends = [Symbol(letter + number) for letter, number in letters(symbol.base)] if not symbol.index else []
    return symbol in drawn or (len(ends) == 2 and all(end in drawn for end in ends))
