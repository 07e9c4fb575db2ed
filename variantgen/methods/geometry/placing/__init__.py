"""Derivations of the places of points, one module per construction with the same stem as in the mechanism.

Points that conditions place together have two: ``near`` with the equations, ``at_printed_angle`` where the sheet prints
angles of the position.

Each module has one class ``Derivation``, a :class:`variantgen.methods.geometry.constructed_point.ConstructedPoint`.
"""
