"""Expressions of a solution and what can be done with them: sums and products brought into one form, derivatives,
evaluation on numbers and on arrays, and the same as Python text. Knows nothing of mechanisms.
"""
