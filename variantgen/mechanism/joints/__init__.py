"""Kinematic pairs other than the hinge, one module per joint; a hinge is a point shared by bodies.

A joint is a frozen Struct that states its constraint at three levels (see
:class:`variantgen.mechanism.rows.Constraint`): residual of the positions, coefficients of the velocities, and the
term quadratic in the velocities that appears in the accelerations.
"""
