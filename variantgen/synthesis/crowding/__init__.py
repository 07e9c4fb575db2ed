"""Whether a mechanism can be read: its draft by many screens, all variants of it where links would cross."""

from variantgen.synthesis.crowding.crossings import crossed
from variantgen.synthesis.crowding.screens import crowded, too_long

__all__ = ["crossed", "crowded", "too_long"]
