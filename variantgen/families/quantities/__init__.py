"""The quantities that may be asked: their names, dimensions and values.

========================  ======================================================================================
name                      meaning
========================  ======================================================================================
``v_B  a_B``              magnitude of the velocity, acceleration of a point
``v_B_A  a_B_A``          of one point as seen from another, also written ``v_B/A``: the difference of both vectors
``v_B.x  a_B.y``          component on paper (x to the right, y up)
``v_B.angle``             direction: angle from the x axis, -180 to 180 degrees, positive counter-clockwise
``v_B.along_AC``          component along the way from A to C
``v_B.across_AC``         component across it, 90 degrees counter-clockwise from it
``a_B.t  a_B.n``          tangential acceleration (positive where B speeds up), normal acceleration
``rho_B``                 radius of curvature of the path of a point
``omega_AB  epsilon_AB``  angular velocity, angular acceleration of a body, positive counter-clockwise
``omega_AB.abs``          its magnitude
``omega_AB.sense``        its sense: +1 counter-clockwise, -1 clockwise
``v_rope.A.B``            speed of a rope or belt where it runs straight between its stations A and B
``ratio_AB.CD``           ratio of two angular velocities, ``omega_AB / omega_CD``
``v_rel_C a_rel_C``       magnitude of the relative velocity, relative acceleration of a sliding point
``a_cor_C``               magnitude of its Coriolis acceleration (components and angle as above)
``P_AB.A``                distance of a point from the velocity centre P of a body
``Q_AB.A``                distance of a point from the acceleration centre Q of a body
``P_AB.x  Q_AB.y``        coordinate of the centre, from the origin of the scene
``mu_AB``                 angle between accelerations and rays from Q: ``tan mu = |epsilon| / omega^2``
``x_B  y_B``              coordinate of a point, from the origin of the scene
``angle_AB``              direction from A to B: angle from the x axis, -180 to 180 degrees
``angle_O.A.B``           corner OAB at the point A, 0 to 180 degrees
``distance_A.B``          distance of two points
``max_v_B  min_v_B``      extreme over a turn of the crank of ``v_B``, ``a_B``, ``omega_AB``, ``epsilon_AB`` (their
                          magnitudes), ``x_B``, ``y_B``, ``angle_O.A.B``, ``distance_A.B``
``phi_max_v_B``           angle by which the crank turns from the instant until the extreme is first reached
``mean_v_B``              mean over a turn of the crank of ``v_B`` or of the magnitude of ``omega_AB``
``stroke_B  swing_BC``    way between the limit positions of a point on a line, angle between those of a body
``time_ratio_B``          time of the slower way over that of the faster one, of a point or a body
``max_t_v_B  min_t_x_B``  extreme in the interval of time that the laws of the scene state, of the same kinds
``t_max_v_B  t_zero_v_B`` instant at which the extreme is first reached, at which a quantity is first zero
``mean_t_v_B``            mean in the interval of ``v_B`` or of the magnitude of ``omega_AB``
``way_B  shift_B``        length of the way of a point in the interval, its displacement (components and angle as above)
``average_v_B``           displacement through the time, ``average_a_B`` change of the velocity through the time
``instant_t``             instant of the problem, also written ``t``, where it is found by what happens at it
``turned_AB``             angle by which a body turns in the interval, positive counter-clockwise
``t_back_B``              instant at which a point is first again where it was at the beginning
``duration_B``            time of the interval, where the laws state it by its places
========================  ======================================================================================

What there is of a kind is told by one table: :data:`variantgen.families.quantities.kinds.KINDS`.
"""

from variantgen.families.quantities.kinds import line_ends
from variantgen.families.quantities.quantity import Quantity, motion_order, recorded
from variantgen.families.quantities.reading import (
    in_unit,
    interval_names,
    is_quantity,
    parse_quantity,
    quantity_names,
    split_name,
    split_unit,
)

__all__ = [
    "Quantity",
    "in_unit",
    "interval_names",
    "is_quantity",
    "line_ends",
    "motion_order",
    "parse_quantity",
    "quantity_names",
    "recorded",
    "split_name",
    "split_unit",
]
