"""The measures of solutions on paper, for those who plan their lines, figures and pages, and for templates."""

from __future__ import annotations

WIDTH, HEIGHT = 180.0, 267.0  # mm: of the text on a page
BETWEEN_COLUMNS = 6.0  # mm
COLUMN = (WIDTH - BETWEEN_COLUMNS) / 2
POINTS = 9.5  # the size of the text
EM = POINTS * 25.4 / 72  # mm

# What templates are told, by the names that they have for it: millimetres and points.
FOR_TEMPLATES = {"width": WIDTH, "height": HEIGHT, "gutter": BETWEEN_COLUMNS, "points": POINTS}
