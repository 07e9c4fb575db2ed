"""Drivers: prescribed motion at the instant of the problem, one module per kind.

A driver states a constraint like a joint does, with a rate on the right-hand side.
"""
