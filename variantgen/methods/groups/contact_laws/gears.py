"""Gear mesh: at the pitch point both gears have the same velocity; a fixed gear is at rest there."""

from __future__ import annotations

from variantgen.mechanism.joints.gears import Gears
from variantgen.methods.groups.contact import NoSlipContact
from variantgen.methods.groups.pitch_contact import pitch_contact
from variantgen.methods.linkage.problem import Task


def contact(task: Task, number: int) -> NoSlipContact | None:
    """The contact at the pitch point ``z_A - k d`` (see :class:`variantgen.mechanism.joints.gears.Gears`)."""
    joint = task.scene.joints[number]
    assert isinstance(joint, Gears)
    return pitch_contact(task, number, joint, joint.other_centre, joint.other or "", "gears")
