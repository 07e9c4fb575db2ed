"""Conditions on points that no construction can place one by one: they are met together, by Newton's method.

A condition is a frozen dataclass in a module of its own. ``value(at)`` is what is left of it (m) and
``gradient(at)`` its derivative: by point a vector c with ``d value = sum Re(conj(c) dz)``. The points are those placed
by the construction ``near``; their coordinates there are the starting picture.
"""
