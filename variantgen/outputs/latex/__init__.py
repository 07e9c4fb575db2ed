"""LaTeX sources of the documents of an exam, and their compilation."""
