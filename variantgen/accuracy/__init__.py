"""Error against run time: ways to compute a motion, measured on the same variants against many digits."""
