"""The figure of velocities: the mechanism with all velocities to one scale, true senses of rotation, velocity centres.

The velocity centre P of a body is where the dashed perpendiculars to the velocities of its points meet; one that is
too far away is not shown, then short rays show the way to it. Vectors bear the names that the solution gives to them.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from variantgen.families.quantities import Quantity
from variantgen.figure.centre_rays import draw_centres
from variantgen.figure.contact_letters import contacts, draw_contacts
from variantgen.figure.drawing import MEDIUM, Drawing
from variantgen.figure.growing import growing_velocities
from variantgen.figure.motion_board import NOTHING, MotionBoard, draw_on_mechanism, named_together, scale_of
from variantgen.figure.solved import Solved, solved
from variantgen.figure.stated import stated_rates, stated_vectors, telling_points, transport_name
from variantgen.mechanism.motion import Motion
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import about, absolute, compound

ORDER = 1
_NOTHING = 1e-9  # of the largest rate


def draw(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language) -> Drawing:
    """The figure of one variant. Raises InputError where nothing moves."""
    found = solved(variant, motion, index, asked, ORDER)
    annotate = partial(_annotate, found, language)
    return draw_on_mechanism(variant, motion, index, asked, language, annotate)


def _annotate(found: Solved, language: Language, board: MotionBoard, stretch: float) -> None:
    """Velocities, then centres, then arcs where there is room left."""
    now, task = found.now, found.task
    parts = compound_velocities(found, language) | growing_velocities(board, found, language)
    stated = stated_vectors(task, found.chain, ORDER, language)
    points = telling_points(task, found.chain, [name for name in board.shown if name in found.chain.points])
    touching = contacts(board, task, now)
    shown = [*(now.v[name] for name in points), *(v for named in parts.values() for _, v in named)]
    scale = stretch * scale_of([*shown, *(contact.velocity for contact in touching.values())])
    straight = set()
    for name in points:
        own = stated.get(name, absolute("v", name)), now.v[name]
        vectors = named_together([own, *parts.get(name, [])], scale)
        for i, (symbol, vector) in enumerate(vectors):
            whole = i == 0 and abs(vector - now.v[name]) * scale < NOTHING
            if board.vector(name, scale * vector, symbol, *(() if whole else (MEDIUM,))) and whole:
                straight.add(name)
    draw_contacts(board, touching, scale)
    draw_centres(board, now, points, straight)
    fastest = max((abs(rate) for rate in now.omega.values()), default=0.0)
    rates = stated_rates(task, ORDER, language)
    for body, rate in now.omega.items():
        if abs(rate) > _NOTHING * fastest:
            board.turn(body, rate, "omega", rates.get(body))


def compound_velocities(found: Solved, language: Language) -> dict[str, list[tuple[Symbol, complex]]]:
    """What the velocities (m/s) of the points that slide on bodies are put together from.

    The transport velocity is that of a pole and of the rotation about it, where the pole moves.
    """
    now, chain = found.now, found.chain
    stated = stated_vectors(found.task, chain, ORDER, language)
    parts: dict[str, list[tuple[Symbol, complex]]] = {}
    for slip in chain.slips:
        point, pole = slip.point, slip.pole
        transport = now.transport_velocity(point, slip.body)
        lead = transport_name(found.task, chain, slip, "v", stated)
        named = parts.setdefault(point, [])
        if lead is None and pole is not None and pole not in chain.resting:
            named.append((stated.get(pole, absolute("v", pole)), now.v[pole]))
            named.append((about("v", point, pole), transport - now.v[pole]))
        else:
            named.append((lead or compound("v", "tr", point, language), transport))
        named.append((compound("v", "rel", point, language), now.v[point] - transport))
    return parts
