"""A body in translation has no angle, which the coordinates know already (see :mod:`body` for its points)."""
