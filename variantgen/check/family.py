"""The check of one family, from its schema to its figures."""

from __future__ import annotations

import time
from pathlib import Path

from variantgen.check.draws import check_form
from variantgen.check.explained import check_single_scene
from variantgen.check.report import Report
from variantgen.check.texts import check_languages
from variantgen.families.family import Family
from variantgen.families.reading.cases import AGREES, load_cases
from variantgen.families.reading.load import load_family
from variantgen.mechanism.outcome import Outcome

_NO_CASES = (
    "no worked cases: nothing from outside confirms the answers of this family;"
    " write a result known from a book or from your own calculation to cases.toml"
)


def check_family(name_or_path: str, seeds: int = 200, folders: tuple[Path, ...] = ()) -> Report:
    """Run all checks on a family; raises InputError if its files cannot be read, anything else is in the report.

    ``seeds`` variants are drawn per form; seed n of the report is ``show FAMILY --form FORM --seed n``.
    """
    start = time.perf_counter()
    family = load_family(name_or_path, folders)
    report = Report(family.name)
    _check_cases(family, report)
    if not family.is_scene or any(form.grid_size > 1 for form in family.forms.values()):
        check_languages(family, report)
        for form in family.forms.values():
            check_form(family, form, seeds, report)
    else:
        check_single_scene(name_or_path, folders, report)
    report.seconds = round(time.perf_counter() - start, 3)
    return report


def _check_cases(family: Family, report: Report) -> None:
    cases = load_cases(family)
    if not cases and not family.is_scene:
        report.remark(_NO_CASES)
    for case in cases:
        if not case.exact:
            report.fail("exact results are missing, so it proves nothing", f"case {case.id}")
        outcome = Outcome(int(case.motion().outcome[0]))
        if outcome is not Outcome.SOLVED:
            report.fail(outcome.text, f"case {case.id} ({case.source})")
            continue
        wrong = {name: d for name, d in case.deviations(family.length_unit).items() if not d <= AGREES}
        report.cases.append(case.id)
        if wrong:
            found = case.computed(family.length_unit)
            for name in wrong:
                message = f"{name} is {found[name]:.9g}, expected {case.exact[name]:.9g}"
                report.fail(message, f"case {case.id} ({case.source})")
