"""The contact of two circles that roll on each other: gears, a roller on a drum."""

from __future__ import annotations

from typing import Protocol

from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.rows import Placement
from variantgen.methods.groups.contact import ContactSide, NoSlipContact, letter_at, metres, resting_letter
from variantgen.methods.groups.group import PointPath
from variantgen.methods.linkage.problem import Task


class CircleJoint(Protocol):
    """A joint of a circle (``body``, ``centre``, ``radius``) that touches another one."""

    @property
    def body(self) -> str:
        """The body of the first circle."""
        ...

    @property
    def centre(self) -> str:
        """Its centre."""
        ...

    def ratio(self, at: Placement) -> tuple[Complex, Real]:
        """The vector d from the second centre to the first and the number k of the contact ``centre - k d``."""
        ...


def pitch_contact(task: Task, number: int, joint: CircleJoint, around: str, other: str, kind: str) -> NoSlipContact:
    """The contact of a circle with that about ``around`` of the body ``other`` (empty: at rest)."""
    d, k = joint.ratio(metres(task))
    step, part = complex(d) / task.length_unit, float(k)
    line = 1j * step / abs(step)
    name = letter_at(task, task.now.z[joint.centre] - part * step, (joint.body, other), number)
    name = name if other else resting_letter(task, joint.body, name)
    radial = (around, joint.centre)
    first = _side(name, joint.centre, joint.body, -part * step, line, radial)
    second = _side(name, around if other else "", other, (1.0 - part) * step, line, radial)
    point_path = PointPath(joint.centre, centre=around) if around in task.fixed else None
    return NoSlipContact(kind, first, second, point_path)


def _side(name: str, centre: str, body: str, arm: complex, line: complex, radial: tuple[str, str]) -> ContactSide:
    """One of the circles, with the ``arm`` from its centre to the contact."""
    lever = 1 if (line.conjugate() * 1j * arm).real > 0 else -1
    return ContactSide(name, centre, line, body, abs(arm), lever if body else 0, radial)
