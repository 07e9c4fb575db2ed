"""How much of a foreign file is read: bounds that no sensible file reaches, and why each is where it is.

A file of a few kilobytes can unpack to gigabytes or name two thousand million rows. Where a bound is reached, the
command says so in a moment instead of filling the memory.
"""

from __future__ import annotations

MAX_ROSTER_BYTES = 50_000_000
"""A class list as a file: a CSV of a million students has some 40 MB."""

MAX_WORKBOOK_BYTES = 50_000_000
"""The worksheets and texts of a workbook, unpacked: 20 000 students take some 4 MB; more than 200 000 come as CSV."""

MAX_WORKBOOK_LOOKS = 2_000_000
"""All other parts of a workbook, unpacked (styles, mostly): a usual one has 20 kB, an overgrown one 1 MB."""

MAX_WORKSHEETS = 500
"""Worksheets of a workbook, one for each group."""

MAX_ROSTER_ROWS = 1_048_576
"""Rows of a worksheet, with or without students: spreadsheets have no more."""

MAX_ROSTER_COLUMNS = 256
"""Columns that are looked at: a class list has its columns at the left."""

MAX_TITLE_ROWS = 20
"""Rows among which the row with the names of the columns is looked for: above it may stand a title."""
