"""Where labels stand: what is wanted, what is taken, what could be misread."""
