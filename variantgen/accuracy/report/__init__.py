"""What the measurement found, as tables, diagrams and a short text made from the numbers."""
