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

MILLIMETRES = 0.8  # on paper, of one figure unit, where the paper does not ask for less
ROOM = (64.0, 56.0)  # for a plan without its letters, width and height, mm
_STEPS = tuple(Decimal(step) for step in ("1", "1.5", "2", "2.5", "4", "5", "7.5", "10"))
_SLACK = 1e-9  # of the room: rounding decides nothing


def per_millimetre(places: Sequence[complex], room: tuple[float, float] = ROOM) -> Decimal:
    """How much one millimetre stands for: the finest round scale at which all places find room (mm)."""
    x, y = [place.real for place in places], [place.imag for place in places]
    least = max((max(x) - min(x)) / room[0], (max(y) - min(y)) / room[1]) * (1 - _SLACK)
    power = Decimal(10) ** math.floor(math.log10(least))
    return next(step * power for step in _STEPS if float(step * power) >= least).normalize()


def places_of(chain: VectorChain, now: Instant, order: int) -> list[complex]:
    """All ends of vectors of the plan of velocities (``order`` 1) or accelerations (2), and its pole."""
    return [0j, *(_velocities(chain, now) if order == 1 else _accelerations(chain, now))]


def _velocities(chain: VectorChain, now: Instant) -> list[complex]:
    poles = [turn.pole for turn in chain.turns] + [slip.pole for slip in chain.slips if slip.pole is not None]
    ends = [now.v[point] for point in (*chain.points, *poles)]
    ends += [now.v[reach.base] + now.growth(reach.point, reach.base)[0] for reach in chain.reaches]
    return ends + [now.transport_velocity(slip.point, slip.body) for slip in chain.slips]


def _accelerations(chain: VectorChain, now: Instant) -> list[complex]:
    """Ends of accelerations and of their components, one after the other as in the chains of the plan."""
    poles = [turn.pole for turn in chain.turns] + [slip.pole for slip in chain.slips if slip.pole is not None]
    ends = [now.a[point] for point in (*chain.points, *poles)]
    apart = taken_apart(chain)
    for turn in chain.turns:
        if (turn.body, turn.point) in apart:
            ends.append(now.a[turn.pole] + now.normal(turn.point, turn.pole))
    for reach in chain.reaches:
        steps = now.growing_acceleration(reach.point, reach.base)
        ends += accumulate(steps, initial=now.a[reach.base])
    for slip in chain.slips:
        transport, coriolis = (
            now.transport_acceleration(slip.point, slip.body),
            now.coriolis(slip.point, slip.body),
        )
        if slip.pole is not None and (slip.body, slip.point) in apart:
            arm = now.z[slip.point] - now.z[slip.pole]
            ends.append(now.a[slip.pole] - now.omega[slip.body] ** 2 * arm)
        start = transport + coriolis if slip.carried else transport
        speed = now.v[slip.point] - now.transport_velocity(slip.point, slip.body)
        relative = now.relative_acceleration(slip.point, slip.body)
        normal = complex(slip.path.curvature(now.z)) * abs(speed) ** 2
        ends += [transport, start, start + relative, start + (normal if slip.carried else relative - normal)]
    return ends


def pole_letter(moving: Collection[str]) -> str:
    """The letter of the pole of a velocity plan: o, or another one where a moving point is called so."""
    return next(letter for letter in "opqw" if letter.upper() not in moving or letter == "w")
