"""How worked solutions read: length, digits, angles, senses, what is not used, figures; all forms, both languages.

    python -m benchmarks.solution_texts [--seeds N] [--family NAME ...] [--against PATH]

Prints Markdown tables and, run on the whole catalogue, writes them to ``benchmarks/solution_texts.md``. With
``--against`` another checkout is measured by the same rules in the same run: its numbers stand before the arrows.
Nothing here is a time; the numbers are the same on every machine.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from statistics import mean, median
from typing import Any

from variantgen.algebra.expression import Constant
from variantgen.algebra.substitution import substituted
from variantgen.algebra.values import in_order
from variantgen.exam.solution_figures import LEAST_INDEX, STATEMENT, SolutionFigures, view_order
from variantgen.families.asking import read_ask
from variantgen.families.reading import folders, load
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.figure.inspection.faults import misread_labels, short_arrows
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import written
from variantgen.wording.solution.plain import plain_solution

HERE = Path(__file__).resolve()
LANGUAGES = ("en", "ru")
family_names = getattr(folders, "family_names", None) or load.family_names  # older checkouts have it there
LONGEST = 5  # significant digits of a decimal that is not too long
COLUMNS = {
    "characters": "characters of the text",
    "numbers": "numbers in it",
    "long": "decimals with more than five significant digits, %",
    "given again": "angles worked out that are given",
    "unknown": "vectors of unknown magnitude",
    "minus": "of them with a negative magnitude, %",
    "unused": "quantities worked out and not used",
    "nearly": "lines with ≈",
    "axis x": "texts that speak of the x axis, %",
    "coordinates": "checks by the coordinate method, %",
    "no check": "solutions without a check, %",
    "figures": "figures",
    "narrow": "of them on paper narrower than half the width of the text, %",
    "room left": "of them narrower and lower than that, %",
    "small index": "of them with indices below 7 pt, %",
    "short arrows": "arrows shorter than twice their heads",
    "misread": "labels nearer to another arrow than to their own",
}
SHARES = {  # of what; "" of the texts
    "long": "decimals",
    "minus": "unknown",
    "axis x": "",
    "coordinates": "",
    "no check": "",
    "narrow": "figures",
    "room left": "figures",
    "small index": "figures",
}
HALF = 85.0  # mm: a column of the page
_NUMBER = re.compile(r"(?<![\w^,.])\d+(?:[.,]\d+)?")
_X_AXIS = re.compile(r"\baxis\s+x\b|\bx[\s\N{NO-BREAK SPACE}]axis\b|\bос(?:ь|и|ью)[\s\N{NO-BREAK SPACE}]x\b")
_COORDINATES = re.compile(r"coordinate\s+method|координатный\s+метод")
_FREE = "ways.unknown"  # a vector that a sum gives: it has no direction beforehand
_SAME = 1e-9


def inside(item: Any) -> Iterator[Any]:
    """All objects of an item of a solution, values without what they are computed from."""
    yield item
    if type(item).__name__ == "Value":
        return
    if isinstance(item, Mapping):
        item = tuple(item.values())
    names = getattr(type(item), "__match_args__", None)  # the fields, in this checkout and in older ones
    parts = [getattr(item, name) for name in names] if names is not None else item
    if isinstance(parts, list | tuple):
        for part in parts:
            yield from inside(part)


def values_in(item: Any) -> list[Any]:
    """The values in an item or an expression."""
    return [part for part in inside(item) if type(part).__name__ == "Value"]


def one(variant: Any, motion: Any, index: int) -> dict[str, dict[str, float]]:
    """What is counted in the solution of one variant, by language."""
    asked = read_ask(variant.form)
    task = task_of(variant, motion, index, asked)
    found = solution(task)
    counted = of_steps(found, [abs(float(variant.printed[name])) for name in angles_given(variant)])
    counts = {}
    for name in LANGUAGES:
        language = load_language(name)
        text = written(task, found, language)
        figures = SolutionFigures(variant, asked, language, (motion, index), None, text)
        counts[name] = counted | of_text(text, name) | of_figures(figures, view_order(text))
    return counts


def angles_given(variant: Any) -> list[str]:
    """The parameters that are angles."""
    known = variant.form.parameters.items()
    return [name for name, parameter in known if parameter.unit is not None and parameter.unit.name == "deg"]


def of_steps(found: Any, given: Sequence[float]) -> dict[str, float]:
    """What is counted in the steps themselves."""
    items = [item for step in found.steps for item in step.items]
    derived = [item.value for item in items if type(item).__name__ == "Derived"]
    answers = [abs(value.exact) for _, value in found.answers]
    again = [value for value in derived if value.measure == "angle" and reproduces(value, given)]
    free = {
        term.name
        for item in items
        for term in inside(item)
        if type(term).__name__ == "Term" and term.size is None and term.way.key != _FREE
    }
    sought = {value.name: value for value in derived if value.name in free}
    unused = [v for v in not_met_again(items, found) if not any(abs(abs(v.exact) - a) <= _SAME * a for a in answers)]
    return {
        "given again": len(again),
        "unknown": len(sought),
        "minus": sum(value.exact < 0 for value in sought.values()),
        "unused": len(unused),
        "no check": not found.check,
    }


def not_met_again(items: Sequence[Any], found: Any) -> list[Any]:
    """The values of lines that no later line needs; of vectors those that no later equation has either."""
    met = {value.name for _, value in found.answers}
    for item in found.check:
        met |= names_in(item)
    unused = []
    for item in reversed(items):
        if type(item).__name__ != "Derived":
            met |= names_in(item)
            continue
        if item.value.name not in met and id(item.value) not in met:
            unused.append(item.value)
        met |= names_in(item.value.expression) | names_in(getattr(item, "law", None))
    return unused


def names_in(item: Any) -> set[Any]:
    """The names of values and vectors in an item; a value without a name is itself and what it is computed of."""
    names: set[Any] = set()
    for part in inside(item):
        if type(part).__name__ == "Term":
            names.add(part.name)
        elif type(part).__name__ == "Value":
            names |= {part.name} if part.name is not None else {id(part), *names_in(part.expression)}
    return names


def reproduces(value: Any, given: Sequence[float]) -> bool:
    """Whether an angle is a sum of others that is one of those given, whatever that one is.

    So is a sum of bare numbers that comes to it, and one that changes as the given angle does and with nothing else:
    ``180 - (180 - phi)``. By its number alone 90 - phi is phi at 45 degrees, and it has to be worked out.
    """
    if type(value.expression).__name__ != "Total":
        return False
    if not any(abs(abs(value.exact) - angle) <= _SAME * max(angle, 1.0) for angle in given):
        return False
    leaves = [leaf for leaf in in_order([value]) if leaf.expression is None]
    moved = [(leaf, change) for leaf in leaves if abs(change := _changed(value, leaf) - value.exact) > _SAME]
    if len(moved) != 1:
        return not moved
    (leaf, change), same = moved[0], _SAME * max(abs(value.exact), 1.0)
    return abs(change - 1.0) <= _SAME and abs(leaf.exact - value.exact) <= same


def _changed(value: Any, leaf: Any) -> float:
    """What a value is where a datum is larger by 1."""
    table = {leaf: Constant(leaf.exact + 1.0, leaf.measure)}
    for item in in_order([value]):
        if item is not leaf and item.expression is not None:
            table[item] = Constant((substituted(item.expression, table) or Constant(0.0)).number(True), item.measure)
    return table[value].number(True)


def of_text(text: Any, language: str) -> dict[str, float]:
    """What is counted in the text of a solution."""
    plain = plain_solution(text, load_language(language))
    numbers = _NUMBER.findall(plain)
    decimals = [number for number in numbers if re.search("[.,]", number)]
    return {
        "characters": len(plain),
        "numbers": len(numbers),
        "decimals": len(decimals),
        "long": sum(len(re.sub("[.,]", "", number).lstrip("0")) > LONGEST for number in decimals),
        "nearly": plain.count("≈"),
        "axis x": bool(_X_AXIS.search(plain)),
        "coordinates": bool(_COORDINATES.search(plain)),
    }


def of_figures(figures: SolutionFigures, names: Sequence[str]) -> dict[str, float]:
    """What is counted in the figures of the steps, as large as they are on paper; plans have a scale of their own."""
    figures.draw(names)
    shown = [figure for row in figures.rows() for figure in row if figure.name != STATEMENT]
    drawings = [figure.drawing for figure in shown]
    sizes = [(figure.unit * figure.drawing.width, figure.unit * figure.drawing.height) for figure in shown]
    return {
        "figures": len(shown),
        "narrow": sum(width < HALF for width, _ in sizes),
        "room left": sum(max(size) < HALF for size in sizes),
        "small index": sum(round(f.index_size, 1) < LEAST_INDEX for f in shown if not f.name.endswith("_plan")),
        "short arrows": sum(len(short_arrows(drawing)) for drawing in drawings),
        "misread": sum(len(misread_labels(drawing)) for drawing in drawings),
    }


def rows(families: Sequence[str], seeds: int) -> dict[str, dict[str, float]]:
    """The mean of each count by form and language; of shares the sums are kept too."""
    found = {}
    for name in families:
        family = load_family(name)
        for form in family.forms:
            own = restrict(family, None, None, (form,) if form else ())
            variants = draw(own, None, [("solution texts", i) for i in range(seeds)])
            motion = solve_variants(variants, 2)
            counted = [one(variant, motion, i) for i, variant in enumerate(variants)]
            for language in LANGUAGES:
                own_counts = [item[language] for item in counted]
                means = {key: mean(item[key] for item in own_counts) for key in own_counts[0]}
                found[f"{name} {form}".strip() + f", {language}"] = means
    return found


def of_checkout(path: Path, families: Sequence[str], seeds: int) -> dict[str, dict[str, float]]:
    """The rows of another checkout, by this script in a process of its own."""
    command = [sys.executable, "-P", str(HERE), "--rows", "--seeds", str(seeds), "--family", *families]
    settings = {**os.environ, "PYTHONPATH": str(path.resolve())}
    done = subprocess.run(command, check=True, capture_output=True, text=True, env=settings, cwd=path)
    found: dict[str, dict[str, float]] = json.loads(done.stdout)
    return found


def shown(row: Mapping[str, float], key: str) -> float:
    """A number of the table: shares in percent of what they are shares of."""
    if key not in SHARES:
        return row[key]
    whole = row[SHARES[key]] if SHARES[key] else 1.0
    return 100.0 * row[key] / whole if whole else 0.0


def cell(values: Sequence[float]) -> str:
    """One number, or two with an arrow between."""
    return " → ".join(f"{value:.0f}" if value >= 100 else f"{value:.3g}" for value in values)


def overall(table: Mapping[str, Mapping[str, float]], key: str) -> float:
    """The share of a count in all texts together, or its mean."""
    whole = SHARES.get(key, "")
    sums = {name: sum(row[name] for row in table.values()) for name in {key, whole} - {""}}
    if whole:
        return 100.0 * sums[key] / sums[whole] if sums[whole] else 0.0
    return sums[key] / len(table) * (100.0 if key in SHARES else 1.0)


def document(tables: Sequence[Mapping[str, Mapping[str, float]]]) -> list[str]:
    """The tables in Markdown: medians over the forms and means over all, and a line for each form and language."""
    lines = ["| | median of the forms | all texts |", "|---|---|---|"]
    for key, title in COLUMNS.items():
        known = [table for table in tables if key in next(iter(table.values()))]  # older checkouts are not counted
        medians = [median(shown(row, key) for row in table.values()) for table in known]
        lines.append(f"| {title} | {cell(medians)} | {cell([overall(table, key) for table in known])} |")
    lines += ["", "| form | " + " | ".join(COLUMNS) + " |", "|---" * (len(COLUMNS) + 1) + "|"]
    for name in tables[-1]:
        own = [table[name] for table in tables if name in table]
        cells = [cell([shown(row, key) for row in own if key in row]) for key in COLUMNS]
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=20, help="variants of every form")
    parser.add_argument("--family", nargs="*", help="only these")
    parser.add_argument("--against", type=Path, metavar="PATH", help="another checkout, measured before this one")
    parser.add_argument("--rows", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    known = family_names()
    families = [name for name in options.family or known if name in known]
    if options.rows:
        print(json.dumps(rows(families, options.seeds)))
        return
    before = [of_checkout(options.against, families, options.seeds)] if options.against else []
    note = f"{options.seeds} variants of each form, English and Russian"
    if before:
        note += "; another checkout → this one"
    title = f"# Worked solutions, how they read\n\n`python -m benchmarks.solution_texts`: {note}."
    lines = [title, "", *document([*before, rows(families, options.seeds)])]
    print(*lines, sep="\n")
    if options.family is None:
        HERE.with_suffix(".md").write_text("\n".join(lines) + "\n", "utf-8")


if __name__ == "__main__":
    main()
