"""Marking: planted mistakes named, follow-through granted, answers that are right and never accused.

    python -m benchmarks.marking [--students N] [--family NAME ...]

For every family problems of 200 students are drawn, in equal parts of its forms. Each answer is got wrong by each
cause, as a student would write it, with four significant digits, where that is another number than by another cause;
the whole sheet of the next student is solved in place of the own (not counted where a third one has the same numbers);
mistakes are worked out anew by equations of the benchmark's own (:mod:`benchmarks.dropped_terms`, a fifth of the
students); each answer is gone on with after a slip of 30 % in
an earlier one, with the steps of the solution (``granted``); and random numbers from a tenth to ten times the right
ones are marked (``by chance``). Prints a Markdown table and, run on the whole catalogue, writes it to
``benchmarks/marking.md``. Nothing here is a time.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Sequence
from itertools import islice
from pathlib import Path

import numpy as np

from benchmarks.copied_sheets import altered, neighboured
from benchmarks.dropped_terms import planted_anew
from benchmarks.planted_answers import planted, spelled, width_of, written
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.exam.sheets import Answer, answer_variants
from variantgen.families.asking import read_ask
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.marking.diagnosis.causes import Comparisons, cause_of
from variantgen.marking.diagnosis.follow_through import FollowThrough
from variantgen.marking.diagnosis.plausible_mistakes import of_batch
from variantgen.marking.key import is_right
from variantgen.marking.marks import Verdict, verdict_of
from variantgen.methods.hand.following import FollowingSteps
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant

HERE = Path(__file__).resolve()
_LAST = ("rounding", "other_answer")  # where both signs of a result are other causes
_SLIP = 1.3
_ALIKE = 1e-3  # relative difference of results that four digits do not tell apart
_IN_ALL_WAYS = 10  # of so many students the answers of one are written in all ways
_LEAST = 95.0  # per cent that are to be named
_CHANGED = 0.05  # what follows differs at least so much from what is right


def named(variants: Sequence[Variant], answers: Sequence[Sequence[Answer]], counts: Counter[str]) -> None:
    """Count how many planted mistakes are named: exactly, and by a cause that gives the same number."""
    asked = [answer.quantity for answer in answers[0]]
    for student, (own, results) in enumerate(zip(answers, of_batch(variants, asked), strict=True)):
        siblings = {f"1.{answer.quantity.name}": answer for answer in own}
        for answer in own:
            name = answer.quantity.name
            around = Comparisons(
                {key: other for key, other in siblings.items() if other is not answer},
                results[1][name],
                results[0][name],
            )
            if not answer.value or answer.quantity.component == "sense":
                continue
            seen: list[float] = []
            for cause, value in planted(answer, name, results, own):
                if not np.isfinite(value) or is_right(answer, written(value)):
                    continue
                near = 1.1 * width_of(answer) if cause == "rounding" else _ALIKE * abs(value)
                if any(min(abs(value - other), abs(value + other)) <= near for other in seen if cause in _LAST):
                    continue
                if any(abs(value - other) <= near for other in seen):
                    continue  # nobody can tell it from another mistake
                seen.append(value)
                found = cause_of(written(value), answer, around)
                text = f"{found.name}: {found.detail}" if found.detail else found.name
                kind = cause.partition(":")[0]
                counts[kind] += 1
                counts[f"{kind}, named"] += found.name == kind
                counts[f"{kind}, exactly"] += text == cause
            for text in islice(spelled(answer), None if student % _IN_ALL_WAYS == 0 else 1):
                counts["right"] += 1
                counts["right, accused"] += verdict_of(answer, text)[2] is not Verdict.RIGHT


def planted_by_equations(
    variants: Sequence[Variant], answers: Sequence[Sequence[Answer]], counts: Counter[str]
) -> None:
    """Count how many mistakes are named whose results the benchmark has worked out by equations of its own."""
    asked = [answer.quantity for answer in answers[0]]
    for variant, own, (mistakes, parts) in zip(variants, answers, of_batch(variants, asked), strict=True):
        siblings = {f"1.{answer.quantity.name}": answer for answer in own}
        for _, place, value in planted_anew(variant, own):
            answer, name = own[place], own[place].quantity.name
            if not np.isfinite(value) or not answer.value or answer.quantity.component == "sense":
                continue
            if abs(value - answer.value) <= 1.1 * width_of(answer) or is_right(answer, written(value)):
                continue
            others = {key: other for key, other in siblings.items() if other is not answer}
            found = cause_of(written(value), answer, Comparisons(others, parts[name], mistakes[name]))
            counts["anew"] += 1
            counts["anew, named"] += found.name == "mistake"


def by_chance(variants: Sequence[Variant], answers: Sequence[Sequence[Answer]], counts: Counter[str]) -> None:
    """Count how many random numbers are taken for what follows from other random numbers before them."""
    rules = FollowThrough([answer.quantity for answer in answers[0]])
    random = np.random.Generator(np.random.Philox(1))
    for variant, own in zip(variants, answers, strict=True):
        values = {
            place: value
            for place, answer in enumerate(own)
            for value in [written(answer.value * 10.0 ** random.uniform(-1.0, 1.0))]
            if answer.quantity.component != "sense" and not is_right(answer, value)
        }
        counts["chance"] += max(len(values) - 1, 0)
        counts["chance, granted"] += len(rules.granted(variant, own, values))


def followed(variants: Sequence[Variant], answers: Sequence[Sequence[Answer]], counts: Counter[str]) -> None:
    """Count how many answers that follow from a slip in an earlier one are granted."""
    asked = [answer.quantity for answer in answers[0]]
    rules, steps = FollowThrough(asked), FollowingSteps(asked)
    for variant, own in zip(variants, answers, strict=True):
        right = [answer.value for answer in own]
        for slip, answer in enumerate(own):
            if not right[slip] or answer.quantity.is_angle or answer.quantity.component == "sense":
                continue
            wrong = _SLIP * right[slip]
            for later, value in enumerate(steps.answers(variant, right, {slip: wrong})):
                if later > slip and np.isfinite(value) and abs(value - right[later]) > _CHANGED * abs(right[later]):
                    counts["follow"] += 1
                    counts["follow, granted"] += later in rules.granted(
                        variant, own, {slip: wrong, later: written(value)}
                    )


def table(families: Sequence[str], students: int) -> list[str]:
    """The rows of the table: a form in each, the sums in the last; and what it does not show."""
    causes = ("sign", "power_of_ten", "unit", "rounding", "component", "other_answer", "neighbour", "mistake")
    rows = [
        "| form | "
        + " | ".join(f"{cause} named, %" for cause in causes)
        + " | mistake exactly, % | by equations named, % | accused | granted | by chance |",
        "|---" * (len(causes) + 6) + "|",
    ]
    total: Counter[str] = Counter()
    few: list[str] = []
    alone: list[str] = []
    for name in families:
        family = load_family(name)
        for form in family.forms:
            own = restrict(family, None, None, (form,) if form else ())
            count = -(-students // len(family.forms))
            variants = draw(own, None, [("marking", i) for i in range(count)])
            asked = read_ask(variants[0].form)
            answers = answer_variants(variants, [None] * count, [Tolerance()] * count)
            counts: Counter[str] = Counter()
            named(variants, answers, counts)
            neighboured(answers, counts)
            altered(answers, counts)
            by_chance(variants[: max(1, count // 4)], answers[: max(1, count // 4)], counts)
            followed(variants[: max(1, count // 5)], answers[: max(1, count // 5)], counts)
            planted_by_equations(variants[: max(1, count // 5)], answers[: max(1, count // 5)], counts)
            total.update(counts)
            few += [
                f"{cause} of {f'{name} {form}'.strip()} ({100 * counts[f'{cause}, named'] / counts[cause]:.1f} %)"
                for cause in causes
                if counts[cause] and 100 * counts[f"{cause}, named"] < _LEAST * counts[cause]
            ]
            alone += [] if counts["follow"] else [f"{name} {form}".strip()]
            rows.append(row(f"{name} {form}".strip(), counts, causes))
            assert len(asked) == len(answers[0])
    return [*rows, row("all", total, causes), "", *unshown(few, alone, total)]


def unshown(few: Sequence[str], alone: Sequence[str], total: Counter[str]) -> list[str]:
    """What the table does not show, as a list."""
    return [
        "What this does not show:",
        "",
        "- Mistakes of the column *mistake* are planted from the same table that is searched for the cause: they are"
        " told apart and not hidden by rounding. Those of the column *by equations* are worked out by the benchmark"
        " (`benchmarks/dropped_terms.py`), which has no part of that table: terms of accelerations dropped or turned in"
        " mechanisms of pivots, guides and slots, angles in degrees for radians, the other branch. Neither says"
        " anything of mistakes that nobody has thought of.",
        "- Chains are planted by the steps of the solution that follow-through goes again; only its second way is"
        " independent of them.",
        "- Copied sheets that are not counted, as their numbers are within tolerance those of a third student too:"
        f" {total['neighbour alike']}.",
        "- Copied sheets of four or more wrong numbers, one of them altered, whose neighbour is named:"
        f" {total['altered, named']} of {total['altered']}; problems of random numbers alone that are taken for a"
        f" neighbour's: {total['innocent, suspected']} of {total['innocent']}.",
        f"- Under {_LEAST:g} % named: {', '.join(few) or 'nothing'}.",
        f"- No answer follows from another, so that follow-through is not tried: {', '.join(alone) or 'none'}.",
        "- Accused are right answers; for a tenth of the students they and both ends of their tolerances are written in"
        " many spellings and units, by rules of the benchmark's own.",
    ]


def row(name: str, counts: Counter[str], causes: Sequence[str]) -> str:
    """One row."""
    shares = [share(counts[f"{cause}, named"], counts[cause]) for cause in causes]
    shares.append(share(counts["mistake, exactly"], counts["mistake"]))
    shares.append(share(counts["anew, named"], counts["anew"]))
    return (
        f"| {name} | "
        + " | ".join(
            [
                *shares,
                f"{counts['right, accused']} of {counts['right']}",
                f"{counts['follow, granted']} of {counts['follow']}",
                f"{counts['chance, granted']} of {counts['chance']}",
            ]
        )
        + " |"
    )


def share(part: int, whole: int) -> str:
    """Per cent, with what it is of."""
    return f"{100 * part / whole:.1f} of {whole}" if whole else "-"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--students", type=int, default=200, help="of each family")
    parser.add_argument("--family", nargs="*", default=[])
    arguments = parser.parse_args()
    text = "\n".join(
        [
            "# Marking",
            "",
            f"`python -m benchmarks.marking`: {arguments.students} students of each family; each answer got wrong by"
            " each cause that gives another number than those before it, gone on with after a slip in an earlier one"
            " (a fifth of them); random numbers in place of all answers (a quarter of them).",
            "",
            *table(arguments.family or family_names(), arguments.students),
        ]
    )
    print(text)
    if not arguments.family:
        (HERE.parent / "marking.md").write_text(text + "\n", "utf-8")


if __name__ == "__main__":
    main()
