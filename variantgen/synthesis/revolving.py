"""Which links of a mechanism turn full circle and which only swing: what they are called in its statement.

Hand formulas are applied to every draw of a family. A link about a fixed axis that a rod drives from another such link
is in a four-bar of its own, whatever else hangs there; where it cannot turn in that one, it cannot turn at all. The
driving link is a crank where every group hangs on its end and formulas say that it turns. All others are called links.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from variantgen.mechanism.motion import ComplexField, Field
from variantgen.synthesis.draft import CRANK, Draft, Facts
from variantgen.synthesis.gears import SENTENCES as GEARS

_IN_LINE = 1e-9  # m: a linkage that can be stretched into one line may turn, so its links are no rockers


def four_bar_turns(link: Field, rod: Field, other: Field, frame: Field, slack: float = 0.0) -> NDArray[np.bool_]:
    """Whether the first of two links about fixed axes turns full circle in a four-bar with these lengths.

    Grashof: the shortest and the longest together are shorter than the other two together, and the shortest is this
    link or the frame. A linkage that can be stretched into one line does not count unless it has a ``slack`` (m).
    All lengths (m) and the result have the shape (N,).
    """
    lengths = np.stack([link, rod, other, frame])
    shortest, longest = np.min(lengths, axis=0), np.max(lengths, axis=0)
    goes = shortest + longest < 0.5 * np.sum(lengths, axis=0) + slack
    return np.asarray(goes & (np.minimum(link, frame) <= shortest + slack))


def slider_crank_turns(crank: Field, rod: Field, offset: Field) -> NDArray[np.bool_]:
    """Whether a crank turns full circle: its rod is longer than crank and offset together. Shape (N,)."""
    return np.asarray(crank + np.abs(offset) < rod)


def called(draft: Draft, z: Mapping[str, ComplexField]) -> dict[str, str]:
    """The links that are a "crank" or a "rocker" on all draws, by their bodies; ``z``: places of points, shape (N,)."""
    found = {
        facts["rocker"]: "rocker"
        for key, facts in draft.sentences
        if key == "rod_and_rocker" and _swings(draft, z, facts)
    }
    if _driver_turns(draft, z):
        found[CRANK] = "crank"
    return found


def _swings(draft: Draft, z: Mapping[str, ComplexField], facts: Facts) -> bool:
    """Whether a link cannot turn full circle on any draw, because of the link about a fixed axis that drives it."""
    axis = next((name for name in draft.pivots if name in draft.bodies.get(facts.get("at_link", ""), ())), None)
    if axis is None:
        return False
    start, end, pivot = facts["at_point"], facts["joint"], facts["pivot"]
    link, rod, other, frame = (
        np.abs(z[b] - z[a]) for a, b in ((pivot, end), (start, end), (axis, start), (axis, pivot))
    )
    return not np.any(four_bar_turns(link, rod, other, frame, slack=_IN_LINE))


def _driver_turns(draft: Draft, z: Mapping[str, ComplexField]) -> bool:
    """Whether formulas say of every group that it lets the driving link turn full circle on all draws."""
    return all(_lets_turn(draft, z, key, facts) for key, facts in draft.sentences)


def _lets_turn(draft: Draft, z: Mapping[str, ComplexField], key: str, facts: Facts) -> bool:
    """Whether a group at the end of the driving link lets it turn; of others nothing is known."""
    if facts.get("at_point") != "A":
        return key in GEARS  # which keep no link from turning; racks are as long as need be
    crank = np.abs(z["A"] - z["O"])
    if key == "rod_and_rocker":
        pivot, end = facts["pivot"], facts["joint"]
        rod, other, frame = (np.abs(z[b] - z[a]) for a, b in (("A", end), (pivot, end), ("O", pivot)))
        return bool(np.all(four_bar_turns(crank, rod, other, frame)))
    if key in ("rod_and_slider", "rod_and_slider_through"):
        way = z[facts["slider"]] - z["O"]
        offset = way.imag if facts["way"] == "level" else way.real
        return bool(np.all(slider_crank_turns(crank, np.abs(z[facts["slider"]] - z["A"]), offset)))
    return key in ("slotted_arm", "yoke")  # their slots are as long as need be
