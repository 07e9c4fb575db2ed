"""Which equations of a mechanism in coordinates are solved together, and in which order."""

from __future__ import annotations

from msgspec import Struct

from variantgen.algebra.expression import Value
from variantgen.algebra.normal_form import Maybe
from variantgen.algebra.values import parts
from variantgen.mechanism.solving.blocks import triangular_blocks
from variantgen.methods.coordinates.coordinate import Coordinate, PositionEquation
from variantgen.methods.coordinates.model import Model


class CoordinateBlock(Struct, frozen=True, eq=False):
    """Equations that are solved together for as many unknown coordinates."""

    equations: tuple[PositionEquation, ...]
    unknowns: tuple[Coordinate, ...]


def blocks_for(model: Model, targets: list[Value]) -> list[CoordinateBlock]:
    """The blocks that lead to the target coordinates, in the order of solution.

    Raises LookupError where the equations do not determine the coordinates.
    """
    used = [dict.fromkeys([*_depends(model, e.left), *_depends(model, e.right)]) for e in model.equations]
    unknowns = list(dict.fromkeys(value for values in used for value in values if not model.coordinates[value].given))
    number = {value: i for i, value in enumerate(unknowns)}
    depends = [{number[v] for v in values if v in number} for values in used]
    found, free, surplus = triangular_blocks(depends, len(unknowns))
    if free or surplus:
        raise LookupError([str(unknowns[u].name) for u in free] + [model.equations[e].key for e in surplus])
    return [
        CoordinateBlock(tuple(model.equations[e] for e in members), tuple(model.coordinates[unknowns[u]] for u in own))
        for members, own in _leading_to({number[v] for v in targets if v in number}, found, depends)
    ]


def _leading_to(
    wanted: set[int], blocks: list[tuple[tuple[int, ...], tuple[int, ...]]], depends: list[set[int]]
) -> list[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Blocks without those that only serve other quantities."""
    kept = []
    for members, own in reversed(blocks):
        if wanted & set(own):
            wanted |= {u for e in members for u in depends[e]}
            kept.append((members, own))
    return kept[::-1]


def _depends(model: Model, side: Maybe) -> list[Value]:
    return [] if side is None else [value for value in parts(side) if value in model.coordinates]


def given_coordinates(model: Model, blocks: list[CoordinateBlock], targets: list[Value]) -> list[Coordinate]:
    """The prescribed coordinates that the blocks or the targets contain."""
    values = [v for b in blocks for e in b.equations for side in (e.left, e.right) for v in _depends(model, side)]
    found = dict.fromkeys([*values, *targets])
    return [model.coordinates[v] for v in found if model.coordinates[v].given]
