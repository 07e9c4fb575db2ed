"""Structures of planar mechanisms: a driving crank and dyads (Assur groups of two links), each with a code of its own.

Link 0 is the frame, link 1 the crank (hinged to the frame), and the dyad number k has the links 2k and 2k + 1. A dyad
has an outer joint on an earlier link at either end and an inner joint between its own two links; its kind names them in
this order, R for a hinge and P for a sliding pair: ``RRP`` on the links 1 and 0 is the rod and the slider of a
slider-crank mechanism. All joints are simple: each connects two links. What may end a mechanism besides (a wheel that
rolls, gears, racks) is in :mod:`variantgen.synthesis.terminal`; such a group may be one link alone.

A driven mechanism falls into its dyads in one way only, so two structures are the same if one order of their growth
is; the code is the smallest of all orders.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache
from typing import NamedTuple, TypeAlias

from variantgen.errors import InputError, Problem

KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP")
ROLLING = "RRW"  # a rod and the wheel hinged to it, to which nothing else is hinged
GEAR = "WR"  # a gear alone: its pitch circle rolls (W) on a link or the frame, and it is hinged to the frame or a link
RACK = "WP"  # a rack alone, driven by a gear on a link about a fixed axis; nothing is hinged to it either
SINGLE = (GEAR, RACK)
TERMINAL = (ROLLING, *SINGLE)
SYMMETRIC = ("RRR", "RPR", "PRP")
FRAME, CRANK = 0, 1
_CODE = re.compile(r"([RPW]{2,3})(\d)(\d)")


class AssurGroup(NamedTuple):
    """Two links: the first hangs on the link ``on``, the second on the link ``to``, with the joints of its kind."""

    kind: str
    on: int
    to: int


Structure: TypeAlias = tuple[AssurGroup, ...]


def code(structure: Structure) -> str:
    """The code of a structure in its normal order: ``RRP10-RRR23``."""
    return "-".join(f"{dyad.kind}{dyad.on}{dyad.to}" for dyad in structure)


def parse_code(text: str) -> Structure:
    """The structure of a code, in its normal order. Raises InputError for what is no code."""
    found: list[AssurGroup] = []
    for part in text.split("-"):
        match = _CODE.fullmatch(part)
        dyad = AssurGroup(match[1], int(match[2]), int(match[3])) if match else None
        if dyad is None or dyad.kind not in (*KINDS, *TERMINAL) or not _fits(tuple(found), dyad):
            remedy = "dyads with the links that they hang on, as list --structures writes them: RRP10-RRR23"
            raise InputError(Problem("expected the code of a structure", key="structure", value=text, remedy=remedy))
        found.append(dyad)
    return normal(tuple(found))


def moving_links(structure: Structure) -> int:
    """How many links move: the crank, two of each dyad, and a gear or a rack."""
    return 1 + sum(1 if group.kind in SINGLE else 2 for group in structure)


def normal(structure: Structure) -> Structure:
    """The structure in its normal order: the smallest of all orders in which its dyads can be grown."""
    return min(_orders(structure, frozenset(), (), {FRAME: FRAME, CRANK: CRANK}))


def _orders(structure: Structure, done: frozenset[int], grown: Structure, names: dict[int, int]) -> Iterator[Structure]:
    """All orders of growth that go on from what is grown; ``names`` has the new number of each link known so far."""
    if len(grown) == len(structure):
        yield grown
        return
    for place, dyad in enumerate(structure):
        if place in done or dyad.on not in names or dyad.to not in names:
            continue
        links, ends = (2 * place + 2, 2 * place + 3), (names[dyad.on], names[dyad.to])
        for way in (1, -1) if dyad.kind in SYMMETRIC else (1,):
            new = dict(zip(links[::way], (len(names), len(names) + 1), strict=True))
            step = AssurGroup(dyad.kind, *ends[::way])
            yield from _orders(structure, done | {place}, (*grown, step), names | new)


def sliding_pairs(structure: Structure) -> list[tuple[int, int]]:
    """The sliding pairs of a structure, each by its two links, the earlier one first."""
    found = []
    for place, (kind, on, to) in enumerate(structure):
        first, second = 2 * place + 2, 2 * place + 3
        pairs = ((on, first), (to, first)) if kind in SINGLE else ((on, first), (first, second), (to, second))
        found += [pair for letter, pair in zip(kind, pairs, strict=True) if letter == "P"]
    return found


def _fits(structure: Structure, dyad: AssurGroup) -> bool:
    """Whether a dyad can be grown: on two links that are there; two sliding pairs in a row need links that turn."""
    count = 2 + 2 * len(structure)
    wheels = {2 * place + 3 for place, earlier in enumerate(structure) if earlier.kind == ROLLING}
    wheels |= {2 * place + i for place, earlier in enumerate(structure) if earlier.kind in SINGLE for i in (2, 3)}
    if dyad.on == dyad.to or not (0 <= dyad.on < count and 0 <= dyad.to < count) or wheels & {dyad.on, dyad.to}:
        return False
    if dyad.kind == ROLLING:
        return dyad.on != FRAME == dyad.to
    if dyad.kind in SINGLE:
        return dyad in single_groups(structure)
    return dyad.kind not in ("PRP", "RPP") or not _keep_their_angle(structure, dyad.on, dyad.to)


def single_groups(structure: Structure) -> set[AssurGroup]:
    """The gears and racks that can end a structure.

    On a link about a fixed axis (of a dyad): a gear that drives another one or a rack, or the axle of a gear that rolls
    on a fixed one. On a slider in a fixed guide: a rack that drives a gear about a fixed axis.
    """
    turning = {2 * place + 2 for place, (kind, on, _) in enumerate(structure) if kind[0] == "R" and on == FRAME}
    turning |= {2 * place + 3 for place, (kind, _, to) in enumerate(structure) if kind == "RRR" and to == FRAME}
    sliders = {2 * place + 3 for place, (kind, on, to) in enumerate(structure) if kind == "RRP" and on != FRAME == to}
    return (
        {AssurGroup(GEAR, link, FRAME) for link in turning | sliders}
        | {AssurGroup(GEAR, FRAME, link) for link in turning}
        | {AssurGroup(RACK, link, FRAME) for link in turning}
    )


def _keep_their_angle(structure: Structure, one: int, other: int) -> bool:
    """Whether two links turn alike because sliding pairs lead from one to the other."""
    alike = {one}
    pairs = sliding_pairs(structure)
    for _ in pairs:
        alike |= {link for pair in pairs if alike & set(pair) for link in pair}
    return other in alike


@cache
def structures(dyads: int, kinds: Sequence[str] = KINDS) -> tuple[Structure, ...]:
    """All structures with so many dyads of the given kinds (a tuple), each once, in the order of their codes."""
    if dyads == 0:
        return ((),)
    links = range(2 * dyads)
    found = {
        normal((*structure, dyad))
        for structure in structures(dyads - 1, kinds)
        for kind in kinds
        for on in links
        for to in links
        if _fits(structure, dyad := AssurGroup(kind, on, to)) and (kind not in SYMMETRIC or on < to)
    }
    return tuple(sorted(found))


def textbook_structures(most_links: int = 7, kinds: Sequence[str] = KINDS) -> list[Structure]:
    """The structures with up to so many moving links that a textbook would print, by their size and code."""
    sizes = range(1, (most_links - 1) // 2 + 1)
    return [s for size in sizes for s in structures(size, tuple(kinds)) if is_textbook(s)]


def is_textbook(structure: Structure) -> bool:
    """Whether a structure is fit for print.

    One output: all dyads but one drive another. Moving links have at most three joints, the frame at most four; at most
    one sliding pair is between moving links, at most two are there at all.
    """
    joints = dict.fromkeys(range(2 + 2 * len(structure)), 0) | {FRAME: 1, CRANK: 1}
    driving = set()
    for place, dyad in enumerate(structure):
        for link in (dyad.on, dyad.to):
            joints[link] += 1
            driving |= {link // 2 - 1} if link > CRANK else set()
        for link in (2 * place + 2, 2 * place + 3):
            joints[link] += 2
    slides = sliding_pairs(structure)
    return (
        len(structure) - len(driving) == 1
        and joints.pop(FRAME) <= 4
        and max(joints.values()) <= 3
        and len(slides) <= 2
        and sum(FRAME not in pair for pair in slides) <= 1
    )
