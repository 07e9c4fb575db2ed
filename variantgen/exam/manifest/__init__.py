"""The manifest of a finished exam: who got which variant, with which answers, made with what."""

from variantgen.exam.manifest.reading import HASH, NAME, SCHEMA, EntriesHash, Manifest, made_with, read_manifest
from variantgen.exam.manifest.recorded_sheets import RecordedAnswer, RecordedProblem, RecordedSheet

__all__ = [
    "HASH",
    "NAME",
    "SCHEMA",
    "EntriesHash",
    "Manifest",
    "RecordedAnswer",
    "RecordedProblem",
    "RecordedSheet",
    "made_with",
    "read_manifest",
]
