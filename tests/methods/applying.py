"""Which forms of the catalogue each method applies to: the expected values, told from the mechanisms."""

from __future__ import annotations

from tests.methods.forms import FORMS

# A family (with all its forms) or a form. A point slides on a moving body.
_SLIDING = {
    "arc_yoke", "cam_disc", "four_bar_with_sleeve", "hydraulic_hoist", "oscillating_cylinder",
    "parallelogram_with_disc-moving_point", "point_on_rotating_disc", "quick_return_shaper", "scotch_yoke",
    "sleeve_on_crank", "sliding_block_on_rotating_rod", "slotted_rocker", "wedge_and_rod",
}  # fmt: skip
# A rod with one known point and another of known direction.
_RODS = {
    "disc_on_arc_with_rod", "four_bar", "four_bar_with_sleeve", "hydraulic_hoist-with_rod", "ladder", "limit_positions",
    "quick_return_shaper", "rod_in_circular_guide", "sleeve_on_crank", "slider_crank", "slider_crank_with_graph",
    "slider_crank_with_second_rod",
    "triangle_plate-velocities", "two_loop_mechanism", "wheel_with_rod-central", "wheel_with_rod-offset",
}  # fmt: skip
# Coordinates are formulas of the given motion: no system of equations.
_EXPLICIT = {
    "cam_disc-flat", "crank_and_disc", "disc_in_cylinder-inside", "disc_in_cylinder-outside", "falling_rod",
    "gear_pair_with_crank", "movable_pulley-load_and_axle", "planetary_pair", "planetary_train",
    "plate_acceleration_centre", "point_on_rotating_disc", "pulley_and_wheel-axle", "roller_on_drum", "rolling_wheel",
    "scotch_yoke", "sliding_block_on_rotating_rod", "triangle_plate-equilateral", "triangle_plate-scalene",
    "wedge_and_rod-vertical", "wheel_between_racks-driven_by_axle",
}  # fmt: skip
# Bodies turn about fixed points, translate, or are led by what slides on them: none is in plane motion.
_NO_PLANE_MOTION = {
    "arc_yoke", "cam_disc", "hydraulic_hoist-boom", "parallelogram_with_disc", "planetary_train-two_suns",
    "point_on_rotating_disc", "scotch_yoke", "sliding_block_on_rotating_rod", "slotted_rocker", "wedge_and_rod",
}  # fmt: skip
# Only accelerations of a plate are asked, only velocities are asked.
_ACCELERATIONS = {"plate_acceleration_centre", "triangle_plate-equilateral", "triangle_plate-scalene"}
_VELOCITIES = {"triangle_plate-velocities", "limit_positions", "slider_crank_with_graph-sketch"}
# Angular velocity and acceleration of a body are known before the acceleration of a further point.
_ANGULAR_FIRST = {
    "crank_and_disc", "disc_in_cylinder", "falling_rod", "gear_pair_with_crank", "ladder", "movable_pulley",
    "planetary_pair", "planetary_train-two_planets", "planetary_train-ring", "plate_acceleration_centre",
    "pulley_and_wheel", "roller_on_drum", "rolling_wheel", "spool", "three_rod_plate", "triangle_plate-equilateral",
    "triangle_plate-scalene", "two_cranks_and_rod", "wheel_between_racks", "wheel_with_rod-central",
    "wheel_with_rod-offset", "winch_with_pulley",
}  # fmt: skip


def _only(those: set[str]) -> list[tuple[str, str]]:
    return [(name, form) for name, form in FORMS if {name, f"{name}-{form}"} & those]


def _without(those: set[str]) -> list[tuple[str, str]]:
    return [(name, form) for name, form in FORMS if not {name, f"{name}-{form}"} & those]


APPLYING = {
    "analytical": _only(_EXPLICIT),
    "velocity_pole": _without(_NO_PLANE_MOTION | _ACCELERATIONS),
    "projections": _only(_RODS),
    "velocity_centre": _without(_NO_PLANE_MOTION | _ACCELERATIONS | {"wheel_with_rod-driven_by_slider"}),
    # In a guided plate and an oscillating cylinder no acceleration follows from that of a pole alone.
    "acceleration_pole": _without(_NO_PLANE_MOTION | _VELOCITIES | {"guided_plate", "oscillating_cylinder"}),
    "acceleration_centre": _only(_ANGULAR_FIRST),
    "relative_motion": _only(_SLIDING),
    "three_rates": _only({"four_bar", "four_bar_with_sleeve", "limit_positions-rocker"}),
    "graphical": _without({"guided_plate", "three_rod_plate"}),
    "coordinates": FORMS,
}


def cases(*methods: str) -> tuple[list[tuple[str, str, str]], list[str]]:
    """Name, form and method of all cases of these methods, and what tests call them."""
    found = [(*form, method) for method in methods for form in APPLYING[method]]
    return found, ["-".join(case) for case in found]
