"""Values as an author writes them: parameters with their grids, expressions, dimensions, units, laws of time."""
