"""How much of anything is read, in one place: plain numbers, each far above what people write.

What is larger is refused with a message that names the bound, before memory or time is spent on it.
"""

from __future__ import annotations

# Texts written by hand. The largest family of the catalogue has 6 kB.
TOML_BYTES = 200_000
# A name like ``a.b.c`` of n parts costs the reader of TOML n * n; no key of ours has more than five parts.
KEY_PARTS = 50
DIGITS = 1000  # of a number

# A family: its forms, and of one form the entries of each section. The catalogue has at most 4 forms, 13 parameters,
# 4 derived quantities, 8 points, 7 joints, 5 marks of a kind.
FORMS = 50
PARAMETERS = 40  # each is moved by itself, in every draw, to see how the answers depend on it
VALUES = 10_000  # of one parameter
GRID = 50_000  # values of all parameters of a form together: they are in memory as they are printed
DERIVED = 200
PARTS = 200  # points, bodies, joints, drivers, conditions, and what is required of the data
MARKS = 60  # of one kind in a figure: every label looks for a place between all others
FAMILY_FILES = 50  # the family, its worked cases, a statement for each language

# An exam: problems of one sheet (a hundred pages for one student are a book), and what one of them lists: the families
# that it is drawn from, the quantities that it asks.
PROBLEMS = 100
LISTED = 100

# What is unpacked of one stream of a PDF that is read back (the table of objects of half a million students), and what
# one page may need of them with its fonts.
PDF_STREAM_BYTES = 256_000_000
PDF_PAGE_BYTES = 64_000_000

# A class list. As a CSV a million students have some 40 MB; the worksheets of a workbook, unpacked, have 4 MB for
# 20 000 students, its styles and other parts 20 kB (overgrown ones 1 MB); spreadsheets have no more rows than these.
ROSTER_BYTES = 50_000_000
WORKBOOK_BYTES = 50_000_000
WORKBOOK_LOOKS = 2_000_000
WORKBOOK_MARKS = 100_000  # tags in those other parts: the reader of workbooks takes 0.08 ms for each
WORKBOOK_ROWS = 200_000  # that are written down, be they empty: the reader takes 0.02 ms for an empty one
WORKSHEETS = 500  # one for each group
ROSTER_ROWS = 1_048_576
ROSTER_COLUMNS = 256  # those further right are not looked at: a class list has its columns at the left
ANSWER_COLUMNS = 16_384  # of a table of answers: all that a worksheet has
TITLE_ROWS = 20  # rows among which the header is looked for: above it may stand a title

# Scans: pages of one file, bytes of it, pixels of a page (A4 at 600 dpi has 35 million).
SCAN_PAGES = 5_000
SCAN_BYTES = 4_000_000_000
SCAN_PIXELS = 70_000_000
