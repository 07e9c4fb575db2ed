"""The scale of velocity and acceleration plans: a round one, the same in the solution and in the printed figure.

A plan is drawn so that one millimetre of the sheet stands for 1, 1.5, 2, 2.5, 4, 5 or 7.5 times a power of ten of
cm/s (or whatever the printed unit is). Then a ruler on the page gives the numbers of the text.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from decimal import Decimal
from itertools import accumulate

from variantgen.methods.graphical.vector_chain import VectorChain, taken_apart
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.steps.not_applicable import NotApplicableError

MILLIMETRES = 0.8  # on paper, of one figure unit, where the paper does not ask for less
ROOM = (64.0, 56.0)  # for a plan without its letters, width and height, mm
_STEPS = tuple(Decimal(step) for step in ("1", "1.5", "2", "2.5", "4", "5", "7.5", "10"))
_SLACK = 1e-9  # of the room: rounding decides nothing


def per_millimetre(places: Sequence[complex], room: tuple[float, float] = ROOM) -> Decimal:
    """The value of one millimetre: the finest round scale at which all places find room (mm).

    Raises NotApplicableError where all places are one: nothing of a plan is drawn.
    """
    x, y = [place.real for place in places], [place.imag for place in places]
    least = max((max(x) - min(x)) / room[0], (max(y) - min(y)) / room[1]) * (1 - _SLACK)
    if not least:
        raise NotApplicableError("a plan of one point has no scale")
    power = Decimal(10) ** math.floor(math.log10(least))
    return next(step * power for step in _STEPS if float(step * power) >= least).normalize()


def places_of(chain: VectorChain, now: Instant, order: int) -> list[complex]:
    """All ends of vectors of the plan of velocities (``order`` 1) or accelerations (2), and its pole."""
    return [0j, *(_velocities(chain, now) if order == 1 else _accelerations(chain, now))]


def _velocities(chain: VectorChain, now: Instant) -> list[complex]:
    poles = [turn.pole for turn in chain.turns] + [
        sliding_point.pole for sliding_point in chain.sliding_points if sliding_point.pole is not None
    ]
    ends = [now.v[point] for point in (*chain.points, *poles)]
    ends += [now.v[cylinder.base] + now.growth(cylinder.point, cylinder.base)[0] for cylinder in chain.cylinders]
    return ends + [
        now.transport_velocity(sliding_point.point, sliding_point.body) for sliding_point in chain.sliding_points
    ]


def _accelerations(chain: VectorChain, now: Instant) -> list[complex]:
    """Ends of accelerations and of their components, one after the other as in the chains of the plan."""
    poles = [turn.pole for turn in chain.turns] + [
        sliding_point.pole for sliding_point in chain.sliding_points if sliding_point.pole is not None
    ]
    ends = [now.a[point] for point in (*chain.points, *poles)]
    apart = taken_apart(chain)
    for turn in chain.turns:
        if (turn.body, turn.point) in apart:
            ends.append(now.a[turn.pole] + now.normal(turn.point, turn.pole))
    for cylinder in chain.cylinders:
        steps = now.growing_acceleration(cylinder.point, cylinder.base)
        ends += accumulate(steps, initial=now.a[cylinder.base])
    for sliding_point in chain.sliding_points:
        transport, coriolis = (
            now.transport_acceleration(sliding_point.point, sliding_point.body),
            now.coriolis(sliding_point.point, sliding_point.body),
        )
        if sliding_point.pole is not None and (sliding_point.body, sliding_point.point) in apart:
            arm = now.z[sliding_point.point] - now.z[sliding_point.pole]
            ends.append(now.a[sliding_point.pole] - now.omega[sliding_point.body] ** 2 * arm)
        start = transport + coriolis if sliding_point.carried else transport
        speed = now.v[sliding_point.point] - now.transport_velocity(sliding_point.point, sliding_point.body)
        relative = now.relative_acceleration(sliding_point.point, sliding_point.body)
        normal = complex(sliding_point.path.curvature(now.z)) * abs(speed) ** 2
        ends += [transport, start, start + relative, start + (normal if sliding_point.carried else relative - normal)]
    return ends


def pole_letter(moving: Collection[str]) -> str:
    """The letter of the pole of a velocity plan: o, or another one where a moving point is called so."""
    return next(letter for letter in "opqw" if letter.upper() not in moving or letter == "w")
