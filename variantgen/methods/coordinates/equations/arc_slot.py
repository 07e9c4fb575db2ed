"""A circular slot or guide: a constant distance or, where the motion on the circle is of interest, an angle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.normal_form import added
from variantgen.mechanism.drivers.circling import Circling
from variantgen.methods.coordinates.heading import Heading
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Body, Fact, Point

if TYPE_CHECKING:
    from variantgen.mechanism.joints.arc_slot import ArcSlot
    from variantgen.methods.coordinates.model import Model


def state(model: Model, joint: ArcSlot, template: None) -> None:
    """``|d| = R``, or ``x_P = x_C + R cos(phi + psi)`` with the angle psi on the body."""
    point, centre, body = joint.point, joint.centre, joint.body
    radius = model.geometry.length(centre, point)
    facts: dict[str, Fact] = {"point": Point(point), "centre": Point(centre)}
    relative = any(q.target == point and q.kind in ("v_rel", "a_rel", "a_cor") for q in model.task.sought)
    if body is None or not (relative or _is_driven(model, joint)):
        model.add_distance("arc", centre, point, radius, **facts)
        return
    now = degrees(model.now(centre, point))
    turn = model.rotation(body)
    angle = model.arc(point, body, now - (turn.exact if turn is not None else 0.0))
    heading = Heading(added((1, turn), (1, angle)), 0.0)
    model.add_vector("arc_angle", centre, point, [heading.ray(radius)], body=Body(body), **facts)


def _is_driven(model: Model, joint: ArcSlot) -> bool:
    """Whether the motion along the arc is given."""
    return any(
        isinstance(d, Circling) and (d.point, d.body) == (joint.point, joint.body) for d in model.task.scene.drivers
    )
