"""Block-triangular form of a sparse system, from its structure alone."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence

from variantgen.errors import Problem


def triangular_blocks(
    depends: Sequence[set[int]], unknown_count: int
) -> tuple[list[tuple[tuple[int, ...], tuple[int, ...]]], set[int], set[int]]:
    """Blocks (equations, unknowns) in the order of solution, and what is free and what is surplus.

    ``depends[e]`` holds the unknowns of equation e. A maximum matching pairs equations with unknowns; the strongly
    connected components of "equation e needs the unknown paired with equation f" are the blocks (the fine
    Dulmage-Mendelsohn decomposition of a square system). If the matching is not perfect, ``free`` holds the unknowns
    of the under-determined part and ``surplus`` the equations of the over-determined part, and there are no blocks.
    """
    partner = _matching(depends)
    owner = {u: e for e, u in partner.items()}
    free = _free_part(depends, owner, set(range(unknown_count)) - set(owner))
    surplus = _surplus_part(depends, owner, set(range(len(depends))) - set(partner))
    if free or surplus:
        return [], free, surplus
    needs = [{owner[u] for u in unknowns} - {e} for e, unknowns in enumerate(depends)]
    return _ordered(needs, _components(needs), partner), set(), set()


# Systems have some tens of equations: to load a library for this would take longer than anything else at the start of
# the program.


def _matching(depends: Sequence[set[int]]) -> dict[int, int]:
    """As many pairs of an equation and an unknown of it as there can be, by alternating paths; unknowns by equation."""
    partner: dict[int, int] = {}
    owner: dict[int, int] = {}
    for first in range(len(depends)):
        found: dict[int, int] = {}  # the equation from which a path reaches each unknown
        front = deque([first])
        end = None
        while front and end is None:
            e = front.popleft()
            for u in sorted(depends[e] - found.keys()):
                found[u] = e
                if u not in owner:
                    end = u
                    break
                front.append(owner[u])
        while end is not None:
            e = found[end]
            before = partner.get(e)
            partner[e], owner[end] = end, e
            end = before
    return partner


def _components(needs: Sequence[set[int]]) -> list[int]:
    """The strongly connected component of each equation, by its first equation."""
    reached = [_reached(needs, e) for e in range(len(needs))]
    return [min(f for f in found if e in reached[f]) for e, found in enumerate(reached)]


def _reached(needs: Sequence[set[int]], start: int) -> set[int]:
    """The equations that one needs, directly or through others, and itself."""
    found, front = {start}, {start}
    while front:
        front = set().union(*(needs[e] for e in front)) - found
        found |= front
    return found


def _ordered(
    needs: Sequence[set[int]], component: Sequence[int], partner: Mapping[int, int]
) -> list[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Components in an order in which each needs only earlier ones; ties by the number of the equation."""
    members: dict[int, list[int]] = {}
    for e, c in enumerate(component):
        members.setdefault(c, []).append(e)
    done: set[int] = set()
    blocks = []
    waiting = list(members.values())
    while waiting:
        ready = next(group for group in waiting if all(f in done or f in group for e in group for f in needs[e]))
        waiting.remove(ready)
        done.update(ready)
        blocks.append((tuple(ready), tuple(sorted(partner[e] for e in ready))))
    return blocks


def _free_part(depends: Sequence[set[int]], owner: dict[int, int], start: set[int]) -> set[int]:
    """Unknowns reachable from unmatched ones by alternating paths."""
    found, front = set(start), set(start)
    while front:
        touched = {e for e, unknowns in enumerate(depends) if unknowns & front}
        front = {u for u, e in owner.items() if e in touched} - found
        found |= front
    return found


def _surplus_part(depends: Sequence[set[int]], owner: dict[int, int], start: set[int]) -> set[int]:
    """Equations reachable from unmatched ones by alternating paths."""
    found, front = set(start), set(start)
    while front:
        unknowns = set().union(*(depends[e] for e in front))
        front = {owner[u] for u in unknowns if u in owner} - found
        found |= front
    return found


def indeterminate(free: Sequence[str], surplus: Sequence[str]) -> list[Problem]:
    """What to tell the author of a scene whose equations do not determine its motion, by the names of the parts."""
    problems = []
    if free:
        problems.append(
            Problem(
                "the motion is not determined: more unknowns than equations",
                key="scene",
                value=", ".join(free),
                remedy="add a driver or a joint that fixes one of these",
            )
        )
    if surplus:
        problems.append(
            Problem(
                "joints or drivers repeat or contradict each other: more equations than unknowns",
                key="scene",
                value=", ".join(dict.fromkeys(surplus)),
                remedy="remove one of these",
            )
        )
    return problems
