"""The methods for groups of links, among which a solution chooses: the table in which a new one is entered."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from msgspec import Struct, field

from variantgen.methods.groups.group import Dyad, ThirdClassGroup, TwoPointBody
from variantgen.methods.on_demand import on_demand
from variantgen.methods.solution.book import Book

Applies = Callable[[Book, Any], bool]
Solve = Callable[[Book, Any], None]


class GroupMethod(Struct, frozen=True):
    """A method for groups of links.

    ``orders``: whether it is chosen for velocities (1) or accelerations (2), or neither, where nothing takes its place.
    ``sentences``: how the keys of its sentences begin. ``solvers``: the groups that it solves by an equation of its own
    where that applies; all others are solved by vector equations. ``carry`` finds a further point of a body whose rate
    is known; without it that is done by a vector equation, too.
    """

    orders: tuple[int, ...]
    sentences: tuple[str, ...] = ()
    solvers: Mapping[type, tuple[Applies, Solve]] = field(default_factory=dict)
    carry: Callable[[Book, str, str, str], None] | None = None


GROUP_METHODS: dict[str, GroupMethod] = {
    "velocity_centre": GroupMethod(
        (1,),
        ("velocity_centre.", "contact.wheel", "known_centre."),
        {
            Dyad: (on_demand("centres.velocity_centre", "applies"), on_demand("centres.velocity_centre", "solve_dyad")),
            ThirdClassGroup: (on_demand("centres.guided_body", "applies"), on_demand("centres.guided_body", "solve")),
            TwoPointBody: (
                on_demand("centres.known_centre", "is_divided"),
                on_demand("centres.known_centre", "solve_divided"),
            ),
        },
        on_demand("centres.velocity_centre", "carry"),
    ),
    "projections": GroupMethod(
        (1,),
        ("projections.",),
        {Dyad: (on_demand("centres.projections", "applies"), on_demand("centres.projections", "solve_dyad"))},
        on_demand("centres.velocity_centre", "carry"),
    ),
    "velocity_pole": GroupMethod((1,), ("pole.choose_v", "pole.crossing_v", "points.sum_v")),
    "acceleration_pole": GroupMethod((2,), ("pole.choose_a", "pole.crossing_a", "points.sum_a", "points.sum_wheel")),
    "acceleration_centre": GroupMethod(
        (2,), ("acceleration_centre.",), carry=on_demand("centres.acceleration_centre", "carry")
    ),
    "relative_motion": GroupMethod((), ("relative.",)),
    # The groups of the method for whole problems (three_rates.py), which has sentences of its own.
    "three_rates": GroupMethod(
        (1, 2),
        (),
        {Dyad: (on_demand("by_groups.closed_chain", "applies"), on_demand("by_groups.closed_chain", "solve_dyad"))},
    ),
}
