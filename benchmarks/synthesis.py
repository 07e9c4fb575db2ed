"""What composed families are like: how many structures give one, at what cost, and what 20 variants of each are.

    python -m benchmarks.synthesis [--links N] [--every K] [--ends] [--seeds N] [--seed SEED] [--out FILE]

Every structure with up to so many moving links (of those with seven every K-th; ``--ends``: those that end with a
wheel, a gear or a rack) is composed; variants are drawn, solved, recomputed by the independent way, their statement
figures drawn in both languages. CPU seconds are those of this process, where nothing is accepted those of all tries.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import Counter, defaultdict
from contextlib import suppress
from pathlib import Path
from statistics import mean, median

import numpy as np

from variantgen.errors import InputError, VariantgenError
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.composed import write
from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.families.method_names import METHODS
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.figure.inspection.faults import figure_faults
from variantgen.mechanism.verification.verify import recompute
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.resources import languages
from variantgen.synthesis.recognition import structures_of
from variantgen.synthesis.structures import Structure, code, moving_links, textbook_structures
from variantgen.synthesis.terminal import geared_structures, rolling_structures
from variantgen.variants.draw import draw
from variantgen.variants.screening import VERIFIED
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import to_plain
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement

_LINE = 64  # characters of a line beside a figure


def lines(variant: Variant, language: str) -> int:
    """The lines of a statement."""
    asked = read_ask(variant.form)
    text = statement(variant, asked, load_language(language)).text
    return -(-len("".join(part if isinstance(part, str) else to_plain(part) for part in text)) // _LINE)


def examine(family: Family, seeds: int) -> dict[str, float]:
    """Faults and properties of some variants of a family."""
    keys = [(str(seed), "benchmark", 0) for seed in range(seeds)]
    variants = draw(family, None, keys, screening=AnswerTolerances())
    asked = read_ask(variants[0].form)
    motion = solve_variants(variants, 2)
    again = recompute(motion)
    found: dict[str, float] = {
        "verified": float(np.sum(np.maximum(again.velocity_error, again.acceleration_error) <= VERIFIED)),
        "faults": 0,
        "lines": max(lines(variants[0], language) for language in languages()),
        "methods": 0,
    }
    for name in languages():
        for place, variant in enumerate(variants):
            drawing = statement_figure(variant, motion, place, asked, load_language(name))
            found["faults"] += len(figure_faults(drawing))
    task = task_of(variants[0], motion, 0, asked)
    for method in METHODS:
        with suppress(VariantgenError, *NOT_APPLICABLE):
            solution(task, [method])
            found["methods"] += 1
    return found


def catalogue_lines() -> dict[int, list[int]]:
    """Lines of the catalogue's statements by the number of moving links, of mechanisms that have a structure."""
    found: dict[int, list[int]] = defaultdict(list)
    for name in family_names():
        family = load_family(name)
        for form in family.forms.values():
            known = structures_of(form.sample)
            if known:
                variant = Variant(family, form, {n: p.printed[len(p.printed) // 2] for n, p in form.parameters.items()})
                found[moving_links(min(known))].append(max(lines(variant, language) for language in languages()))
    return found


def main() -> None:
    """Measure and write the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--links", type=int, default=7)
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--ends", action="store_true")
    parser.add_argument("--seeds", type=int, default=20, help="0: only compose")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--out", type=Path)
    options = parser.parse_args()
    chosen: dict[int, list[Structure]] = defaultdict(list)
    structures = textbook_structures(options.links)
    if options.ends:
        structures = [*rolling_structures(options.links), *geared_structures(options.links)]
    seven = [s for s in structures if moving_links(s) == 7][:: options.every]
    rows: dict[int, list[dict[str, float]]] = defaultdict(list)
    refused: dict[int, list[str]] = defaultdict(list)
    with tempfile.TemporaryDirectory() as scratch:
        for structure in [s for s in structures if moving_links(s) < 7] + seven:
            size, folder = moving_links(structure), Path(scratch) / code(structure)
            chosen[size].append(structure)
            start = time.process_time()
            try:
                write(structure, options.seed, folder)
            except InputError:
                refused[size].append(f"{code(structure)} ({time.process_time() - start:.1f} s)")
                continue
            row: dict[str, float] = {"cpu": time.process_time() - start}
            if options.seeds:
                row |= examine(load_family(folder), options.seeds)
                if row["faults"] or row["methods"] < 3 or row["verified"] < options.seeds:
                    print(code(structure), row, flush=True)
            rows[size].append(row)
    text = table(chosen, rows, refused, options.seeds)
    print(text)
    if options.out:
        options.out.write_text(text, "utf-8")


def table(
    chosen: dict[int, list[Structure]],
    rows: dict[int, list[dict[str, float]]],
    refused: dict[int, list[str]],
    seeds: int,
) -> str:
    """The table in Markdown."""
    catalogue = catalogue_lines()
    out = [
        "| moving links | structures | accepted | CPU s each: mean, 90 %, most | verified | figure faults"
        " | methods, least (median) | lines, median (most) | lines in the catalogue, median (most) |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for size, own in sorted(rows.items()):
        cpu = [row["cpu"] for row in own]
        spread = f"{mean(cpu):.2f}, {float(np.quantile(cpu, 0.9)):.2f}, {max(cpu):.2f}"
        cells = [f"{size}", f"{len(chosen[size])}", f"{len(own)}", spread]
        if seeds:
            methods, length = [row["methods"] for row in own], [row["lines"] for row in own]
            cells += [
                f"{sum(row['verified'] for row in own):g} of {seeds * len(own)}",
                f"{sum(row['faults'] for row in own):g} in {len(languages()) * seeds * len(own)}",
                f"{min(methods):g} ({median(methods):g})",
                f"{median(length):g} ({max(length):g})",
                f"{median(catalogue[size]):g} ({max(catalogue[size])})" if catalogue[size] else "none",
            ]
        out.append("| " + " | ".join(cells) + " |")
    missing = Counter(name for names in refused.values() for name in names)
    return "\n".join([*out, "", f"No family with this seed: {', '.join(missing) or 'none'}.", ""])


if __name__ == "__main__":
    main()
