"""Picks one of the prepared variants of this question (variants.json) by the seed of the student's variant."""

import json
import math
from pathlib import Path


def generate(data: dict) -> None:
    """Fill in text, figure and answers of a variant: always the same one for a seed."""
    path = Path(data["options"]["question_path"]) / "variants.json"
    variants = json.loads(path.read_text(encoding="utf-8"))
    variant = variants[int(data["variant_seed"]) % len(variants)]
    data["correct_answers"].update(variant.pop("answers"))
    data["params"].update(variant)


def parse(data: dict) -> None:
    """Accept a decimal comma: 12,5 is 12.5."""
    for part in data["params"]["parts"]:
        name = part["name"]
        raw = data["raw_submitted_answers"].get(name) or ""
        if name not in data["format_errors"] or raw.count(",") != 1 or "." in raw:
            continue
        try:
            value = float(raw.replace(",", ".").replace("\N{MINUS SIGN}", "-"))
        except ValueError:
            continue
        if math.isfinite(value):
            data["submitted_answers"][name] = value
            del data["format_errors"][name]


def grade(data: dict) -> None:
    """Accept an angle that is written a turn away: near 180 degrees, -179.9 is as good as 180.1."""
    scores = data["partial_scores"]
    for part in data["params"]["parts"]:
        name = part["name"]
        submitted = data["submitted_answers"].get(name)
        if submitted is not None and any(low <= float(submitted) <= high for low, high in part["also"]):
            scores[name] = {**scores.get(name, {}), "score": 1}
            weights = [one.get("weight", 1) for one in scores.values()]
            points = [one.get("weight", 1) * (one["score"] or 0) for one in scores.values()]
            data["score"] = sum(points) / sum(weights)
