"""Many variants of a family, and one of them over a turn of its driver, as arrays and columns."""
