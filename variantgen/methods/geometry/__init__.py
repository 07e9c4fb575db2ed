"""Lengths, angles and directions of the figure, worked out as a reader would: from the construction of each point, by
triangles, and by legs of known direction. One module for each construction is in ``placing``.
"""
