"""The figure of velocities: the mechanism with all velocities to one scale, true senses of rotation, velocity centres.

The velocity centre P of a body is where the dashed perpendiculars to the velocities of its points meet; one that is
too far away is not shown, then short rays show the way to it.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from variantgen.families.quantities import Quantity
from variantgen.figure.centre_rays import draw_centres
from variantgen.figure.contact_letters import contacts_of, draw_contacts
from variantgen.figure.drawing import MEDIUM, Drawing
from variantgen.figure.growing import growing_velocities
from variantgen.figure.motion_board import LEAST, MotionBoard, draw_on_mechanism, named_together, scale_of
from variantgen.figure.solved import Solved, solved
from variantgen.mechanism.motion import Motion
from variantgen.methods.task import Task, task_of
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import absolute, compound

ORDER = 1
_NOTHING = 1e-9  # of the largest rate


def draw(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language) -> Drawing:
    """The figure of one variant. Raises InputError where nothing moves."""
    found = solved(variant, motion, index, asked, ORDER)
    task = task_of(variant, motion, index, asked)
    annotate = partial(_annotate, found, task, language)
    return draw_on_mechanism(variant, motion, index, asked, language, annotate)


def _annotate(found: Solved, task: Task, language: Language, board: MotionBoard, stretch: float) -> None:
    """Velocities, then centres, then arcs where there is room left."""
    now = found.now
    parts = compound_velocities(found, language) | growing_velocities(board, found, language)
    points = [name for name in board.shown if name in now.v]
    contacts = contacts_of(board, task)
    vectors = [*(now.v[name] for name in points), *(contact.velocity for contact in contacts)]
    scale = stretch * scale_of([*vectors, *(v for named in parts.values() for _, v in named)])
    straight = set()
    for name in points:
        arrows = named_together([(absolute("v", name), now.v[name]), *parts.get(name, [])], scale)
        for i, (symbol, vector) in enumerate(arrows):
            whole = i == 0 and abs(vector - now.v[name]) * scale < LEAST
            if board.vector(name, scale * vector, symbol, *(() if whole else (MEDIUM,))) and whole:
                straight.add(name)
    draw_centres(board, now, straight)
    draw_contacts(board, contacts, scale)
    fastest = max((abs(rate) for rate in now.omega.values()), default=0.0)
    for body, rate in now.omega.items():
        if abs(rate) > _NOTHING * fastest:
            board.turn(body, rate, "omega")


def compound_velocities(found: Solved, language: Language) -> dict[str, list[tuple[Symbol, complex]]]:
    """Transport and relative velocities (m/s) of the points that slide on bodies."""
    parts: dict[str, list[tuple[Symbol, complex]]] = {}
    for slip in found.chain.slips:
        transport = found.now.transport_velocity(slip.point, slip.body)
        named = parts.setdefault(slip.point, [])
        named.append((compound("v", "tr", slip.point, language), transport))
        named.append((compound("v", "rel", slip.point, language), found.now.v[slip.point] - transport))
    return parts
