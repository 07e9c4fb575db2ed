"""Many draws of a form: acceptance, variety, agreement of the two computations, invariants, spread of the answers."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence

import numpy as np
from msgspec.structs import replace

from variantgen.check.explained import check_explained, check_told
from variantgen.check.report import FormReport, Report, Spread
from variantgen.check.texts import check_quantities, check_texts
from variantgen.errors import InputError, VariantgenError
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.families.family import Family, Form
from variantgen.families.machine import LIMITS
from variantgen.families.parameters.draw_rules import HandFriendly
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.families.restrict import restrict
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.verification.verify import invariants, recompute
from variantgen.single import SINGLE
from variantgen.variants.batch import MakeScreening, RejectionCounts
from variantgen.variants.counting import variety
from variantgen.variants.draw import FamilySampler, draw
from variantgen.variants.screening import VERIFIED
from variantgen.variants.variant import Variant, solve_variants

# Below this share of accepted draws a large class costs too much time, and ranges are hardly what the author meant.
_LEAST_ACCEPTANCE = 0.02
# An answer that this share of all students has in common is no individual answer.
_COMMONEST = 0.5
_NICE = 24  # hand-friendly variants that are drawn
_TOLD = 3  # variants in which every number that is not printed is changed


def check_form(family: Family, form: Form, seeds: int, report: Report) -> None:
    """Draw variants of a form and look at them from all sides; findings go into the report."""
    asked = [parse_quantity(text, form.sample) for text in form.ask]
    found = FormReport(form.name, len(form.parameters), [len(block.unknowns) for block in form.plan.blocks])
    report.forms.append(found)
    where = f"form {form.name!r}" if form.name else "draws"
    tally = RejectionCounts()
    start = time.perf_counter()
    try:
        variants = _drawn(family, form, seeds, tally, AnswerTolerances())
    except VariantgenError as error:
        report.fail(str(error), where)
        return
    found.seconds_per_1000 = round((time.perf_counter() - start) / seeds * 1000, 3)
    found.variants, found.distinct = seeds, len({variant.identity for variant in variants})
    attempts = sum(variant.attempt for variant in variants)
    found.acceptance = seeds / attempts
    found.own_acceptance = seeds / sum(v.attempt for v in _drawn(family, form, seeds, RejectionCounts(), None))
    found.rejected = dict(tally.rejected.most_common())
    if form.machine:
        found.size = form.machine.size
        found.beyond = sum(tally.rejected[form.machine.rule(name)] for name in LIMITS)
    count = variety(family, form, asked, seeds, attempts)
    found.grid, found.valid, found.valid_exact = count.grid, count.valid, count.exact
    if found.own_acceptance < _LEAST_ACCEPTANCE:
        message = f"only {100 * found.own_acceptance:.1f} % of the draws are valid ({tally.report()})"
        report.fail(f"{message}; narrow the ranges to what assembles", where, "few draws are valid")
    motion = solve_variants(variants, 2)
    _check_agreement(motion, found, where, report)
    found.spread = _spread(asked, motion, family.length_unit)
    for item in found.spread:
        if item.commonest > _COMMONEST and not item.quantity.endswith(".sense"):
            report.fail(f"{item.quantity} is the same for {100 * item.commonest:.0f} % of the variants", where)
    check_texts(variants, motion, report)
    check_quantities(variants[0], report)
    check_told(variants[:_TOLD], asked, report, where)
    check_explained(variants[0], motion, asked, report, where)
    _check_nice(family, form, found, where, report)


def _check_nice(family: Family, form: Form, found: FormReport, where: str, report: Report) -> None:
    """Draw hand-friendly variants; there must be some if the family says how they are drawn."""
    single = replace(family, forms={form.name: form})
    if not single.nice_forms:
        return
    keys = [(str(seed), *SINGLE) for seed in range(_NICE)]
    try:
        narrowed = restrict(single, nice=True)
        variants = draw(narrowed, None, keys, screening=AnswerTolerances())
    except InputError as error:
        if form.nice != HandFriendly():
            report.fail(str(error), f"{where}, hand-friendly variants")
        return
    found.nice_attempts = sum(variant.attempt for variant in variants) / len(variants)
    found.nice = max(1, round(narrowed.forms[form.name].grid_size / found.nice_attempts))


def _drawn(
    family: Family, form: Form, seeds: int, tally: RejectionCounts, screening: MakeScreening | None
) -> list[Variant]:
    single = replace(family, forms={form.name: form})
    keys = [(str(seed), *SINGLE) for seed in range(seeds)]
    return FamilySampler(single, None, tally, screening=screening).after(keys, [0] * seeds)


def _check_agreement(motion: Motion, found: FormReport, where: str, report: Report) -> None:
    again = recompute(motion)
    for name, errors in (
        ("solver and independent computation differ", np.maximum(again.velocity_error, again.acceleration_error)),
        ("a theorem of kinematics is violated", invariants(motion)),
    ):
        worst = float(np.max(errors))
        if name.startswith("solver"):
            found.deviation = worst
        else:
            found.invariant = worst
        if not worst <= VERIFIED:  # also when it is not a number
            report.fail(f"{name} by {worst:.1e}", f"{where}, seed {int(np.argmax(errors))}", name)


def _spread(asked: Sequence[Quantity], motion: Motion, length_unit: str) -> list[Spread]:
    found = []
    for quantity in asked:
        unit = quantity.unit(length_unit)
        values = np.array([unit.from_si(float(value)) for value in quantity.value(motion)])
        low, middle, high = (float(value) for value in np.quantile(values, (0.1, 0.5, 0.9)))
        commonest = Counter(f"{value:.3g}" for value in values).most_common(1)[0][1] / len(values)
        positive = float(np.mean(values > 0))
        found.append(Spread(quantity.name, unit.name, low, middle, high, commonest, positive))
    return found
