"""Derivations of the places of points, one module per construction with the same stem as in the mechanism.

Each module has one class ``Derivation``, a :class:`variantgen.methods.geometry.constructed_point.ConstructedPoint`.
"""
