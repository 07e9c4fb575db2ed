"""How hard the problems of a structure are, from the structure alone."""

from __future__ import annotations

from variantgen.errors import InputError, Problem
from variantgen.synthesis.structures import (
    FRAME,
    KINDS,
    ROLLING,
    SINGLE,
    TERMINAL,
    Structure,
    moving_links,
    sliding_pairs,
    textbook_structures,
)
from variantgen.synthesis.terminal import geared_structures, rolling_structures

LEVELS = ("easy", "medium", "hard")


def level(structure: Structure) -> str:
    """What problems of a structure mostly are, with accelerations: easy with one dyad, hard with three.

    With two they are hard where the second one hangs on two moving links, or where there is relative motion; else
    medium; a gear or a rack at the end does not matter. What a family takes in calculations is known when it is made.
    """
    dyads = [group for group in structure if group.kind not in SINGLE]
    if len(dyads) != 2:
        return "easy" if len(dyads) < 2 else "hard"
    relative = any(FRAME not in pair for pair in sliding_pairs(structure))
    return "hard" if relative or FRAME not in (dyads[1].on, dyads[1].to) else "medium"


def _known_groups(kind: str) -> str:
    """What may be named in the place of an unknown kind, which may be one with its links, as in codes."""
    known = (*KINDS, *TERMINAL)
    if kind.rstrip("0123456789") in known:
        return "leave out the digits; compose --structure RRR01-WR02 takes the links that groups hang on"
    return "one of " + ", ".join(known)


def chosen_structures(groups: tuple[str, ...], links: int | None) -> list[Structure]:
    """The structures of textbooks whose dyads are of the given kinds (all where none is named).

    Each kind that is named is in them. ``links``: how many links move (None: up to five, up to seven where three kinds
    are named). Raises InputError for what is unknown, and where there is no such structure.
    """
    problems = [
        Problem("unknown group", key="groups", value=kind, remedy=_known_groups(kind))
        for kind in groups
        if kind not in (*KINDS, *TERMINAL)
    ]
    single = bool(set(groups) & set(SINGLE))
    sizes = (4, 6) if single else (3, 5, 7)
    if links is not None and links not in sizes:
        said = "4 or 6 moving links, one of them the gear or rack" if single else "3, 5 or 7 moving links"
        ended = f"name one of {', '.join(SINGLE)} in groups as well for 4 or 6"
        problems.append(Problem(f"expected {said}", key="links", value=str(links), remedy="" if single else ended))
    if problems:
        raise InputError(problems)
    most = links or (7 if len(groups) > 2 else 5)
    known = textbook_structures(most, groups or KINDS)
    if ROLLING in groups:  # the rolling wheel takes the place of a slider
        known = rolling_structures(most, tuple(dict.fromkeys(["RRP", *groups])) if len(groups) > 1 else KINDS)
    if single:
        others = tuple(kind for kind in groups if kind not in SINGLE)
        known = geared_structures(links or (6 if len(others) > 1 else 4), others or KINDS)
    found = [
        structure
        for structure in known
        if set(groups) <= {dyad.kind for dyad in structure} and (links is None or moving_links(structure) == links)
    ]
    if not found:
        remedy = "variantgen list --structures  shows what there is"
        value = " ".join(filter(None, (",".join(groups), f"{links} links" if links else "")))
        raise InputError(Problem("no structure is like that", key="groups", value=value, remedy=remedy))
    return found
