"""Drawing of variants: uniform over the valid part of the grid, bounded, distinct.

For each student the raw stream is cut into attempts (one word for the pose, one per parameter). The first attempt
that passes all screens is the variant: that is rejection sampling, uniform over the valid grid. Attempts of all
students are screened together as one batch.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from variantgen.errors import InputError, Problem
from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.variants.attempts import FormDrawing, Judge, Tally
from variantgen.variants.seeding import Stream, index_below
from variantgen.variants.variant import Variant


def draw(
    family: Family,
    ask: Sequence[str] | None,
    keys: Sequence[tuple[object, ...]],
    tally: Tally | None = None,
    judge: Judge | None = None,
) -> list[Variant]:
    """One variant per key, each depending on its key only (and on the family); keys may repeat variants.

    ``ask`` names the asked quantities (None: those of each form). Raises InputError when the ranges leave nothing.
    """
    return Drawing(family, ask, tally, judge=judge).after(keys, [0] * len(keys))


@dataclass(frozen=True)
class Entry:
    """A wish for one variant: from which drawing, by which key, and its rank where two would get the same."""

    drawing: Drawing
    key: tuple[object, ...]
    priority: bytes


def draw_distinct(entries: Sequence[Entry]) -> tuple[list[Variant], list[int]]:
    """One variant per entry, no two the same; also the positions of those that had to draw again.

    Where two entries would get the same variant, the one with the smaller ``priority`` keeps it and the other takes
    the next of its own valid draws. The result does not depend on the order of the entries (it is the stable
    matching of deferred acceptance). Raises InputError if there are fewer distinct variants than entries.
    """
    _check_room(entries)
    found = _drawn(entries, [0] * len(entries))
    again: set[int] = set()
    seen = {variant.identity for variant in found}
    idle = 0
    while True:
        holders: dict[object, int] = {}
        losers = []
        for i in sorted(range(len(entries)), key=lambda i: entries[i].priority):
            if holders.setdefault(found[i].identity, i) != i:
                losers.append(i)
        if not losers:
            return found, sorted(again)
        again.update(losers)
        replaced = _drawn([entries[i] for i in losers], [found[i].attempt for i in losers])
        for i, variant in zip(losers, replaced, strict=True):
            found[i] = variant
        new = {variant.identity for variant in replaced} - seen
        seen |= new
        idle = 0 if new else idle + len(losers)
        # One unseen variant among n is missed by 20 n draws with a probability of 2e-9.
        if idle > 100 + 20 * len(seen):
            raise InputError(_too_few(entries[losers[0]].drawing, len(entries), len(seen)))


def _check_room(entries: Sequence[Entry]) -> None:
    """Raise InputError where there are more entries than points of the grid, without drawing anything."""
    wanted = Counter(id(entry.drawing) for entry in entries)
    for drawing in {id(entry.drawing): entry.drawing for entry in entries}.values():
        room = sum(form.grid_size for form in drawing.forms)
        if room < wanted[id(drawing)]:
            raise InputError(_too_few(drawing, wanted[id(drawing)], room))


def _too_few(drawing: Drawing, wanted: int, found: int) -> Problem:
    return Problem(
        f"the ranges leave too few distinct variants: {wanted} sheets need as many, at most {found} were found",
        key=drawing.where,
        remedy="widen a range, fix fewer parameters or add another family to the pool",
    )


def _drawn(entries: Sequence[Entry], done: Sequence[int]) -> list[Variant]:
    """The next valid draw of each entry; entries of one drawing are screened as one batch."""
    groups: dict[int, list[int]] = {}
    for i, entry in enumerate(entries):
        groups.setdefault(id(entry.drawing), []).append(i)
    found: dict[int, Variant] = {}
    for members in groups.values():
        drawing = entries[members[0]].drawing
        drawn = drawing.after([entries[i].key for i in members], [done[i] for i in members])
        found.update(zip(members, drawn, strict=True))
    return [found[i] for i in range(len(entries))]


class Drawing:
    """The drawing of one family for one list of asked quantities; ``judge`` adds screens to those of the family."""

    def __init__(
        self,
        family: Family,
        ask: Sequence[str] | None,
        tally: Tally | None = None,
        where: str = "",
        judge: Judge | None = None,
    ) -> None:
        self.family, self.judge = family, judge
        self.where = f"{where}: {family.name}" if where else family.name
        self.forms = list(family.forms.values())
        self.asked = {form.name: read_ask(form, ask) for form in self.forms}
        self.tally = tally or Tally()

    def after(self, keys: Sequence[tuple[object, ...]], done: Sequence[int]) -> list[Variant]:
        """The first valid draw of each key after the attempts ``done`` that it has used."""
        streams = [Stream(*key, self.family.name) for key in keys]
        chosen = [int(index_below(stream.words(1), len(self.forms))[0]) for stream in streams]
        found: dict[int, Variant] = {}
        for number, form in enumerate(self.forms):
            members = [i for i, choice in enumerate(chosen) if choice == number]
            if members:
                batch = FormDrawing(self.family, form, self.asked[form.name], self.tally, self.where, self.judge)
                drawn = batch.run([streams[i] for i in members], [done[i] for i in members])
                found.update(zip(members, drawn, strict=True))
        return [found[i] for i in range(len(keys))]
