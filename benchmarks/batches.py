"""Batches from Python (``variantgen.batch``) beside the closed form in plain numpy on the same parameters.

The closed form only computes place, velocity and acceleration of B from arrays that it is given. A batch also draws the
variants (a dozen attempts for each that is valid), screens them, solves all points and links and makes answers of them.
"""

from __future__ import annotations

import numpy as np

import variantgen
from benchmarks.measure import Table, fastest
from benchmarks.options import Options
from benchmarks.rivals import MECHANISMS, Mechanism, numpy_way
from benchmarks.solver import difference, solved
from variantgen.arrays.batch import Batch

TITLE = "Batches"
SIZES = (100, 1000, 10_000, 100_000)
_ROUNDS = 5
# The public way one by one: of so many the time is measured and told for each.
_ONE_BY_ONE = 20


def run(options: Options) -> list[Table]:
    """Both mechanisms of the comparison, by size of the batch."""
    sizes = (1, options.students) if options.quick else SIZES
    return [batches(mechanism, sizes, 1 if options.quick else _ROUNDS) for mechanism in MECHANISMS]


def drawn(mechanism: Mechanism, size: int) -> Batch:
    """A batch with its answers."""
    found = variantgen.batch(mechanism.family, size, seed="benchmark", form=mechanism.form)
    assert found.answers
    return found


def batches(mechanism: Mechanism, sizes: tuple[int, ...], rounds: int) -> Table:
    """Milliseconds of a batch and of the closed form, their ratio, and how far their results are from each other."""
    table = Table(
        f"{mechanism.family}, {mechanism.form}: milliseconds of CPU for a batch",
        (
            "variants",
            "batch, drawn, screened, with answers",
            "solver alone",
            "closed form, plain numpy",
            "batch / closed form",
            "solver / closed form",
            "one by one",
            "largest difference",
        ),
        f"One thread, least of {rounds} interleaved rounds, the family loaded. The closed form has place, velocity and"
        " acceleration of B from arrays that it is given; the solver all points and links from the same arrays. One by"
        f" one: variantgen.draw and variantgen.answers for each, by {_ONE_BY_ONE} of them.",
    )
    family = variantgen.load_family(mechanism.family)
    for size in sizes:
        found = drawn(mechanism, size)
        form, few = found.form, min(size, _ONE_BY_ONE)
        values = {name: form.parameters[name].si[i] for name, i in found.index.items()}
        closed = numpy_way(mechanism, mechanism.inputs(values))
        took = fastest(
            {
                "batch": lambda size=size: drawn(mechanism, size),  # type: ignore[misc]
                "solver": solved(form, values),
                "closed": closed,
                "one": lambda few=few: [  # type: ignore[misc]
                    variantgen.answers(variantgen.draw(family, None, [("benchmark", i)])[0]) for i in range(few)
                ],
            },
            rounds,
        )
        plain = variantgen.solve(form.scene(form.values(values)), 2, form.plan)
        batch, solver, bare = (1e3 * took[name] for name in ("batch", "solver", "closed"))
        one = 1e3 * took["one"] * size / few
        table.add(size, batch, solver, bare, batch / bare, solver / bare, one, difference(closed(), plain))
        assert np.allclose(np.abs(plain.v["B"]), np.abs(found.velocities["B"])), (
            "how a scene lies on paper turns v only"
        )
    print(table.markdown(), flush=True)
    return table
