"""From a scene to its motion: the order of placing, groups of unknowns, and the equations of each group."""
