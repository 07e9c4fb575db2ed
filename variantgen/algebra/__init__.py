"""Expressions and what can be done with them: sums and products brought into one form, derivatives, evaluation on
numbers and on arrays, and the same as Python text. The data of a family are such expressions of variables, the formulas
of a solution such expressions of values. Knows nothing of mechanisms.
"""
