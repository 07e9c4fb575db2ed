"""Motion over time: integration of the velocity equations to an instant, against direct evaluation at each instant."""
