"""One variant at hand: its problem, its worked solution, a figure or its motion, as a page or in a notebook."""
