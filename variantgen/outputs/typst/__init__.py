"""The embedded typesetting engine: how it is called, how formulas and figures are written for it, what it can print."""
