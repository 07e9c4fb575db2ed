"""Wheels on circles: outside or inside, fixed or part of a body."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.mechanism.joints.rolling_on_circle import RollingOnCircle


def tell(alt_text: AltText, items: Sequence[RollingOnCircle]) -> list[str]:
    """A clause for each circle."""
    return [_clause(alt_text, joint) for joint in items]


def _clause(alt_text: AltText, joint: RollingOnCircle) -> str:
    disc = f"{alt_text.disc(joint.centre, joint.body)}{alt_text.rim(joint.body, _radius(alt_text, joint))}"
    key = "rolling_on_circle" + ("_inside" if joint.inside else "")
    if joint.on is not None:
        return alt_text.say(key + "_of_disc", disc=disc, other=alt_text.disc(joint.around, joint.on))
    ray = alt_text.at(joint.centre) - alt_text.at(joint.around)
    wheel = alt_text.at(joint.centre) + (ray if joint.inside else -ray) / abs(ray) * _radius(alt_text, joint)
    touching = [
        name for name in alt_text.shown(alt_text.board.form.bodies[joint.body]) if abs(alt_text.at(name) - wheel) < 1e-6
    ]
    contact = alt_text.say("contact", point=alt_text.name(touching[0])) if touching else ""
    return alt_text.say(key, disc=disc, centre=alt_text.name(joint.around), contact=contact)


def _radius(alt_text: AltText, joint: RollingOnCircle) -> float:
    """The radius of the wheel on paper (u)."""
    return float(joint.radius) * alt_text.board.sketch.scale
