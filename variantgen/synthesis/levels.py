"""How hard the problems of a structure are, from the structure alone."""

from __future__ import annotations

from variantgen.errors import InputError, Problem
from variantgen.synthesis.chance import Chance
from variantgen.synthesis.structures import FRAME, KINDS, Structure, sliding_pairs, textbook_structures

LEVELS = ("easy", "medium", "hard")


def level(structure: Structure) -> str:
    """Easy: one dyad. Medium: two dyads without relative motion. Hard: all others.

    Relative motion, and with it the acceleration of Coriolis, comes with a sliding pair between moving links.
    """
    relative = any(FRAME not in pair for pair in sliding_pairs(structure))
    return LEVELS[min(2, len(structure) - 1 + (relative and len(structure) > 1))]


def chosen_structures(groups: tuple[str, ...], links: int | None, wanted: str) -> list[Structure]:
    """The structures of textbooks whose dyads are of the given kinds (all where none is named).

    Each kind that is named is in them. ``links``: how many links move (None: up to five; seven if the level is hard),
    ``wanted``: the level ("" for any). Raises InputError for what is unknown, and where there is no such structure.
    """
    problems = [
        Problem("unknown dyad", key="groups", value=kind, remedy="one of " + ", ".join(KINDS))
        for kind in groups
        if kind not in KINDS
    ]
    if links is not None and links not in (3, 5, 7):
        problems.append(Problem("expected 3, 5 or 7 moving links", key="links", value=str(links)))
    if wanted and wanted not in LEVELS:
        problems.append(Problem("unknown level", key="level", value=wanted, remedy="one of " + ", ".join(LEVELS)))
    if problems:
        raise InputError(problems)
    most = links or (7 if len(groups) > 2 else 5)
    found = [
        structure
        for structure in textbook_structures(most, groups or KINDS)
        if set(groups) <= {dyad.kind for dyad in structure}
        and (links is None or 1 + 2 * len(structure) == links)
        and wanted in ("", level(structure))
    ]
    if not found:
        remedy = "variantgen list --structures  shows what there is"
        value = " ".join(filter(None, (",".join(groups), f"{links} links" if links else "", wanted)))
        raise InputError(Problem("no structure is like that", key="groups", value=value, remedy=remedy))
    return found


def any_of(groups: tuple[str, ...], links: int | None, wanted: str, seed: object) -> Structure:
    """One of the structures of :func:`chosen_structures`, by the seed. Raises InputError."""
    return Chance("structure", *groups, links, wanted, seed).choice(chosen_structures(groups, links, wanted))
