"""How many distinct valid variants a form has: counted on small grids, estimated on large ones."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from msgspec import Struct

from variantgen.families.family import Family, Form
from variantgen.families.quantities import Quantity
from variantgen.variants.attempts import FormSampler
from variantgen.variants.batch import Attempts, RejectionCounts
from variantgen.variants.seeding import Stream, index_below

# Grids up to this size are screened point by point (a second or so).
_COUNTED, _COUNTED_IN_TIME = 20_000, 1_000  # the fewer where each point needs the motion in an interval of time
_SILENT_TRIALS = 12


class Variety(Struct, frozen=True):
    """Number of points of the printed grid, how many of them are valid, and whether that was counted."""

    grid: int
    valid: int
    exact: bool


def variety(family: Family, form: Form, asked: Sequence[Quantity], accepted: int, attempts: int) -> Variety:
    """The distinct valid variants of a form.

    On a large grid the share of valid points is estimated by that of the draws, ``accepted / attempts``: a draw is
    uniform over the grid.
    """
    grid = form.grid_size
    if grid > (_COUNTED_IN_TIME if any(quantity.is_of_interval for quantity in asked) else _COUNTED):
        return Variety(grid, round(grid * accepted / attempts), False)
    free = form.free_names
    sizes = [len(form.parameters[name].printed) for name in free]
    if form.ties:
        sizes.append(len(form.ties.rows))
    places = np.indices(sizes).reshape(len(sizes), -1) if sizes else np.zeros((0, 1), dtype=np.int64)
    index = dict(zip(free, places, strict=False))
    if form.ties:
        index |= {name: place[places[-1]] for name, place in form.ties.places(form.parameters).items()}
    silent = [name for name in sorted(form.parameters) if form.parameters[name].silent]
    valid = np.zeros(grid, dtype=bool)
    drawing = FormSampler(family, form, asked, RejectionCounts(), family.name)
    # Silent parameters are no part of a variant, but some of their values may not go with it: several are tried.
    for trial in range(_SILENT_TRIALS if silent else 1):
        words = Stream("variety", family.name, form.name, trial)
        for name in silent:
            index[name] = index_below(words.words(grid), len(form.parameters[name].printed))
        left = np.flatnonzero(~valid)
        every = Attempts(index, np.zeros(grid, dtype=np.int64), np.arange(grid), np.arange(grid))
        valid[drawing.valid(every.take(left)).owner] = True
    return Variety(grid, int(np.sum(valid)), not silent)
