"""A copy of the package with its data, in which a test adds what an author would add."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from variantgen.resources import catalog_dir, templates_dir


@dataclass(frozen=True)
class PackageCopy:
    """The folder ``root`` with ``variantgen``, ``templates`` and some families of ``catalog``."""

    root: Path

    @classmethod
    def of(cls, root: Path, families: Iterable[str]) -> PackageCopy:
        ignored = shutil.ignore_patterns("__pycache__")
        shutil.copytree(Path(__file__).resolve().parents[1] / "variantgen", root / "variantgen", ignore=ignored)
        shutil.copytree(templates_dir(), root / "templates")
        for family in families:
            shutil.copytree(catalog_dir() / family, root / "catalog" / family)
        return cls(root)

    def replace(self, name: str, old: str, new: str, count: int = -1) -> None:
        """Write something else in a file."""
        text = (self.root / name).read_text("utf-8")
        assert old in text, (name, old)
        (self.root / name).write_text(text.replace(old, new, count), "utf-8")

    def run(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        """A command of the copied program, in its folder."""
        environment = {**os.environ, "PYTHONPATH": str(self.root), "PYTHONDONTWRITEBYTECODE": "1"}
        command = [sys.executable, "-m", "variantgen", *arguments]
        return subprocess.run(
            command, cwd=self.root, env=environment, capture_output=True, text=True, encoding="utf-8", check=False
        )
