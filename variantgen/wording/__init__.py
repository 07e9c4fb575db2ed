"""Words, numbers, units and formulas: what a document says, independent of how it looks."""
