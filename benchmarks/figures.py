"""The figures of the whole catalogue, inspected by program: labels, arrows, sizes, hinges, time.

    python -m benchmarks.figures [--seeds N] [--family NAME ...] [--language ru]

Draws N variants of every form of every family and counts labels that cover another label, a line or a symbol, or leave
the paper; leaders; the smallest free space around a label; hinges nearer to each other than a symbol; the faults of
arrows that ``variantgen.figure.inspection.arrow_faults`` finds, points that nothing marks; the largest figures; the
time of a figure. Prints a Markdown table and, run on the whole catalogue, writes it to
``benchmarks/figures.md``. Times depend on the machine.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections import Counter
from dataclasses import dataclass, field

from msgspec.structs import replace

from benchmarks.measure import machine_line, write_beside
from variantgen.families.family import Family, Form
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Arc, Drawing, Layer
from variantgen.figure.inspection.arrow_faults import inspect_arrows
from variantgen.figure.inspection.faults import inspect_labels, unmarked_points
from variantgen.figure.sketch import HINGE
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.outputs.typst.writing import figure_data
from variantgen.variants.draw import FamilySampler as Draws
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import Symbol
from variantgen.wording.language import load_language

_SAMPLE = 5  # figures of each form that are typeset for comparison
HEAD = """\
| family | form | figures | label on label | label on line | off paper | unnamed points | leaders | least space, u | \
hinges too near | not to scale | no text | arrow over a line | double arrow | behind a wall | line past a head | \
radius over a line | along a rim | small arc | foreign arc | no dot | largest, u | median CPU, ms |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"""
# Faults of arrows in the order of the columns, and points without a mark.
ARROWS = ("crossed", "doubled", "behind", "continued", "radii", "grazing", "small", "foreign", "unmarked")


# The same inspections before arrows and radii were placed by what they cross: what the last row is compared with.
BEFORE = (
    "Before arrows were placed by what they cross, the same inspections counted in 22 800 figures: 1313 arrows over"
    " a line, 432 double arrows, 2305 behind a wall, 1574 lines past a head, 507 radii over a line, 127 along a rim,"
    " 2358 small arcs, 57 foreign ones, 900 points without a dot."
)


@dataclass
class Tally:
    """Counts over the figures of one form (or of all)."""

    figures: int = 0
    overlaps: int = 0
    crossed: int = 0
    outside: int = 0
    unnamed: int = 0
    leaders: int = 0
    labels: int = 0
    near: int = 0
    off_scale: int = 0
    silent: int = 0
    arrows: Counter[str] = field(default_factory=Counter)
    clearances: list[tuple[float, str]] = field(default_factory=list)
    width: float = 0.0
    height: float = 0.0
    times: list[float] = field(default_factory=list)
    sample: list[Drawing] = field(default_factory=list)
    worst: list[str] = field(default_factory=list)

    def row(self, name: str, form: str) -> str:
        """One line of the table."""
        return (
            f"| {name} | {form} | {self.figures} | {self.overlaps} | {self.crossed} | {self.outside} | {self.unnamed}"
            f" | {self.leaders} | {min(self.clearances)[0]:.2f} | {self.near} | {self.off_scale} | {self.silent}"
            f" | {' | '.join(str(self.arrows[kind]) for kind in ARROWS)}"
            f" | {self.width:.0f} x {self.height:.0f} | {1e3 * statistics.median(self.times):.2f} |"
        )

    def add(self, other: Tally) -> None:
        """Count another tally in."""
        for name in (
            "figures",
            "overlaps",
            "crossed",
            "outside",
            "unnamed",
            "leaders",
            "labels",
            "near",
            "off_scale",
            "silent",
        ):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        self.arrows += other.arrows
        self.clearances += other.clearances
        self.times += other.times
        self.sample += other.sample
        self.width, self.height = max(self.width, other.width), max(self.height, other.height)


def hinges_too_near(drawing: Drawing) -> int:
    """Pairs of hinge circles whose centres are nearer than one symbol (two radii)."""
    places = [
        line.centre
        for line in drawing.lines
        if isinstance(line, Arc) and line.layer == Layer.HINGE and abs(line.radius - HINGE) < 1e-9
    ]
    return sum(1e-6 < abs(first - second) < 2 * HINGE for i, first in enumerate(places) for second in places[:i])


def off_scale(drawing: Drawing, places: list[complex]) -> bool:
    """Whether the hinges drawn are not where the solved points are, to 0.1 % of the width (one scale, no turning)."""
    drawn = [line.centre for line in drawing.lines if isinstance(line, Arc) and line.layer == Layer.HINGE]
    if not drawn or len(places) < 2:
        return False
    scale, shift = drawing.scale, drawing.origin
    return any(min(abs(scale * z + shift - d) for z in places) > 1e-3 * drawing.width for d in drawn)


def inspect(family: Family, form: Form, seeds: int, language_name: str) -> Tally:
    """All figures of one form."""
    language = load_language(language_name)
    narrowed = replace(family, forms={form.name: form})
    variants = Draws(narrowed, None).after([("figures", i) for i in range(seeds)], [0] * seeds)
    asked = [parse_quantity(text, form.sample) for text in form.ask]
    motion = solve_variants(variants, 0)
    tally = Tally()
    for i, variant in enumerate(variants):
        start = time.process_time()
        drawing = statement_figure(variant, motion, i, asked, language)
        tally.times.append(time.process_time() - start)
        seen = inspect_labels(drawing)
        tally.figures += 1
        tally.sample += [drawing] if i < _SAMPLE else []
        tally.overlaps += len(seen.overlaps)
        tally.crossed += len(seen.crossed)
        tally.outside += len(seen.outside)
        tally.leaders += seen.leaders
        tally.labels += len(drawing.labels)
        drawn = {label.formula for label in drawing.labels}
        points = shown_points(variant, asked)
        tally.unnamed += sum(Symbol(form.symbols.get(point, point) or point) not in drawn for point in points)
        tally.near += hinges_too_near(drawing)
        tally.off_scale += off_scale(drawing, [complex(motion.z[name][i]) for name in motion.z])
        tally.silent += not drawing.alt
        arrows = inspect_arrows(drawing).by_kind
        on_paper = {point: drawing.scale * complex(motion.z[point][i]) + drawing.origin for point in points}
        arrows["unmarked"] = unmarked_points(drawing, on_paper)
        tally.arrows += Counter({kind: len(faults) for kind, faults in arrows.items()})
        tally.clearances.append((seen.clearance, f"seed {i}"))
        tally.width, tally.height = max(tally.width, drawing.width), max(tally.height, drawing.height)
        said = [fault for faults in arrows.values() for fault in faults]
        if seen.overlaps or seen.crossed or seen.outside or said:
            tally.worst.append(f"{family.name}/{form.name} {i}: {seen.overlaps} {seen.crossed} {seen.outside} {said}")
    return tally


def typesetting(drawings: list[Drawing]) -> float:
    """Milliseconds of the engine per figure, on the same figures in the same run."""
    data = [figure_data(drawing) for drawing in drawings]
    page = '#import "figure.typ": draw-figure\n#import "common.typ": document-style, inputs\n'
    page += '#show: document-style.with("ru")\n'
    page += "#for f in json(inputs.data).figures { draw-figure(f, 80mm, 0.8mm) }\n"
    with typesetter() as engine:
        (engine.root / "figures.typ").write_text(page, "utf-8")

        def seconds(some: list[dict[str, object]]) -> float:
            start = time.process_time()
            engine.compile("figures.typ", {"figures": some})
            return time.process_time() - start

        # Each figure once: the engine remembers what it has laid out.
        seconds(data[:1])
        empty = min(seconds([]) for _ in range(3))
        return 1e3 * (seconds(data[1:]) - empty) / len(data[1:])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=300)
    parser.add_argument("--family", nargs="*")
    parser.add_argument("--language", default="ru")
    parser.add_argument("--worst", action="store_true", help="name the figures with faults")
    options = parser.parse_args()
    lines, total = [HEAD], Tally()
    for name in options.family or family_names():
        family = load_family(name)
        for form in family.forms.values():
            tally = inspect(family, form, options.seeds, options.language)
            total.add(tally)
            lines.append(tally.row(name, form.name))
            print(lines[-1], flush=True)
            if options.worst:
                print(*tally.worst, sep="\n")
    lines.append(total.row("all", ""))
    print(lines[-1])
    engine, median = typesetting(total.sample), 1e3 * statistics.median(total.times)
    share = f"{total.leaders} of {total.labels} labels have a leader. "
    ratio = (
        f"Typesetting such a figure takes the engine {engine:.2f} ms: drawing one takes {median / engine:.2f} of that."
    )
    print(share + ratio)
    if not options.family:
        note = f"{options.seeds} seeds per form, {machine_line()}"
        head = f"# The figures, inspected\n\n`python -m benchmarks.figures`: {note}.\n"
        write_beside(__file__, [head, *lines, "", share + ratio, "", BEFORE])


if __name__ == "__main__":
    main()
