"""Velocity centres (P) and acceleration centres (Q) of bodies, and what needs no vector equation: equal projections on
a line, wheels and links that turn about a known point.
"""
