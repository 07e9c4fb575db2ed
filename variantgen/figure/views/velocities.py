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
from variantgen.figure.cylinder_vectors import cylinder_velocities
from variantgen.figure.drawing import MEDIUM, Drawing
from variantgen.figure.given_vectors import distinct_points, given_rates, given_vectors, transport_name
from variantgen.figure.motion_board import NOTHING, MotionBoard, draw_on_mechanism, named_together, scale_of
from variantgen.figure.motion_data import MotionData, motion_data
from variantgen.mechanism.motion import Motion
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import absolute, compound_part, relative_to_pole

ORDER = 1
_NOTHING = 1e-9  # of the largest rate


def draw(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language) -> Drawing:
    """The figure of one variant. Raises InputError where nothing moves."""
    found = motion_data(variant, motion, index, asked, ORDER)
    annotate = partial(_annotate, found, language)
    return draw_on_mechanism(variant, motion, index, asked, language, annotate)


def _annotate(found: MotionData, language: Language, board: MotionBoard, stretch: float) -> None:
    """Velocities, then centres, then arcs where there is room left."""
    now, task = found.now, found.task
    parts = compound_velocities(found, language) | cylinder_velocities(board, found, language)
    stated = given_vectors(task, found.chain, ORDER, language)
    points = distinct_points(task, found.chain, [name for name in board.shown if name in found.chain.points])
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
    rates = given_rates(task, ORDER, language)
    for body, rate in now.omega.items():
        if abs(rate) > _NOTHING * fastest:
            board.turn(body, rate, "omega", rates.get(body))


def compound_velocities(found: MotionData, language: Language) -> dict[str, list[tuple[Symbol, complex]]]:
    """What the velocities (m/s) of the points that slide on bodies are put together from.

    The transport velocity is that of a pole and of the rotation about it, where the pole moves.
    """
    now, chain = found.now, found.chain
    stated = given_vectors(found.task, chain, ORDER, language)
    parts: dict[str, list[tuple[Symbol, complex]]] = {}
    for sliding_point in chain.sliding_points:
        point, pole = sliding_point.point, sliding_point.pole
        transport = now.transport_velocity(point, sliding_point.body)
        leading_point = transport_name(found.task, chain, sliding_point, "v", stated)
        named = parts.setdefault(point, [])
        if leading_point is None and pole is not None and pole not in chain.resting:
            named.append((stated.get(pole, absolute("v", pole)), now.v[pole]))
            named.append((relative_to_pole("v", point, pole), transport - now.v[pole]))
        else:
            named.append((leading_point or compound_part("v", "tr", point, language), transport))
        named.append((compound_part("v", "rel", point, language), now.v[point] - transport))
    return parts
