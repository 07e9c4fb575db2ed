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
    count = len(depends)
    if not count:
        return [], set(range(unknown_count)), set()
    owner = _matching(depends)
    partner = {e: u for u, e in owner.items()}
    free = _free_part(depends, owner, set(range(unknown_count)) - set(owner))
    surplus = _surplus_part(depends, owner, set(range(count)) - set(partner))
    if free or surplus:
        return [], free, surplus
    needs = [{owner[u] for u in unknowns} - {e} for e, unknowns in enumerate(depends)]
    return _ordered(needs, _components(needs), partner), set(), set()


def _matching(depends: Sequence[set[int]]) -> dict[int, int]:
    """A largest matching, as the equation of each matched unknown: one equation after the other takes an unknown.

    Where all of its unknowns are taken, others give way along the shortest alternating path to a free one.
    """
    owner: dict[int, int] = {}
    partner: dict[int, int] = {}
    for equation in range(len(depends)):
        reached: dict[int, int] = {}  # by unknown the equation from which the search came to it
        waiting = deque([equation])
        end: int | None = None
        while waiting and end is None:
            e = waiting.popleft()
            for u in sorted(depends[e] - reached.keys()):
                reached[u] = e
                if u not in owner:
                    end = u
                    break
                waiting.append(owner[u])
        while end is not None:
            e = reached[end]
            owner[end], partner[e], end = e, end, partner.get(e)
    return owner


def _components(needs: Sequence[set[int]]) -> list[int]:
    """The strongly connected components: by equation the first one that needs it and that it needs, however far."""
    reachable = [_reachable(needs, e) for e in range(len(needs))]
    return [min(f for f in own if e in reachable[f]) for e, own in enumerate(reachable)]


def _reachable(needs: Sequence[set[int]], start: int) -> set[int]:
    """An equation and all that it needs."""
    found, waiting = {start}, [start]
    while waiting:
        new = needs[waiting.pop()] - found
        found |= new
        waiting += new
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


def indeterminate(free: Sequence[str], surplus: Sequence[str], remedies: Sequence[str] = ()) -> list[Problem]:
    """The error for a scene whose equations do not determine its motion, naming the parts that are free or surplus.

    ``remedies`` are what the surplus joints propose to write in their places.
    """
    problems = []
    if free:
        problems.append(
            Problem(
                "the motion is not determined: more unknowns than equations",
                key="scene",
                value=", ".join(free),
                remedy=_fixing(free),
            )
        )
    if surplus:
        problems.append(
            Problem(
                "joints or drivers repeat or contradict each other: more equations than unknowns",
                key="scene",
                value=", ".join(dict.fromkeys(surplus)),
                remedy="; or: ".join(dict.fromkeys(remedies)) or "remove one of these",
            )
        )
    return problems


def _fixing(free: Sequence[str]) -> str:
    """What fixes unknowns that nothing determines, by their names."""
    bodies = [name.removeprefix("omega of ") for name in free if name.startswith("omega of ")]
    text = "add a driver or a joint that fixes one of these"
    if len(bodies) == 1 and not any(name.startswith("velocity of ") for name in free):
        text += (
            f": nothing turns {bodies[0]}; a wheel rolls (rolling), meshes (gears) or has a rope on it, any body can be"
            " driven (rotation) or kept from turning (translation)"
        )
    lost = sorted({name.split()[2] for name in free if name.startswith("velocity of ")})
    if lost and len(free) == 2 * len(lost):  # both directions of each
        text += (
            f": {', '.join(lost)} may go anywhere; a travel alone leads no point along a line, a guide or a slot does"
        )
    return text
