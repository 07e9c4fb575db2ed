"""Measurements of the program: ``python -m benchmarks`` for cost and speed, single modules for what else is counted."""
