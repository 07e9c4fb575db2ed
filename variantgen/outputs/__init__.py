"""Outputs of an exam (``formats``, one module each) and what they are made of; none of them computes an answer."""
