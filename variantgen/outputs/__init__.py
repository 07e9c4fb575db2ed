"""Output formats, one module each; none of them computes an answer."""
