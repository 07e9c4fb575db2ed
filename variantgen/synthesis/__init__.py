"""Mechanisms that nobody drew: structures of a crank and dyads, their geometry, and the family folder of each."""
