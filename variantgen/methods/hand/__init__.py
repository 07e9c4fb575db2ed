"""Steps of solutions repeated on arrays of variants.

What a careful hand calculation makes of the answers (the tolerance that rounding needs), and the confirmation of
answers without a printed solution.
"""
