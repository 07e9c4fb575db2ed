"""Marking: planted mistakes named, follow-through granted, answers that are right and never accused.

    python -m benchmarks.marking [--variants N] [--family NAME ...]

For every form variants are drawn. Each answer is got wrong by each cause, as a student would write it, with four
significant digits, where that is another number than by another cause; and each answer is gone on with after a slip of
30 % in an earlier one, with the steps of the solution. Prints a Markdown table and, run on the whole catalogue, writes
it to ``benchmarks/marking.md``. Nothing here is a time.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from variantgen.exam.sheets import Answer, answer_variants
from variantgen.exam.tolerance import Tolerance
from variantgen.families.asking import read_ask
from variantgen.families.load import family_names, load_family
from variantgen.families.restrict import restrict
from variantgen.marking.causes import Comparisons, cause_of
from variantgen.marking.follow_through import FollowThrough
from variantgen.marking.key import is_right
from variantgen.marking.plausible_mistakes import OfProblem, of_batch
from variantgen.methods.hand.following import FollowingSteps
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant

HERE = Path(__file__).resolve()
_SLIP = 1.3
_ALIKE = 1e-3  # relative difference of results that four digits do not tell apart
_CHANGED = 0.05  # what follows differs at least so much from what is right


def written(value: float) -> float:
    """A number as a student writes it."""
    return float(f"{value:.4g}")


def planted(answer: Answer, name: str, results: OfProblem) -> Iterator[tuple[str, float]]:
    """Wrong answers by their causes, those of mistakes with the name of the mistake."""
    yield "sign", -answer.value
    if not answer.quantity.is_angle:
        yield "power_of_ten", 10.0 * answer.value
    mistakes, parts = results
    for mistake, value in mistakes[name].items():
        yield f"mistake: {mistake}", value
    for part, value in parts[name].items():
        yield f"component: {part}", value


def named(variants: Sequence[Variant], answers: Sequence[Sequence[Answer]], counts: Counter[str]) -> None:
    """Count how many planted mistakes are named: exactly, and by a cause that gives the same number."""
    asked = [answer.quantity for answer in answers[0]]
    for own, results in zip(answers, of_batch(variants, asked), strict=True):
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
            for cause, value in planted(answer, name, results):
                if not np.isfinite(value) or is_right(answer, written(value)):
                    continue
                if any(abs(value - other) <= _ALIKE * abs(value) for other in seen):
                    continue  # nobody can tell it from another mistake
                seen.append(value)
                found = cause_of(written(value), answer, around)
                text = f"{found.name}: {found.detail}" if found.detail else found.name
                kind = cause.partition(":")[0]
                counts[kind] += 1
                counts[f"{kind}, named"] += found.name == kind
                counts[f"{kind}, exactly"] += text == cause
            counts["right"] += 1
            counts["right, accused"] += not is_right(answer, written(answer.value))


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


def table(families: Sequence[str], count: int) -> list[str]:
    """The rows of the table: a form in each, the sums in the last."""
    causes = ("sign", "power_of_ten", "component", "mistake")
    rows = [
        "| form | "
        + " | ".join(f"{cause} named, %" for cause in causes)
        + " | mistake exactly, % | accused | granted |",
        "|---" * (len(causes) + 4) + "|",
    ]
    total: Counter[str] = Counter()
    for name in families:
        family = load_family(name)
        for form in family.forms:
            own = restrict(family, None, None, (form,) if form else ())
            variants = draw(own, None, [("marking", i) for i in range(count)])
            asked = read_ask(variants[0].form)
            answers = answer_variants(variants, [None] * count, [Tolerance()] * count)
            counts: Counter[str] = Counter()
            named(variants, answers, counts)
            followed(variants[: max(1, count // 10)], answers[: max(1, count // 10)], counts)
            total.update(counts)
            rows.append(row(f"{name} {form}".strip(), counts, causes))
            assert len(asked) == len(answers[0])
    return [*rows, row("all", total, causes)]


def row(name: str, counts: Counter[str], causes: Sequence[str]) -> str:
    """One row."""
    shares = [share(counts[f"{cause}, named"], counts[cause]) for cause in causes]
    shares.append(share(counts["mistake, exactly"], counts["mistake"]))
    return (
        f"| {name} | "
        + " | ".join(
            [
                *shares,
                f"{counts['right, accused']} of {counts['right']}",
                f"{counts['follow, granted']} of {counts['follow']}",
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
    parser.add_argument("--variants", type=int, default=200)
    parser.add_argument("--family", nargs="*", default=[])
    arguments = parser.parse_args()
    text = "\n".join(
        [
            "# Marking",
            "",
            f"`python -m benchmarks.marking`: {arguments.variants} variants of each form; each answer got wrong by each"
            " cause, and gone on with after a slip in an earlier one (a tenth of the variants).",
            "",
            *table(arguments.family or family_names(), arguments.variants),
        ]
    )
    print(text)
    if not arguments.family:
        (HERE.parent / "marking.md").write_text(text + "\n", "utf-8")


if __name__ == "__main__":
    main()
