"""The manifest of a finished exam: who got which variant, with which answers, made with what."""

from variantgen.exam.manifest.reading import NAME, SCHEMA, Manifest, made_with, read_manifest
from variantgen.exam.manifest.recorded_sheets import RecordedAnswer, RecordedProblem, RecordedSheet

__all__ = [
    "NAME",
    "SCHEMA",
    "Manifest",
    "RecordedAnswer",
    "RecordedProblem",
    "RecordedSheet",
    "made_with",
    "read_manifest",
]
