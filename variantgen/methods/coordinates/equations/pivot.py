"""A fixed pivot: its point is at rest, which the coordinates know already."""
