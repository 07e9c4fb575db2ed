"""The book in which a solution is written while it is worked out: vectors of points and rates of bodies known so far,
rays to centres found so far, the steps; then what of it is used, with the position at its head.
"""
