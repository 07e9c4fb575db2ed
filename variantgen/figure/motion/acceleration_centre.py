"""The acceleration centre Q of a body in the figure of accelerations, where it is asked for."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.quantities import Quantity
from variantgen.figure.board import Board
from variantgen.figure.drawing import THIN, Layer
from variantgen.figure.motion.centre_rays import plane_bodies
from variantgen.figure.placement.label_requests import around
from variantgen.figure.sketch import DOT
from variantgen.methods.linkage.instant import Instant
from variantgen.wording.formula import Symbol
from variantgen.wording.solution.quantity_symbols import centre_letters

_REACH = 1.15  # distance of a centre that is shown from the middle of the mechanism, in sizes of the mechanism


def draw_acceleration_centres(board: Board, now: Instant, asked: Sequence[Quantity]) -> None:
    """Add a dot with its letter, and a dashed ray from each point whose distance is asked; none where it is too far."""
    sketch = board.sketch
    low, high = sketch.corners()
    middle, size = 0.5 * (low + high), max((high - low).real, (high - low).imag)
    # The index tells bodies apart as it does with velocity centres.
    letters = centre_letters({body: board.form.symbols.get(body, body) for body in plane_bodies(now)}, ())
    indices = {body: letter.index for body, letter in letters.items()}
    drawn: set[str] = set()
    for quantity in asked:
        if quantity.kind != "Q":
            continue
        place = _centre(now, quantity.target)
        if place is None or abs(sketch.scale * place - middle) > _REACH * size:
            continue
        end = sketch.scale * place
        start = sketch.at[quantity.component]
        if abs(end - start) > DOT:
            sketch.path((start, end), Layer.GROUND, THIN, dash="dashed")
            sketch.occupy(quantity.component, end - start)
        if quantity.target not in drawn:
            drawn.add(quantity.target)
            sketch.circle(end, DOT, Layer.HINGE, fill="ink")
            index = indices.get(quantity.target, ())
            sketch.label(around(Symbol("Q", index), end, DOT))


def _centre(now: Instant, body: str) -> complex | None:
    """``z_Q = z_A + a_A / (omega^2 - i epsilon)`` (SI); None where all points have one acceleration."""
    below = now.omega[body] ** 2 - 1j * now.epsilon[body]
    point = now.scene.bodies[body][0]
    return now.z[point] + now.a[point] / below if below else None
