"""Solutions in a language: steps become headings, sentences with formulas in them, and lines of formulas."""
