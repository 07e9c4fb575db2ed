"""Samples of work that are kept, quickly read (``work_samples.json``; :mod:`variantgen.exam.work.work_samples`)."""

from __future__ import annotations

import json
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any

from msgspec import Struct

KEPT = Path(__file__).with_name("work_samples.json")
SAMPLE = 48  # variants of a form

Sizes = tuple[int, int, int]  # calculations, negative numbers, obtuse angles


class WorkSample(Struct, frozen=True):
    """How many variants of a sample take so much work, and the number of draws ``of`` which they are the valid ones.

    ``works`` is empty where a form has no valid variant, and where no method leads to what is asked.
    """

    works: Counter[Sizes]
    of: int

    @property
    def valid(self) -> float:
        """The part of the draws that is valid."""
        return SAMPLE / self.of if self.of else 0.0

    @property
    def median(self) -> float:
        """The calculations of a usual variant; zero where there is none."""
        sizes = sorted(size for size, _, _ in self.works.elements())
        return 0.5 * (sizes[(len(sizes) - 1) // 2] + sizes[len(sizes) // 2]) if sizes else 0.0


@cache
def kept_samples() -> dict[str, WorkSample]:
    """The kept samples by their keys."""
    return {item["key"]: _sample(item) for item in _lines()}


@cache
def kept_medians() -> dict[tuple[str, str], float]:
    """The calculations of a usual variant by family and form of the catalogue, for all that the form asks."""
    return {(item["family"], item["form"]): _sample(item).median for item in reversed(_lines())}


def _sample(item: dict[str, Any]) -> WorkSample:
    return WorkSample(Counter({(size, *signs): count for count, size, *signs in item["works"]}), item["of"])


@cache
def _lines() -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads(KEPT.read_text("utf-8"))
    return found
