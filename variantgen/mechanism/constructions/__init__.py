"""Ways to place a point from points that are already placed: one module per construction.

A construction is a frozen Struct with a method ``place(at)``: it takes the positions of the points it names and
returns the new position and a flag per variant that says whether it exists. Where it does not, the position is a
finite placeholder; ``failure`` says which outcome that is.
"""
