"""A blind comparison set: composed problems and problems of the catalogue, shuffled, with the key in a file apart.

    python -m benchmarks.blind --out FOLDER [--each N] [--lang ru] [--seed SEED]

Writes ``01.html`` ... (one problem each, without title and name) and ``key.csv`` to a folder. Who reads them says of
each whether a book would print it, and only then opens the key.
"""

from __future__ import annotations

import argparse
import csv
import tempfile
from collections.abc import Iterator
from pathlib import Path

from variantgen.errors import InputError
from variantgen.exam.composed import write
from variantgen.exam.composed_pools import shuffled
from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.outputs.figures.svg import svg
from variantgen.single import one_variant
from variantgen.synthesis.recognition import structures_of
from variantgen.synthesis.structures import code, textbook_structures
from variantgen.variants.seeding import digest
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import to_plain
from variantgen.wording.html import to_html
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement

_PAGE = """<!DOCTYPE html><meta charset="utf-8"><title>{number}</title>
<style>body {{ font: 1.1rem serif; margin: 2rem; max-width: 60rem }}
svg {{ float: right; margin: 1rem; height: 20rem }}</style>
<h1>{number}</h1>{figure}<p>{text}</p><p>{data}</p><p>{asked}</p>
"""


def composed_families(folder: Path, each: int, seed: str) -> Iterator[tuple[str, Path]]:
    """So many composed families, with their codes."""
    found = 0
    for structure in shuffled(textbook_structures(5), seed, ""):
        if found == each:
            return
        try:
            write(structure, seed, folder / code(structure), with_case=False)
        except InputError:
            continue
        found += 1
        yield f"composed {code(structure)}", folder / code(structure)


def catalogue_forms(each: int, seed: str) -> list[tuple[str, str, str]]:
    """So many forms of the catalogue that could have been composed: their names, family and form."""
    families = [load_family(name) for name in family_names()]
    forms = [(f"catalogue {f.name} {n}", f.name, n) for f in families for n, form in f.forms.items() if _alike(f, n)]
    ordered = sorted(forms, key=lambda item: digest("blind", item[0], seed))
    return (ordered * each)[:each]


def _alike(family: Family, form: str) -> bool:
    return bool(structures_of(family.forms[form].sample))


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
        own = [(what, str(path), "") for what, path in composed_families(Path(scratch), options.each, options.seed)]
        every = [(*item, str(i)) for i, item in enumerate(own + catalogue_forms(options.each, options.seed))]
        every.sort(key=lambda item: digest("shuffle", *item, options.seed))
        rows = []
        for place, (what, name, form, seed) in enumerate(every, start=1):
            (options.out / f"{place:02}.html").write_text(page(f"{place}", name, form, seed, options.lang), "utf-8")
            rows.append((place, what))
    with (options.out / "key.csv").open("w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([("number", "source"), *rows])


if __name__ == "__main__":
    main()
