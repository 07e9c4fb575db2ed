"""A blind comparison set: composed problems and problems of the catalogue with as many links, shuffled, the key apart.

    python -m benchmarks.blind --out FOLDER [--each N] [--lang ru] [--seed SEED]

Writes ``01.html`` ... (one problem each, without title and name) and ``key.csv`` to a folder. Who reads them says of
each whether a book would print it, and only then opens the key.
"""

from __future__ import annotations

import argparse
import csv
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path

from variantgen.errors import InputError
from variantgen.exam.composed import write
from variantgen.exam.composed_pools import shuffled
from variantgen.families.asking import read_ask
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.outputs.figures.svg import svg
from variantgen.single import one_variant
from variantgen.synthesis.recognition import structures_of
from variantgen.synthesis.structures import Structure, code, moving_links, textbook_structures
from variantgen.variants.seeding import digest
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import to_plain
from variantgen.wording.html import to_html
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement

_TRIES = 5  # of structures for a problem
_PAGE = """<!DOCTYPE html><meta charset="utf-8"><title>{number}</title>
<style>body {{ font: 1.1rem serif; margin: 2rem; max-width: 60rem }}
svg {{ float: right; margin: 1rem; height: 20rem }}</style>
<h1>{number}</h1>{figure}<p>{text}</p><p>{data}</p><p>{asked}</p>
"""


def composed_families(folder: Path, sizes: Iterable[int], seed: str) -> Iterator[tuple[str, Path]]:
    """A composed family for each number of moving links, and its code; no structure twice while there are others."""
    left: list[Structure] = []
    for number, size in enumerate(sizes):
        for _ in range(_TRIES):
            own = [structure for structure in left if moving_links(structure) == size]
            if not own:
                every = textbook_structures(size)
                own = [s for s in shuffled(every, f"{seed} {number}", "") if moving_links(s) == size]
                left += own
            left.remove(own[0])
            made = folder / f"{number} {code(own[0])}"
            with suppress(InputError):
                write(own[0], f"{seed} {number}", made, with_case=False)
                yield f"composed {code(own[0])}", made
                break


def catalogue_forms(each: int, seed: str) -> list[tuple[str, str, str, int]]:
    """So many forms of the catalogue that could have been composed: names, family, form, number of moving links."""
    forms = [
        (f"catalogue {family.name} {name}", family.name, name, moving_links(min(known)))
        for family in map(load_family, family_names())
        for name, form in family.forms.items()
        if (known := structures_of(form.sample))
    ]
    ordered = sorted(forms, key=lambda item: digest("blind", item[0], seed))
    return (ordered * each)[:each]


def page(number: str, name: str, form: str, seed: str, language: str) -> str:
    """A problem without anything that tells where it is from."""
    variant, spoken = one_variant(name, form=form, seed=seed), load_language(language)
    asked = read_ask(variant.form)
    problem = statement(variant, asked, spoken)
    drawing = statement_figure(variant, solve_variants([variant], 2), 0, asked, spoken)
    text = "".join(part if isinstance(part, str) else to_html(part) for part in problem.text)
    data = ", ".join(to_html(equation) for equation in problem.given)
    wanted = ", ".join(to_plain(spoken.symbol(quantity.name, variant.form.symbols)) for quantity in asked)
    return _PAGE.format(number=number, figure=svg(drawing, name=f"n{number}"), text=text, data=data, asked=wanted)


def main() -> None:
    """Write the set."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--each", type=int, default=20)
    parser.add_argument("--lang", default="en")
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    options.out.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as scratch:
        forms = catalogue_forms(options.each, options.seed)
        sizes = [size for *_, size in forms]
        own = [(what, str(path), "") for what, path in composed_families(Path(scratch), sizes, options.seed)]
        every = [(*item, str(i)) for i, item in enumerate(own + [form[:3] for form in forms])]
        every.sort(key=lambda item: digest("shuffle", *item, options.seed))
        rows = []
        for place, (what, name, form, seed) in enumerate(every, start=1):
            (options.out / f"{place:02}.html").write_text(page(f"{place}", name, form, seed, options.lang), "utf-8")
            rows.append((place, what))
    with (options.out / "key.csv").open("w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([("number", "source"), *rows])


if __name__ == "__main__":
    main()
