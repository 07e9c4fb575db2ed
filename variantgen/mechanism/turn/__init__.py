"""The motion over a turn of the crank or a range of time: continuation, extremes, dead points."""
