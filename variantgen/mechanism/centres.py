"""Velocity centre and acceleration centre of a body."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from variantgen.mechanism.motion import ComplexField, Motion


class CentrePosition(NamedTuple):
    """Position (m), shape (N,), and where it is finite; where it is not, the position is a placeholder (0)."""

    z: ComplexField
    finite: NDArray[np.bool_]


def velocity_centre(motion: Motion, body: str) -> CentrePosition:
    """The point of the body that is at rest: ``z_P = z_A + i v_A / omega``; infinite in translation (omega = 0).

    Guide to kinematics (see :mod:`variantgen.methods`), section 3.1.4, formula 62, as a complex number.
    """
    pole = motion.scene.bodies[body][0]
    omega = motion.omega[body]
    finite = omega != 0
    z = motion.z[pole] + 1j * motion.v[pole] / np.where(finite, omega, 1.0)
    return CentrePosition(np.where(finite, z, 0.0), finite)


def acceleration_centre(motion: Motion, body: str) -> CentrePosition:
    """The point without acceleration: ``z_Q = z_A + a_A / (omega^2 - i epsilon)``; infinite if both are zero.

    Guide to kinematics (see :mod:`variantgen.methods`), section 3.2.3, formulas 71 and 72, as a complex number.
    """
    pole = motion.scene.bodies[body][0]
    divisor = motion.omega[body] ** 2 - 1j * motion.epsilon[body]
    finite = divisor != 0
    z = motion.z[pole] + motion.a[pole] / np.where(finite, divisor, 1.0)
    return CentrePosition(np.where(finite, z, 0.0), finite)
