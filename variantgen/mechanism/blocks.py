"""Block-triangular form of a sparse system, from its structure alone."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

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
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import connected_components, maximum_bipartite_matching

    count = len(depends)
    if not count:
        return [], set(range(unknown_count)), set()
    pairs = [(e, u) for e, unknowns in enumerate(depends) for u in sorted(unknowns)]
    rows, columns = (np.array(side, dtype=np.int32) for side in zip(*pairs, strict=True))
    graph = csr_array((np.ones(len(pairs)), (rows, columns)), shape=(count, max(unknown_count, 1)))
    partner = maximum_bipartite_matching(graph, perm_type="column")
    owner = {int(u): e for e, u in enumerate(partner) if u >= 0}
    free = _free_part(depends, owner, set(range(unknown_count)) - set(owner))
    surplus = _surplus_part(depends, owner, {e for e in range(count) if partner[e] < 0})
    if free or surplus:
        return [], free, surplus
    needs = [{owner[u] for u in unknowns} - {e} for e, unknowns in enumerate(depends)]
    edges = [(e, f) for e, others in enumerate(needs) for f in sorted(others)]
    matrix = np.zeros((count, count))
    for e, f in edges:
        matrix[e, f] = 1.0
    _, component = connected_components(csr_array(matrix), directed=True, connection="strong")
    return _ordered(needs, [int(c) for c in component], [int(u) for u in partner]), set(), set()


def _ordered(
    needs: Sequence[set[int]], component: Sequence[int], partner: Sequence[int]
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
