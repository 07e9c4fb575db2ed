"""Structures with something else than a dyad at the end: a wheel that rolls, a gear, a rack.

``RRW``: a wheel that rolls on the frame takes the place of a slider in a fixed guide. ``WR``: a gear alone, about a
fixed axis and in mesh with a gear on a link about another one (``WR20``) or with a rack on a slider (``WR30``); or on
an axle that such a link carries round a fixed gear (``WR02``). ``WP``: a rack alone, driven by a gear on a link.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from variantgen.synthesis.structures import (
    FRAME,
    KINDS,
    ROLLING,
    AssurGroup,
    Structure,
    is_textbook,
    normal,
    single_groups,
    textbook_structures,
)


def rolling_structures(most_links: int = 7, kinds: Sequence[str] = KINDS) -> list[Structure]:
    """The structures of textbooks in which the last slider on the frame is a rolling wheel, by their size and code."""
    found = set()
    for structure in textbook_structures(most_links, kinds):
        used = {link for dyad in structure for link in (dyad.on, dyad.to)}
        for place, dyad in enumerate(structure):
            if dyad.kind == "RRP" and dyad.on != FRAME == dyad.to and not used & {2 * place + 2, 2 * place + 3}:
                wheel = AssurGroup(ROLLING, dyad.on, FRAME)
                found.add(normal((*structure[:place], wheel, *structure[place + 1 :])))
    return _ordered(found)


def geared_structures(most_links: int = 6, kinds: Sequence[str] = KINDS) -> list[Structure]:
    """The structures of textbooks with a gear or a rack at the end, by their size and code; ``kinds``: of the dyads."""
    found = {
        normal((*structure, group))
        for structure in textbook_structures(min(most_links - 1, 5), kinds)
        for group in single_groups(structure)
        if is_textbook((*structure, group))
    }
    return _ordered(found)


def _ordered(found: Iterable[Structure]) -> list[Structure]:
    return sorted(found, key=lambda structure: (len(structure), structure))
