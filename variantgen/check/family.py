"""The check of one family, from its schema to its figures."""

from __future__ import annotations

import time
from pathlib import Path

from variantgen.check.draws import check_form
from variantgen.check.explained import scene_faults
from variantgen.check.report import Report
from variantgen.check.texts import check_languages
from variantgen.families.cases import AGREES, load_cases
from variantgen.families.family import Family
from variantgen.families.load import load_family
from variantgen.mechanism.outcome import Outcome


def check_family(name_or_path: str, seeds: int = 200, folders: tuple[Path, ...] = ()) -> Report:
    """Run all checks on a family; raises InputError if its files cannot be read, anything else is in the report.

    ``seeds`` variants are drawn per form; seed n of the report is ``show FAMILY --form FORM --seed n``.
    """
    start = time.perf_counter()
    family = load_family(name_or_path, folders)
    report = Report(family.name)
    _check_cases(family, report)
    if family.folder is not None or any(form.grid_size > 1 for form in family.forms.values()):
        check_languages(family, report)
        for form in family.forms.values():
            check_form(family, form, seeds, report)
    else:
        report.failures += scene_faults(name_or_path, folders)
    report.seconds = round(time.perf_counter() - start, 3)
    return report


def _check_cases(family: Family, report: Report) -> None:
    for case in load_cases(family):
        if not case.exact:
            report.failures.append(f"case {case.id}: exact results are missing, so it proves nothing")
        outcome = Outcome(int(case.motion().outcome[0]))
        if outcome is not Outcome.SOLVED:
            report.failures.append(f"case {case.id} ({case.source}): {outcome.text}")
            continue
        wrong = {name: d for name, d in case.deviations(family.length_unit).items() if not d <= AGREES}
        report.cases.append(case.id)
        if wrong:
            found = case.computed(family.length_unit)
            for name in wrong:
                report.failures.append(
                    f"case {case.id} ({case.source}): {name} is {found[name]:.9g}, expected {case.exact[name]:.9g}"
                )
