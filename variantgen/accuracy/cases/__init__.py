"""Classes of cases, one module each, found by their file names.

A class has a ``TITLE``, ``ABOUT`` (one sentence), a ``PLACE`` in the order of the report, and ``groups(count, rng)``:
groups of about so many variants in all, the same for the same state of the generator.
"""
