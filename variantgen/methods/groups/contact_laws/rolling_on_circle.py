"""A wheel on a circle that turns: the points at the contact have the same velocity."""

from __future__ import annotations

from variantgen.mechanism.joints.rolling_on_circle import RollingOnCircle
from variantgen.methods.groups.contact import NoSlipContact
from variantgen.methods.groups.pitch_contact import pitch_contact
from variantgen.methods.linkage.problem import Task


def contact(task: Task, number: int) -> NoSlipContact | None:
    """The contact with the circle; None for a circle at rest, on which a wheel is treated as rolling on a path."""
    joint = task.scene.joints[number]
    assert isinstance(joint, RollingOnCircle)
    return pitch_contact(task, number, joint, joint.around, joint.on, "drum") if joint.on else None
