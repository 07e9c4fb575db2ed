"""What the commands write to the terminal, and the table of characters that cannot be seen."""

from __future__ import annotations

import io
import json
import sys

import pytest

from variantgen.cli.messages import counted, say, tell
from variantgen.letters import named, spelled_out, unseen


def test_results_and_messages_have_streams_of_their_own(capsys: pytest.CaptureFixture[str]) -> None:
    say("v_B = 3")
    tell("1 sheet in out")
    assert capsys.readouterr() == ("v_B = 3\n", "1 sheet in out\n")


def test_escape_sequences_are_spelled_out(capsys: pytest.CaptureFixture[str]) -> None:
    for write in (say, tell):
        write("title \x1b[2J\x1b]0;gone\x07 \x9b31m \x7f\r\t\u202e\u2028 end\nnext line")
    wanted = r"title \u001b[2J\u001b]0;gone\u0007 \u009b31m \u007f\u000d\u0009\u202e\u2028 end" + "\nnext line\n"
    assert capsys.readouterr() == (wanted, wanted)


def test_a_document_stays_the_same_document(capsys: pytest.CaptureFixture[str]) -> None:
    document = {"title": "Ёлкин \x9b\x7f\x1b \ud800 \U000e0001 \ue000", "value": [1.5, None]}
    say(json.dumps(document, ensure_ascii=False, indent=1))
    written = capsys.readouterr().out
    assert json.loads(written) == document
    assert not unseen(written, allowed="\n")


def test_letters_that_a_terminal_lacks_stop_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    narrow = io.TextIOWrapper(io.BytesIO(), encoding="ascii", newline="")
    monkeypatch.setattr(sys, "stdout", narrow)
    say("угол \N{GREEK SMALL LETTER PHI}")
    assert narrow.buffer.getvalue() == rb"\u0443\u0433\u043e\u043b \u03c6" + b"\n"  # type: ignore[attr-defined]


@pytest.mark.parametrize(("number", "text"), [(0, "0 sheets"), (1, "1 sheet"), (2, "2 sheets"), (21, "21 sheets")])
def test_counts(number: int, text: str) -> None:
    assert counted(number, "sheet") == text


def test_a_plural_of_its_own() -> None:
    assert (counted(1, "family", "families"), counted(3, "family", "families")) == ("1 family", "3 families")


@pytest.mark.parametrize("text", ["plain", "Ёлкин", "हिन्दी", "\u200dZWJ", "№ 5 — 30°\u00a0см", "学生"])
def test_letters_of_all_scripts_can_be_seen(text: str) -> None:
    assert unseen(text) == {}
    assert spelled_out(text) == text


def test_what_is_unseen_is_named() -> None:
    assert unseen("a\u200bb\x07\ud800c") == {
        "\u200b": "an invisible character",
        "\x07": "a control character",
        "\ud800": "half of a character",
    }
    assert named("\u200b") == "U+200B ZERO WIDTH SPACE"
    assert named("\ue000") == "U+E000"
