"""A text of a sheet in any format: a sequence of strings and formulas."""

from __future__ import annotations

from variantgen.wording.formula import Formula

Text = tuple[str | Formula, ...]
