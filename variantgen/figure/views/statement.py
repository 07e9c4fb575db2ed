"""The figure of the statement: the mechanism in its position with everything given and nothing else."""

from __future__ import annotations

from variantgen.figure.build import statement_figure

ORDER = 0
draw = statement_figure
