"""Conditions on points that no construction can place one by one: they are met together, by Newton's method.

A condition is a frozen Struct in a module of its own. ``product()`` is what it says, as a product of two vectors
between points. The points are those placed by the construction ``near``; their coordinates there are the starting
picture.
"""
