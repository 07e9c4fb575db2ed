"""Sample exams and the sample roster of the catalogue."""

from __future__ import annotations

from pathlib import Path

from variantgen.resources import catalog_dir


def samples_dir() -> Path:
    """The folder of sample exams and of the sample roster."""
    return catalog_dir() / "exams"


def exam_path(path: Path) -> Path:
    """The path itself if it exists, or the sample exam of that name."""
    sample = samples_dir() / (path.name if path.suffix else path.name + ".toml")
    return sample if not path.exists() and path.parent == Path() and sample.is_file() else path
