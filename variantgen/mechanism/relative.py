"""Relative motion of a point with respect to a moving body that it is not part of (sleeve, slot)."""

from __future__ import annotations

from msgspec import Struct

from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import ComplexField, Motion
from variantgen.mechanism.scene import Scene


class RelativeMotion(Struct, frozen=True):
    """Motion of a point relative to a body, shape (N,) each: ``a = a_transport + relative + coriolis``.

    ``velocity`` ``v_rel = v - v_transport`` (m/s); ``acceleration`` ``a_rel`` (m/s^2); ``coriolis``
    ``2 i omega v_rel`` (m/s^2): the relative velocity turned by a right angle with the rotation of the carrier
    (rule of Zhukovsky). The last two are None when accelerations were not computed.
    """

    body: str
    velocity: ComplexField
    acceleration: ComplexField | None
    coriolis: ComplexField | None


def sliding_points(scene: Scene) -> dict[str, str]:
    """Points that slide along a moving body, with the body."""
    return {slide.point: slide.body for slide in Linkage(scene).slides}


def relative_motion(motion: Motion, point: str, body: str) -> RelativeMotion:
    """Relative, transport and Coriolis parts of the motion of a point with respect to a body (theorem of Coriolis).

    ``a = a_tr + a_rel + a_cor`` with ``a_cor = 2 i omega v_rel`` (Kirsanov, section 2.5, formulas 2.25 and 2.26); all
    arrays have the shape (N,).
    """
    pole = motion.scene.bodies[body][0]
    d = motion.z[point] - motion.z[pole]
    omega = motion.omega[body]
    velocity = motion.v[point] - (motion.v[pole] + 1j * omega * d)
    if not motion.a:
        return RelativeMotion(body, velocity, None, None)
    coriolis = 2j * omega * velocity
    transport = motion.a[pole] + (1j * motion.epsilon[body] - omega**2) * d
    return RelativeMotion(body, velocity, motion.a[point] - transport - coriolis, coriolis)
