"""Edits change the lines of their keys and nothing else; what another has changed is not lost."""

from __future__ import annotations

import json
import os
import threading
import tomllib
from pathlib import Path

import pytest

from tests.studio.conftest import EXAM
from variantgen.errors import InputError, Problem
from variantgen.studio.documents.document import ChangedSinceError, ConflictError, Document, RefusedError
from variantgen.studio.documents.edits import apply, read_operations
from variantgen.studio.documents.mistakes import Mistake
from variantgen.studio.documents.toml_lines import parse_path, places

TRICKY = '''\
title = "a [[problem]] in a \\"text\\" # no comment"   # a comment
notes = """
[[problem]]
family = "no"
"""

# about the first
[[problem]]
family = 'four_bar'
range = { phi = [30, 60], OA = [20, 40] } # both
ask = [   # of it
    "v_B",  # ]
]

# about the second
[[problem]]
family = "spool"
range.R = [1, 2]
[problem.tolerance]
floor = 0.02

[page]
duplex = true
'''


def changed(text: str, **operation: object) -> str:
    return apply(text, read_operations([operation]))


@pytest.mark.parametrize(
    ("operation", "gone", "new"),
    [
        ({"op": "set", "path": "problem[1].range.phi", "value": [45, 60.5]}, "phi = [30, 60]", "phi = [45, 60.5]"),
        ({"op": "set", "path": "problem[2].range.R", "value": [1, 3]}, "range.R = [1, 2]", "range.R = [1, 3]"),
        ({"op": "set", "path": "problem[2].range.r", "value": [1, 3]}, "", "range.r = [1, 3]\n"),
        ({"op": "set", "path": "problem[2].tolerance.floor", "value": 0.03}, "floor = 0.02", "floor = 0.03"),
        ({"op": "set", "path": "problem[1].ask", "value": ["a_B"]}, '[   # of it\n    "v_B",  # ]\n]', '["a_B"]'),
        ({"op": "set", "path": "problem[1].nice", "value": True}, "", "nice = true\n"),
        ({"op": "set", "path": "page.qr", "value": False}, "", "qr = false\n"),
        ({"op": "set", "path": "seed", "value": "при\n\"x\""}, "", 'seed = "при\\n\\"x\\""\n'),
        ({"op": "unset", "path": "problem[2].range"}, "range.R = [1, 2]\n", ""),
        ({"op": "unset", "path": "problem[2].tolerance"}, "[problem.tolerance]\nfloor = 0.02\n", ""),
    ],
)  # fmt: skip
def test_one_key_changes_and_every_other_byte_stays(operation: dict[str, object], gone: str, new: str) -> None:
    found = changed(TRICKY, **operation)
    assert new in found
    assert found.replace(new, "", 1) == TRICKY.replace(gone, "", 1)


def test_problems_move_with_the_comments_above_them() -> None:
    found = changed(TRICKY, op="move", path="problem[2]", to=1)
    assert found.index("# about the second\n[[problem]]") < found.index("# about the first\n[[problem]]")
    data = tomllib.loads(found)
    assert [problem["family"] for problem in data["problem"]] == ["spool", "four_bar"]
    assert data["problem"][0]["tolerance"] == {"floor": 0.02} and data["page"] == {"duplex": True}
    assert "# both" in found and "# ]" in found


def test_problems_come_and_go() -> None:
    found = changed(EXAM, op="insert", path="problem", at=2, value={"family": "ladder", "points": 3})
    assert [p["family"] for p in tomllib.loads(found)["problem"]] == ["four_bar", "ladder", "spool"]
    for _ in range(3):
        found = changed(found, op="remove", path="problem[1]")
    assert "problem" not in tomllib.loads(found)
    assert "# The first exam of the year." in found


@pytest.mark.parametrize(
    "given",
    [
        None, [], [{}], [{"op": "eval", "path": "x"}], [{"op": "set", "path": ""}], [{"op": "remove", "path": "title"}],
        [{"op": "set", "path": "problem[9].points", "value": 1}], [{"op": "set", "path": "title.x.y", "value": 1}],
        [{"op": "move", "path": "problem[7]", "to": 1}], [{"op": "set", "path": "x", "value": None}],
        [{"op": "insert", "path": "problem", "at": 1, "value": "no table"}],
    ],
)  # fmt: skip
def test_operations_that_do_not_fit_are_refused(given: object) -> None:
    with pytest.raises(InputError):
        apply(EXAM, read_operations(given))


def test_lines_of_keys_are_found() -> None:
    found = places(TRICKY)
    assert found.line(parse_path("problem[1].ask")) == 11
    assert found.line(parse_path("problem[2].range.R")) == 18
    assert found.line(parse_path("problem[2].range")) == 18
    assert found.line(parse_path("problem[2].tolerance.floor")) == 20
    assert found.line(parse_path("problem[2].missing")) == 16


def test_a_removed_problem_takes_no_comment_that_stands_by_itself() -> None:
    text = EXAM.replace("points = 10\n", "points = 10\n\n# Part two\n")
    assert "# Part two" in changed(text, op="remove", path="problem[1]")
    assert "# Part two" in changed(text, op="remove", path="problem[2]")


def test_ends_of_lines_and_the_mark_of_byte_order_stay(folder: Path) -> None:
    path = folder / "exam.toml"
    path.write_bytes(b"\xef\xbb\xbf" + EXAM.replace("\n", "\r\n").encode())
    exam = document(folder)
    exam.edit(read_operations([{"op": "set", "path": "problem[1].nice", "value": False}]), exam.state().version)
    exam.replace(exam.state().text.replace("points = 5", "points = 6"), exam.state().version)
    new = EXAM.replace("points = 10\n", "points = 10\nnice = false\n").replace("points = 5", "points = 6")
    assert path.read_bytes() == b"\xef\xbb\xbf" + new.replace("\n", "\r\n").encode()


def document(folder: Path) -> Document:
    return Document("exam", folder / "exam.toml", folder, folder / ".studio" / "journal")


def points(number: int, value: int) -> object:
    return read_operations([{"op": "set", "path": f"problem[{number}].points", "value": value}])


def test_two_windows_lose_nothing(folder: Path) -> None:
    exam = document(folder)
    start = exam.state().version
    exam.edit(points(1, 11), start)
    exam.edit(points(2, 6), start)  # another key of an older version
    with pytest.raises(ConflictError) as conflict:
        exam.edit(points(1, 12), start)
    assert (conflict.value.mine, conflict.value.theirs) == (12, 11)
    assert (folder / "exam.toml").read_text() == EXAM.replace("points = 10", "points = 11").replace(
        "points = 5", "points = 6"
    )


def test_undo_and_redo_go_through_restarts_and_editors(folder: Path) -> None:
    path, exam = folder / "exam.toml", document(folder)
    exam.edit(points(1, 11), exam.state().version)
    by_hand = path.read_text().replace("Homework", "Homework 2")
    path.write_text(by_hand)
    exam = document(folder)  # the studio was restarted
    assert exam.journal.undoable and exam.journal.undoable.words == "outside"
    path.write_text(by_hand + "# end\n")
    assert exam.state().text.endswith("# end\n")
    outside = exam.undo()
    assert outside and outside.words == "outside"
    assert path.read_text() == by_hand
    assert exam.undo(+1) and path.read_text() == by_hand + "# end\n"
    assert exam.undo() and exam.undo() and path.read_text() == EXAM.replace("points = 10", "points = 11")
    assert exam.undo() and path.read_text() == EXAM
    assert exam.undo() is None
    for _ in range(3):
        exam.undo(+1)
    assert path.read_text() == by_hand + "# end\n"


@pytest.mark.parametrize("wrong", [{"about": 5}, {"before": 5}, {"words": []}, {"time": "x"}, {"about": {"a": []}}])
def test_a_damaged_journal_counts_as_none(folder: Path, wrong: dict[str, object]) -> None:
    exam = document(folder)
    exam.edit(points(1, 11), exam.state().version)
    kept = folder / ".studio" / "journal" / "journal.json"
    data = json.loads(kept.read_text())
    data["steps"][0] |= wrong
    kept.write_text(json.dumps(data))
    assert document(folder).undo() is None


def test_undo_keeps_what_no_clock_has_noticed(folder: Path) -> None:
    path, exam = folder / "exam.toml", document(folder)
    exam.edit(points(1, 11), exam.state().version)
    version = exam.state().version
    stamp, by_hand = path.stat(), path.read_text().replace("Homework", "homework")
    path.write_text(by_hand)
    os.utime(path, ns=(stamp.st_atime_ns, stamp.st_mtime_ns))
    with pytest.raises(ConflictError):
        exam.undo(version=version)
    assert path.read_text() == by_hand
    assert exam.undo() and exam.undo(+1) and path.read_text() == by_hand


def test_the_exam_is_there_while_a_deed_is_taken_back(folder: Path) -> None:
    """As where scans are read for it; what is edited meanwhile stays, and is the step that undo takes back then."""
    exam, begun, go_on = document(folder), threading.Event(), threading.Event()

    def slow(deed: dict[str, str], by: int) -> dict[str, str]:
        begun.set()
        assert go_on.wait(20)
        return {**deed, "by": str(by)}

    def during(by: int) -> None:
        undo = threading.Thread(target=exam.undo, args=(by, None, slow))
        undo.start()
        assert begun.wait(20)
        other = threading.Thread(target=lambda: exam.edit(points(1, 12 + by), exam.state().version))
        other.start()
        other.join(20)
        stays = other.is_alive()
        with pytest.raises(InputError, match="another step"):
            exam.undo()
        go_on.set()
        undo.join(20)
        assert not stays
        begun.clear(), go_on.clear()

    exam.note("answer_said", {}, {"kind": "answer"})
    during(-1)
    assert [step.words for step in exam.journal.steps] == ["changed_in_problem"] and exam.journal.done == 1
    exam.note("answer_said", {}, {"kind": "answer"})
    assert exam.undo(change=lambda deed, by: deed)
    during(+1)
    assert exam.journal.undoable and exam.journal.undoable.deed == {"kind": "answer", "by": "1"}
    assert exam.journal.done == len(exam.journal.steps)
    assert exam.undo(change=lambda deed, by: deed) and exam.undo() and "points = 13" not in exam.state().text


def test_undo_takes_back_the_step_that_was_seen(folder: Path) -> None:
    """Two windows press undo of the same answer, or one of them types another: the text of the exam is the same."""
    exam = document(folder)
    version = exam.state().version

    def moved(by: int, position: str) -> bool:
        return exam.undo(by, version, lambda deed, by: deed, position) is not None

    exam.note("answer_said", {}, {"kind": "answer", "after": "1"})
    one = exam.journal.position
    exam.note("answer_said", {}, {"kind": "answer", "after": "2"})
    two = exam.journal.position
    with pytest.raises(ConflictError):
        moved(-1, one)
    assert moved(-1, two)
    with pytest.raises(ConflictError):
        moved(-1, two)
    assert exam.journal.done == 1 and moved(+1, exam.journal.position) and exam.journal.position == two


@pytest.mark.parametrize(("error", "left"), [(InputError, 1), (ChangedSinceError, 0)])
def test_only_what_others_have_changed_is_struck_out(folder: Path, error: type[InputError], left: int) -> None:
    """A fault that passes, as a link in the way, leaves the step: its remedy helps."""
    exam = document(folder)
    exam.note("class_list", {}, {"kind": "list"})

    def refused(deed: dict[str, str], by: int) -> dict[str, str]:
        raise error(Problem("is a link", remedy="remove it"))

    with pytest.raises(error):
        exam.undo(change=refused)
    assert len(exam.journal.steps) == left
    assert (exam.undo(change=lambda deed, by: deed) is not None) == bool(left)


@pytest.mark.parametrize("second", ["spool", "four_bar"])
@pytest.mark.parametrize(
    "meanwhile",
    [
        {"op": "move", "path": "problem[2]", "to": 1},
        {"op": "insert", "path": "problem", "at": 1, "value": {"family": "spool", "points": 9}},
        {"op": "remove", "path": "problem[1]"},
    ],
)
def test_an_edit_never_meets_another_problem(folder: Path, meanwhile: dict[str, object], second: str) -> None:
    """The points of both are the same, so that the value at the path does not tell that the problem is another."""
    text = EXAM.replace("points = 10", "points = 5").replace('"spool"', f'"{second}"')
    (folder / "exam.toml").write_text(text)
    exam = document(folder)
    start = exam.state().version
    exam.edit(read_operations([meanwhile]), start)
    for number in (1, 2):
        with pytest.raises(ConflictError) as conflict:
            exam.edit(points(number, 99), start)
        assert conflict.value.moved
    assert "99" not in (folder / "exam.toml").read_text()


def test_what_an_editor_saves_during_an_edit_stays(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, exam = folder / "exam.toml", document(folder)
    checked, saves = exam.check, ["# saved by an editor\n"]

    def slow(text: str) -> list[Mistake]:
        found = checked(text)
        if saves:
            path.write_text(path.read_text() + saves.pop())
        return found

    monkeypatch.setattr(exam, "check", slow)
    exam.edit(points(1, 13), exam.state().version)
    assert path.read_text() == EXAM.replace("points = 10", "points = 13") + "# saved by an editor\n"
    saves.append("# again\n")
    with pytest.raises(ConflictError):
        exam.replace(EXAM, exam.state().version)
    assert path.read_text().endswith("# again\n")


def test_what_would_break_the_file_is_not_written(folder: Path) -> None:
    exam = document(folder)
    for operations in (
        [{"op": "set", "path": "problem[1].family", "value": "four_baar"}],
        [{"op": "set", "path": "problem[1].range.phi", "value": [90, 30]}],
        [{"op": "set", "path": "problem[1].ask", "value": []}],
        [{"op": "set", "path": "points", "value": 3}],
    ):
        with pytest.raises(RefusedError) as refused:
            exam.edit(read_operations(operations), exam.state().version)
    with pytest.raises(RefusedError) as refused:
        exam.replace(EXAM.replace("points = 5", "points = \n"), exam.state().version)
    assert refused.value.problems[0].line == 15
    with pytest.raises(RefusedError) as refused:
        exam.replace(EXAM.replace("points = 5", "pionts = 5"), exam.state().version)
    assert refused.value.problems[0].line == 15 and "points" in refused.value.problems[0].remedy
    assert (folder / "exam.toml").read_text() == EXAM
