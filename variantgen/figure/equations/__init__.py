"""Figures of one step: the body concerned with the vectors of one equation, or with its velocity centre."""
