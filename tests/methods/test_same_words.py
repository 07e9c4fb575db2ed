"""A solution is the same text in every process, whatever the order in which Python keeps sets there."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

SCENES = Path(__file__).parents[1] / "textbook_kinds"
# Ties between ways of equal price, points at equal distances, several letters at once.
NAMES = ("peaucellier", "scissor_lift", "pantograph", "two_stage_hoist")
WRITE = """
import sys
import variantgen
from variantgen.single import one_variant
for path in sys.argv[1:]:
    print(variantgen.explain(one_variant(path)))
"""


def _written(seed: str) -> str:
    command = [sys.executable, "-c", WRITE, *(str(SCENES / f"{name}.toml") for name in NAMES)]
    environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONIOENCODING": "utf-8"}
    return subprocess.run(command, env=environment, capture_output=True, check=True, encoding="utf-8").stdout


def test_a_solution_does_not_depend_on_the_order_of_sets() -> None:
    texts = {_written(seed) for seed in ("1", "2", "6")}
    (text,) = texts
    assert text.count("Answer") >= len(NAMES)
