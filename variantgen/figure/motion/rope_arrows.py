"""The speeds of ropes and belts that are asked, as arrows at the middle of the straight pieces that run so."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from variantgen.algebra.name import Name
from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import MEDIUM
from variantgen.figure.motion.motion_board import MotionBoard
from variantgen.figure.symbols.rope import piece_on_paper
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rope_speed import rope_piece, rope_velocity
from variantgen.wording.solution.quantity_symbols import Symbols


class RopeSpeed(NamedTuple):
    """The velocity (m/s) of the straight piece of a rope, towards its last bend, by the stations that ask for it."""

    stations: tuple[str, str]
    speed: float


def rope_speeds(motion: Motion, index: int, asked: Sequence[Quantity]) -> list[RopeSpeed]:
    """Those that are asked of one variant of a batch, each once."""
    found = []
    for stations in dict.fromkeys((q.target, q.component) for q in asked if q.group == "rope"):
        piece = rope_piece(motion.scene, *stations)
        if piece is not None:
            speeds = np.broadcast_to(rope_velocity(motion, piece), motion.size)
            found.append(RopeSpeed(stations, float(speeds[index])))
    return found


def draw_rope_speeds(board: MotionBoard, found: Sequence[RopeSpeed], scale: float, symbols: Symbols) -> None:
    """Add their arrows (``scale`` u per m/s), beside the ropes."""
    for (first, second), speed in found:
        piece = rope_piece(board.scene, first, second)
        assert piece is not None, "the speed is that of a rope of the scene"
        start, end = piece_on_paper(board, piece.rope, piece.number)
        vector = scale * speed * (end - start) / abs(end - start)
        key = f"rope {first}{second}"
        board.sketch.at[key] = 0.5 * (start + end - vector)
        board.vector(key, vector, symbols.letter(Name("rope", first, second)), MEDIUM)
