"""Planar kinematics in pure numbers (numpy): scenes, constructions, joints, solution, verification.

Inside: SI units, radians, x right, y up, counter-clockwise positive. One planar point is one complex number; every
array has one batch axis (N variants at once).
"""
