"""What marks say in words, for pages and workbooks."""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.marking.diagnosis.causes import Cause
from variantgen.wording.distractors import mistake_text
from variantgen.wording.language import Language


def cause_in_words(
    cause: Cause | None, words: Mapping[str, str], language: Language, symbols: Mapping[str, str]
) -> str:
    """A cause in the language of the exam; ``words`` are those of its table ``[marking]``, ``symbols`` of the form."""
    if cause is None:
        return ""
    if cause.name == "mistake":
        return f"{words['cause.mistake']}: {mistake_text(cause.detail, language, symbols)}"
    text = words[f"cause.{cause.name}"]
    return f"{text}: {cause.detail}" if cause.detail and cause.name in ("from", "other_answer") else text
