"""From the solved motion to a drawing: symbols, marks, labels; no output format is known here."""
