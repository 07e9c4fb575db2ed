"""A computation on arrays as a straight line of operations: recorded once, written as Python, run many times."""
