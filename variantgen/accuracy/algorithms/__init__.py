"""Ways to compute the motion at an instant, one module each, found by their file names.

A way has a ``TITLE`` for tables, a ``SHORT`` one for diagrams, ``DOUBLE`` (whether it is double precision throughout),
``applies(group)`` (empty, or why not) and ``prepare(group)``: it gives a function without arguments, whose calls are
timed, that computes the whole batch. ``BATCH`` is how many variants are computed at once when it is timed.
"""
