"""Rolling on a circle, fixed or of a moving body: the line of centres turns with the arc that is rolled off."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.expression import Ratio
from variantgen.algebra.normal_form import added, product
from variantgen.methods.coordinates.heading import Heading
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Body, Fact, Point

if TYPE_CHECKING:
    from variantgen.mechanism.joints.rolling_on_circle import RollingOnCircle
    from variantgen.methods.coordinates.model import Model


def state(model: Model, joint: RollingOnCircle, template: None) -> None:
    """``x_O = x_C + D cos(beta + k phi + (1 - k) Phi)``, ``k = r/D`` outside and ``-r/D`` inside."""
    centre, around = joint.centre, joint.around
    d = model.now(around, centre)
    distance = model.geometry.length(around, centre)
    radius = model.radius(joint.body, centre, model.length(joint.radius))
    own = product(Ratio(radius, distance), model.swept(joint.body))
    other = None
    if joint.on is not None and model.swept(joint.on) is not None:
        exact = abs(d) + (1 if joint.inside else -1) * model.length(joint.radius)
        other = product(Ratio(model.radius(joint.on, around, exact), distance), model.swept(joint.on))
    angle = added((-1 if joint.inside else 1, own), (1, other))
    arm = Heading(angle, degrees(d)).ray(distance)
    facts: dict[str, Fact] = {"body": Body(joint.body), "centre": Point(centre), "around": Point(around)}
    model.add_vector("rolling_on_circle", around, centre, [arm], **facts)
