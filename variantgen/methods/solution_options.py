"""What is wished of a solution: by which methods, how much of it."""

from __future__ import annotations

from typing import Literal, get_args

from msgspec import Struct

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.method_names import check_methods

Depth = Literal["answers", "short", "full"]
DEPTHS: tuple[Depth, ...] = get_args(Depth)


class SolutionOptions(Struct, frozen=True):
    """``methods`` in the order in which they are preferred (none: the natural ones of the problem).

    ``depth``: the answers alone, a short solution without the sentences that only explain, or a full one.
    ``true_scale``: vectors in figures are all to scale, also those that are then hardly seen. Raises InputError for an
    unknown name.
    """

    methods: tuple[str, ...] = ()
    depth: Depth = "full"
    true_scale: bool = False

    def __post_init__(self) -> None:
        check_methods(self.methods)
        if self.depth not in DEPTHS:
            remedy = nearest(self.depth, DEPTHS)
            raise InputError(Problem("unknown depth of a solution", key="depth", value=self.depth, remedy=remedy))
