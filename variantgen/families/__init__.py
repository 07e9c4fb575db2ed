"""From a family file (TOML) to a :class:`~variantgen.families.family.Family`: reading, checking, expressions."""
