"""The letters of figures, set as the typesetting engine sets them: glyphs, letters in a row, whole formulas."""
