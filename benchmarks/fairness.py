"""How equal the variants of each form are in work, left to chance and fair, and what that costs.

    python -m benchmarks.fairness [--variants 60] [--forms N]

Prints a Markdown document and writes it to ``benchmarks/fairness.md``.
"""

from __future__ import annotations

import argparse
import gc
import statistics
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from benchmarks.measure import machine_line, write_beside
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.work.fairness import Band, FairDraws
from variantgen.exam.work.wanted_work import WIDTH
from variantgen.families.family import Family
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.methods.compose import solution
from variantgen.methods.hand.work import Work, work_of
from variantgen.methods.linkage.problem import task_of
from variantgen.variants.draw import FamilySampler
from variantgen.variants.variant import Variant, solve_variants


@dataclass(frozen=True)
class Spread:
    """Variants of a form with the work of their written solutions, and the CPU milliseconds of drawing one."""

    works: Sequence[Work]
    milliseconds: float

    @property
    def ratio(self) -> float:
        """The most operations of a variant over the fewest."""
        return max(self.operations) / max(1, min(self.operations))

    @property
    def operations(self) -> list[int]:
        """By variant."""
        return [work.operations for work in self.works]

    @property
    def calculations(self) -> list[int]:
        """By variant."""
        return [work.calculations for work in self.works]

    @property
    def negatives(self) -> int:
        """By how many negative numbers variants differ."""
        return _range(work.negatives for work in self.works)

    @property
    def obtuse(self) -> int:
        """By how many obtuse angles variants differ."""
        return _range(work.obtuse for work in self.works)


def _range(numbers: Iterator[int]) -> int:
    found = list(numbers)
    return max(found) - min(found)


@dataclass(frozen=True)
class Row:
    """One form before and after."""

    title: str
    before: Spread
    after: Spread
    band: Band

    def line(self) -> str:
        """Its line of the table."""
        old, new = self.before, self.after
        cells = (
            self.title,
            f"{min(old.operations)}-{max(old.operations)}",
            f"{old.ratio:.2f}",
            old.negatives,
            old.obtuse,
            f"{min(new.operations)}-{max(new.operations)}",
            f"{new.ratio:.2f}",
            f"{max(new.calculations) / min(new.calculations):.2f}",
            new.negatives,
            new.obtuse,
            f"{100 * self.band.share:.0f} %",
            f"{self.band.room:.2g}" if self.band.room >= 10_000 else self.band.room,
            f"{old.milliseconds:.1f}",
            f"{new.milliseconds:.1f}",
        )
        return f"| {' | '.join(map(str, cells))} |"


HEAD = """\
| form | operations | max/min | negatives | obtuse | fair: operations | max/min | of calculations | negatives | obtuse \
| draws inside | variants left | ms a draw | fair |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"""


def spread(family: Family, sampler: FamilySampler, count: int) -> Spread:
    """The spread of so many variants, by their written solutions for everything that is asked."""
    for form in family.forms.values():
        form.remembered.clear()  # everything that a build finds out of a form is in its time
    start = time.process_time()
    variants = sampler.after([("fairness", i) for i in range(count)], [0] * count)
    spent = 1e3 * (time.process_time() - start) / count
    return Spread([*_written(sampler, variants)], spent)


def _written(sampler: FamilySampler, variants: Sequence[Variant]) -> Iterator[Work]:
    asked = next(iter(sampler.asked.values()))
    motion = solve_variants(variants, 2)
    for i, variant in enumerate(variants):
        yield work_of(value for _, value in solution(task_of(variant, motion, i, asked)).answers)


def rows(count: int, most: int | None) -> Iterator[Row]:
    """All forms of the catalogue."""
    every = [(name, form) for name in family_names() for form in restrict(load_family(name)).forms]
    for name, form_name in every[:most]:
        family = restrict(load_family(name), forms=(form_name,) if form_name else ())
        form = next(iter(family.forms.values()))
        fair = FairDraws(WIDTH, AnswerTolerances())
        after = FamilySampler(family, None, screening=fair)
        band = fair.band(family, form, after.examined[form.name])
        before = FamilySampler(family, None, screening=AnswerTolerances())
        yield Row(f"{name} {form_name}".strip(), spread(family, before, count), spread(family, after, count), band)


def _exams(spreads: Sequence[Spread]) -> Iterator[list[Spread]]:
    """Exams of five forms each."""
    for first in range(len(spreads)):
        yield [spreads[(first + 15 * k) % len(spreads)] for k in range(5)]


def sheet_ratio(spreads: Sequence[Spread], count: int) -> tuple[float, float]:
    """Of exams of five forms each, student by student: median and largest max/min of the operations of a sheet."""
    found = []
    for chosen in _exams(spreads):
        sums = [sum(own.operations[i] for own in chosen) for i in range(count)]
        found.append(max(sums) / min(sums))
    return statistics.median(found), max(found)


def sheet_negatives(spreads: Sequence[Spread], count: int) -> tuple[float, float]:
    """Of the same exams: by how many negative numbers sheets differ, median and most."""
    found = []
    for chosen in _exams(spreads):
        sums = [sum(own.works[i].negatives for own in chosen) for i in range(count)]
        found.append(max(sums) - min(sums))
    return statistics.median(found), max(found)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--variants", type=int, default=60)
    parser.add_argument("--forms", type=int, help="only so many forms, without writing the file")
    chosen = parser.parse_args()
    gc.disable()  # as in the jobs of a build
    found = list(rows(chosen.variants, chosen.forms))
    before, after = [row.before for row in found], [row.after for row in found]
    lines = [
        "# How equally hard the variants of a form are",
        "",
        f"`python -m benchmarks.fairness --variants {chosen.variants}` ({machine_line()}): every form of the",
        "catalogue, everything asked, left to chance and with `fair = true`. Operations, negative numbers and obtuse",
        "angles are counted in the written solutions, calculations are operations and functions (docs/fairness.md).",
        "Columns of negatives and obtuse angles: by how much the most of a variant differ from the fewest.",
        "The time of a draw includes all that is found out of a form once for its variants.",
        "",
        "| of all forms | left to chance | fair |",
        "|---|---|---|",
    ]
    for title, number in (
        ("operations max/min, median", lambda s: statistics.median(x.ratio for x in s)),
        ("operations max/min, worst", lambda s: max(x.ratio for x in s)),
        ("forms with operations max/min above 1.15", lambda s: sum(x.ratio > 1.15 for x in s)),
        ("forms with operations max/min above 1.05", lambda s: sum(x.ratio > 1.05 for x in s)),
        ("negative numbers differ by, median", lambda s: statistics.median(x.negatives for x in s)),
        ("negative numbers differ by, most", lambda s: max(x.negatives for x in s)),
        ("obtuse angles differ by, most", lambda s: max(x.obtuse for x in s)),
        ("CPU ms a draw, mean of forms", lambda s: statistics.mean(x.milliseconds for x in s)),
        ("sheets of five forms, operations max/min, median", lambda s: sheet_ratio(s, chosen.variants)[0]),
        ("sheets of five forms, operations max/min, worst", lambda s: sheet_ratio(s, chosen.variants)[1]),
        ("sheets of five forms, negative numbers differ by, median", lambda s: sheet_negatives(s, chosen.variants)[0]),
        ("sheets of five forms, negative numbers differ by, most", lambda s: sheet_negatives(s, chosen.variants)[1]),
    ):
        lines.append(f"| {title} | {number(before):.3g} | {number(after):.3g} |")
    lines += ["", HEAD, *(row.line() for row in found)]
    print("\n".join(lines))
    if chosen.forms is None:
        write_beside(__file__, lines)


if __name__ == "__main__":
    main()
