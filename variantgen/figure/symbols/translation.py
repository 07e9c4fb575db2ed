"""Non-rotating body: no symbol of its own; the statement says so."""

from __future__ import annotations

from variantgen.figure.board import Board
from variantgen.mechanism.joints.translation import Translation


def draw(board: Board, joint: Translation) -> None:
    """Nothing is drawn."""
