"""The solution group by group: which method is used for each, the answers at the end, the closed chain of rates."""
