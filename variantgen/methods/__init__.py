"""Ways to write a solution: the solved motion as language-free steps of the textbook, with all their arithmetic."""
