"""An exam: which problems, for whom, with which answers; no format is known here."""
