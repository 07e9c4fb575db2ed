"""Wheels on circles: outside or inside, fixed or part of a body."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.telling.teller import Teller
from variantgen.mechanism.joints.rolling_on_circle import RollingOnCircle


def tell(teller: Teller, items: Sequence[RollingOnCircle]) -> list[str]:
    """A clause for each circle."""
    return [_clause(teller, joint) for joint in items]


def _clause(teller: Teller, joint: RollingOnCircle) -> str:
    disc = teller.disc(joint.centre, joint.body) + teller.rim(joint.body, _radius(teller, joint))
    key = "rolling_on_circle" + ("_inside" if joint.inside else "")
    if joint.on is not None:
        return teller.say(key + "_of_disc", disc=disc, other=teller.disc(joint.around, joint.on, "_of"))
    ray = teller.at(joint.centre) - teller.at(joint.around)
    wheel = teller.at(joint.centre) + (ray if joint.inside else -ray) / abs(ray) * _radius(teller, joint)
    touching = [
        name for name in teller.shown(teller.board.form.bodies[joint.body]) if abs(teller.at(name) - wheel) < 1e-6
    ]
    contact = teller.say("contact", point=teller.name(touching[0])) if touching else ""
    return teller.say(key, disc=disc, centre=teller.name(joint.around), contact=contact)


def _radius(teller: Teller, joint: RollingOnCircle) -> float:
    """The radius of the wheel on paper (u)."""
    return float(joint.radius) * teller.board.sketch.scale
