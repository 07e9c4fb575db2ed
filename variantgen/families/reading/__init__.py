"""From the TOML of a family to its forms, with worked cases, hints of figures, and what a file leaves unsaid."""
