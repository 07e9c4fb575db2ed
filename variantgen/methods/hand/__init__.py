"""What a careful hand calculation makes of the answers (the tolerance that rounding needs), and every method a second
time on arrays of variants, compared with the solver.
"""
