"""Drawing of variants: uniform over the valid part of the grid, bounded.

For each student the raw stream is cut into attempts (one word for the pose, one per parameter). The first attempt
that passes all screens is the variant: that is rejection sampling, uniform over the valid grid. Attempts of all
students are screened together as one batch.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from variantgen.errors import InputError, Problem
from variantgen.families.asking import Ask, read_ask
from variantgen.families.family import Family
from variantgen.variants.attempts import FormSampler
from variantgen.variants.batch import MakeScreening, RejectionCounts
from variantgen.variants.distinct import TooFewError
from variantgen.variants.examined import examined
from variantgen.variants.printed_data import max_distinct_problems
from variantgen.variants.seeding import Stream, index_below
from variantgen.variants.variant import Variant


def draw(
    family: Family,
    ask: Ask,
    keys: Sequence[tuple[object, ...]],
    tally: RejectionCounts | None = None,
    screening: MakeScreening | None = None,
) -> list[Variant]:
    """One variant per key, each depending on its key only (and on the family); keys may repeat variants.

    ``ask`` names the asked quantities (None: those of each form); it only matters whether accelerations are among them,
    and what no form asks by itself (:mod:`variantgen.variants.examined`). Raises InputError when the ranges leave
    nothing.
    """
    return FamilySampler(family, ask, tally, screening=screening).after(keys, [0] * len(keys))


def check_room(drawings: Sequence[FamilySampler]) -> None:
    """Raise InputError where there are fewer points of the grid than requests for them, without drawing anything.

    ``drawings`` has the sampler of every request.
    """
    wanted = Counter(map(id, drawings))
    for drawing in {id(drawing): drawing for drawing in drawings}.values():
        room = sum(max_distinct_problems(form, drawing.asked[form.name]) for form in drawing.forms)
        if room < wanted[id(drawing)]:
            raise InputError(_too_few(drawing, wanted[id(drawing)], room))


def too_few(error: TooFewError, drawings: Sequence[FamilySampler]) -> InputError:
    """The error where there are fewer variants than requests; ``drawings`` has the sampler of every request."""
    drawing = drawings[error.owner]
    wanted = sum(other is drawing for other in drawings)
    return InputError(_too_few(drawing, wanted, error.found(lambda i: drawings[i] is drawing)))


def _too_few(drawing: FamilySampler, wanted: int, found: int) -> Problem:
    return Problem(
        f"the ranges leave too few distinct variants: {wanted} sheets need as many, at most {found} were found",
        key=drawing.where,
        remedy="widen a range, fix fewer parameters or add another family to the pool",
    )


def next_draws(
    drawings: Sequence[FamilySampler], keys: Sequence[tuple[object, ...]], done: Sequence[int]
) -> list[Variant]:
    """The next valid draw of each key from its drawing, after the attempts ``done`` that it has used.

    Those of one drawing are screened as one batch.
    """
    groups: dict[int, list[int]] = {}
    for i, drawing in enumerate(drawings):
        groups.setdefault(id(drawing), []).append(i)
    found: dict[int, Variant] = {}
    for members in groups.values():
        own = drawings[members[0]].after([keys[i] for i in members], [done[i] for i in members])
        found.update(zip(members, own, strict=True))
    return [found[i] for i in range(len(drawings))]


class FamilySampler:
    """The drawing of one family for one list of asked quantities; ``screening`` adds screens to those of the family."""

    def __init__(
        self,
        family: Family,
        ask: Ask,
        tally: RejectionCounts | None = None,
        where: str = "",
        screening: MakeScreening | None = None,
    ) -> None:
        self.family, self.screening = family, screening
        self.where = f"{where}: {family.name}" if where else family.name
        self.forms = list(family.forms.values())
        self.asked = {form.name: read_ask(form, ask) for form in self.forms}
        self.examined = {form.name: examined(form, self.asked[form.name]) for form in self.forms}
        self.tally = tally or RejectionCounts()

    def after(self, keys: Sequence[tuple[object, ...]], done: Sequence[int]) -> list[Variant]:
        """The first valid draw of each key after the attempts ``done`` that it has used."""
        streams = [Stream(*key, self.family.name) for key in keys]
        chosen = [int(index_below(stream.words(1), len(self.forms))[0]) for stream in streams]
        found: dict[int, Variant] = {}
        for number, form in enumerate(self.forms):
            members = [i for i, choice in enumerate(chosen) if choice == number]
            if members:
                batch = FormSampler(self.family, form, self.examined[form.name], self.tally, self.where, self.screening)
                own = batch.run([streams[i] for i in members], [done[i] for i in members])
                found.update(zip(members, own, strict=True))
        return [found[i] for i in range(len(keys))]
