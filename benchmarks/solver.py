"""Positions, velocities and accelerations: every form of the catalogue by size of the batch, and other ways beside."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from benchmarks.measure import Table, fastest
from benchmarks.options import Options
from benchmarks.rivals import EXTRA, MECHANISMS, Mechanism, ways
from variantgen.families.family import Family, Form
from variantgen.families.form_motion import motion_of
from variantgen.families.parameters.draw_rules import frame
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.solving.solve import solve
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant, parameter_arrays

TITLE = "The solver"
SIZES = (1, 10, 100, 1000, 10_000)
_DRAWN = 100  # different variants; larger batches repeat them
_ROUNDS = 5
OWN, PREPARED = "variantgen", "variantgen.solve, scene made beforehand"

Columns = dict[str, NDArray[np.float64]]


def run(options: Options) -> list[Table]:
    """Measure all forms, then the comparisons."""
    rounds = 1 if options.quick else _ROUNDS
    sizes = (1, options.students) if options.quick else SIZES
    names = [mechanism.family for mechanism in MECHANISMS] if options.quick else family_names()
    forms = [(load_family(name), form) for name in names for form in load_family(name).forms.values()]
    found = [catalogue_table(forms[:2] if options.quick else forms, sizes, rounds)]
    for mechanism in MECHANISMS:
        found.append(comparison(mechanism, sizes, rounds))
        print(found[-1].markdown(), flush=True)
    return found


def drawn(family: Family, form: Form, count: int) -> list[Variant]:
    """Variants of one form, always the same ones."""
    alone = replace(family, forms={form.name: form})
    return draw(alone, None, [("benchmark", i) for i in range(count)])


def repeated(values: Columns, size: int) -> Columns:
    """So many columns, from the first on again and again."""
    return {name: column[np.arange(size) % column.size] for name, column in values.items()}


def solved(form: Form, values: Columns, on_paper: Frame | None = None) -> Callable[[], Motion]:
    """The whole way from arrays of parameters to accelerations."""
    return lambda: motion_of(form, values, on_paper)


def catalogue_table(forms: Sequence[tuple[Family, Form]], sizes: Sequence[int], rounds: int) -> Table:
    """Microseconds per variant of every form by size of the batch."""
    table = Table(
        "Microseconds of CPU per variant: positions, velocities and accelerations by size of the batch",
        ("family", "form", "unknown rates", *map(str, sizes)),
        f"From arrays of parameters to the motion, least of {rounds} rounds. Unknown rates: those solved for together.",
    )
    for family, form in forms:
        variants = drawn(family, form, min(_DRAWN, max(sizes)))
        turns = {"sense": np.array([v.sense for v in variants]), "turns": np.array([v.turns for v in variants])}
        known = parameter_arrays(variants)
        calls: dict[str, Callable[[], object]] = {}
        for size in sizes:
            pose = repeated(turns, size)
            calls[str(size)] = solved(form, repeated(known, size), frame(pose["sense"], pose["turns"]))
        seconds = fastest(calls, rounds)
        blocks = "+".join(str(len(block.unknowns)) for block in form.plan.blocks)
        table.add(family.name, form.name, blocks or "-", *(1e6 * seconds[str(size)] / size for size in sizes))
        print(family.name, form.name, *(f"{cell:.3g}" for cell in table.rows[-1][3:]), flush=True)
    return table


def comparison(mechanism: Mechanism, sizes: Sequence[int], rounds: int) -> Table:
    """One form by all ways: microseconds per variant, and how far the results are from those of the program."""
    family = load_family(mechanism.family)
    form = family.forms[mechanism.form]
    known = parameter_arrays(drawn(family, form, min(_DRAWN, max(sizes))))
    seconds: dict[str, list[float]] = {}
    differences: dict[str, float | None] = {}
    missing: list[str] = []
    for size in sizes:
        values = repeated(known, size)
        scene, motion = form.scene(form.values(values)), solved(form, values)()
        calls: dict[str, Callable[[], object]] = {
            OWN: solved(form, values),
            PREPARED: lambda scene=scene: solve(scene, 2, form.plan),  # type: ignore[misc]
        }
        for name, way in ways(mechanism, mechanism.inputs(values)):
            if way is None:
                missing += [name] if size == sizes[0] else []
            else:
                calls[name] = way
                differences[name] = max(differences.get(name) or 0.0, difference(way(), motion))
        for name, value in fastest(calls, rounds).items():
            seconds.setdefault(name, []).append(1e6 * value / size)
    notes = [f"{name} left out, its package is not installed: {EXTRA}." for name in missing]
    table = Table(
        f"{mechanism.family}, {mechanism.form}, by other ways: microseconds of CPU per variant by size of the batch",
        ("way", *map(str, sizes), "largest difference from variantgen"),
        " ".join(
            [
                "From arrays of parameters to place, velocity and acceleration of B (of all points and links here); "
                "one thread; compiling is not counted. Differences are relative, over place, velocity, acceleration.",
                *notes,
            ]
        ),
    )
    for name, own in seconds.items():
        table.add(name, *own, differences.get(name))
    for name in missing:
        table.add(name, *[None] * (len(sizes) + 1))
    return table


def difference(found: NDArray[np.float64], motion: Motion) -> float:
    """The largest relative difference of place, velocity and acceleration of B in any variant."""
    assert not np.any(motion.outcome), "the variants are drawn, so they are solved"
    largest = 0.0
    for row, right in enumerate((motion.z["B"], motion.v["B"], motion.a["B"])):
        other = found[2 * row] + 1j * found[2 * row + 1]
        largest = max(largest, float(np.max(np.abs(other - right) / np.abs(right))))
    return largest
