"""The four-bar and the slider-crank as textbooks solve them by hand: closed forms in real numbers.

The functions take numbers or arrays, and numba compiles the very same lines. They return place, velocity and
acceleration of B (x and y of each) and the angular velocity and acceleration of the coupler.
"""

from __future__ import annotations

from typing import Any

import numpy as np

Numbers = Any  # floats or arrays of them


def four_bar(
    a: Numbers, b: Numbers, c: Numbers, d: Numbers, phi: Numbers, w: Numbers, e: Numbers, side: Numbers
) -> tuple[Numbers, ...]:
    """Crank a, coupler b, rocker c, frame d along x; side 1: B to the left of the way from A to C."""
    ax, ay = a * np.cos(phi), a * np.sin(phi)
    # Law of cosines in the triangle ABC.
    dx, dy = d - ax, -ay
    square = dx * dx + dy * dy
    along = (b * b + square - c * c) / (2 * square)
    across = side * np.sqrt(b * b / square - along * along)
    bx, by = along * dx - across * dy, along * dy + across * dx  # from A to B
    cx, cy = ax + bx - d, ay + by  # from C to B
    # v_A + omega_AB x AB = omega_BC x CB, by Cramer's rule.
    det = bx * cy - by * cx
    vx, vy = -w * ay, w * ax
    w2 = -(vx * cx + vy * cy) / det
    w3 = -(vx * bx + vy * by) / det
    # The same for accelerations, with the normal parts on the known side.
    qx = -e * ay - w * w * ax - w2 * w2 * bx + w3 * w3 * cx
    qy = e * ax - w * w * ay - w2 * w2 * by + w3 * w3 * cy
    e2 = -(qx * cx + qy * cy) / det
    e3 = -(qx * bx + qy * by) / det
    return (
        ax + bx,
        ay + by,
        -w3 * cy,
        w3 * cx,
        -e3 * cy - w3 * w3 * cx,
        e3 * cx - w3 * w3 * cy,
        w2,
        e2,
    )


def slider_crank(a: Numbers, b: Numbers, h: Numbers, phi: Numbers, w: Numbers, e: Numbers) -> tuple[Numbers, ...]:
    """Crank a, coupler b, guide of B along x at the height h, B ahead of A."""
    ax, ay = a * np.cos(phi), a * np.sin(phi)
    by = h - ay
    bx = np.sqrt(b * b - by * by)
    vx, vy = -w * ay, w * ax
    w2 = -vy / bx
    qx = -e * ay - w * w * ax - w2 * w2 * bx
    qy = e * ax - w * w * ay - w2 * w2 * by
    e2 = -qy / bx
    nought = 0.0 * bx
    return ax + bx, h + nought, vx - w2 * by, nought, qx - e2 * by, nought, w2, e2
