"""What lies in the place of finished parts is not trusted: damage is made again, what is foreign is left alone."""

from __future__ import annotations

import errno
import json
import os
import random
import shutil
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.builder.small_exams import content, exam
from variantgen.builder import build, unfinished_folder
from variantgen.builder.folder_lock import locked_folder
from variantgen.builder.kept import KeptParts
from variantgen.builder.sealed import digest, write
from variantgen.builder.unfinished import Unfinished
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.roster import numbered

# Few variants: some students draw again, so that there are changed parts; two parts.
TEXT = (
    'title = "T"\nlanguage = "en"\nformats = ["html", "prairielearn"]\n[solutions]\ndepth = "none"\n'
    '[[problem]]\nfamily = "spool"\nask = ["v_O"]\n'
    'set = { thread = "above", a_B = 100, v_B = 40 }\nrange = { r = [18, 26], R = [40, 60] }\n'
)
STUDENTS = 20
FLIPS = 6


class StoppedError(Exception):
    """Somebody pulled the plug."""


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, bytes], Path]:
    """The output of a build that nobody disturbed, and the folder of one that was stopped when all parts were made."""
    folder = tmp_path_factory.mktemp("finished")
    redrawn = build(exam(folder, TEXT), numbered(STUDENTS), folder / "out").redrawn
    assert redrawn, "there are changed parts to be damaged"
    whole = content(folder / "out")
    shutil.rmtree(folder / "out")

    def progress(stage: str, done: int, total: int) -> None:
        if stage == "typesetting" and done == total:
            raise StoppedError

    with pytest.raises(StoppedError):
        build(exam(folder, TEXT), numbered(STUDENTS), folder / "out", progress=progress)
    return whole, folder


@pytest.fixture
def stopped(finished: tuple[dict[str, bytes], Path], tmp_path: Path) -> Path:
    """A copy of the stopped build: its exam file has another path, which is no part of what is built."""
    shutil.copytree(finished[1], tmp_path, dirs_exist_ok=True)
    plan = json.loads((unfinished_folder(tmp_path / "out") / "plan.json").read_bytes().split(b"\n", 1)[1])
    assert plan["seed"]
    return tmp_path


def resumed(folder: Path, original: Path) -> dict[str, bytes]:
    """The output after going on."""
    # The plan names the exam file, so the exam is read where it was.
    build(exam(original, TEXT), numbered(STUDENTS), folder / "out", resume=True)
    found = content(folder / "out")
    shutil.rmtree(folder / "out")
    assert not unfinished_folder(folder / "out").exists()
    return found


def parts(folder: Path) -> list[Path]:
    """The files of the parts, all kinds."""
    found = sorted(p for p in unfinished_folder(folder / "out").rglob("*") if p.is_file() and p.name != "lock")
    kinds = {path.relative_to(unfinished_folder(folder / "out")).parts[0] for path in found}
    assert kinds == {"plan.json", "settled.json", "drawn", "changed", "made"}
    return found


def test_the_copy_goes_on(finished: tuple[dict[str, bytes], Path], stopped: Path) -> None:
    whole, original = finished
    assert resumed(stopped, original) == whole


@pytest.mark.parametrize("kind", ["plan.json", "settled.json", "drawn/*", "changed/*", "made/*.json", "made/*.html"])
@pytest.mark.parametrize("damage", ["emptied", "cut", "removed", "swapped"])
def test_a_damaged_part_is_made_again(
    kind: str, damage: str, finished: tuple[dict[str, bytes], Path], stopped: Path
) -> None:
    whole, original = finished
    assert parts(stopped)
    found = sorted(unfinished_folder(stopped / "out").glob(kind))
    victim, old = found[0], found[0].read_bytes()
    if damage == "emptied":
        victim.write_bytes(b"")
    elif damage == "cut":
        victim.write_bytes(old[: len(old) * 2 // 3])
    elif damage == "removed" and kind != "plan.json":  # what has no plan is nobody's
        victim.unlink()
    elif damage == "swapped" and len(found) > 1:
        victim.write_bytes(found[1].read_bytes())
        found[1].write_bytes(old)
    assert resumed(stopped, original) == whole


def test_bits_that_flip_anywhere(finished: tuple[dict[str, bytes], Path], tmp_path: Path) -> None:
    whole, original = finished
    dice = random.Random(3)
    for number in range(FLIPS):
        folder = tmp_path / str(number)
        shutil.copytree(original, folder)
        for kind in ("plan.json", "settled.json", "drawn/*", "changed/*", "made/*"):
            victim = dice.choice(sorted(unfinished_folder(folder / "out").glob(kind)))
            data = bytearray(victim.read_bytes())
            data[dice.randrange(len(data))] ^= 1 << dice.randrange(8)
            victim.write_bytes(data)
        assert resumed(folder, original) == whole


def test_parts_that_are_whole_are_not_made_again(
    finished: tuple[dict[str, bytes], Path], stopped: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole, original = finished
    made: list[int] = []
    real = KeptParts.put_made
    monkeypatch.setattr(
        KeptParts, "put_made", lambda self, number, *found: (made.append(number), real(self, number, *found))
    )
    (unfinished_folder(stopped / "out") / "drawn" / "0000000-0").write_bytes(b"")
    assert resumed(stopped, original) == whole
    assert not {0, 1} & set(made), "only the overviews were missing"


def entry(folder: Path, original: Path, change: Callable[[list[str]], None], name: str = "0000000") -> None:
    """Plant an entry in a list of pieces, sealed as the program itself would."""
    hidden = unfinished_folder(folder / "out")
    plan = json.loads((hidden / "plan.json").read_bytes().split(b"\n", 1)[1])
    key = Unfinished(hidden, plan, ())._key
    listed = json.loads((hidden / "made" / f"{name}.json").read_bytes().split(b"\n", 1)[1])
    change(listed["pieces"])
    write(hidden, f"made/{name}.json", json.dumps(listed).encode(), key)


OWN = b"not yours"


@pytest.mark.parametrize(
    "target",
    [
        "{0}",
        "x/../../{1}",
        "../{1}",
        "spool-1-0/clientFilesQuestion/../../../../../{1}",
        "other-1/clientFilesQuestion/" + "0" * 20 + ".svg",
    ],
)
@pytest.mark.parametrize("output", ["prairielearn", "pdf", "html", "records", "../x", 5])
def test_a_planted_target_is_not_written(
    target: str, output: str | int, finished: tuple[dict[str, bytes], Path], stopped: Path
) -> None:
    whole, original = finished
    victim = stopped / "victim"
    hidden = unfinished_folder(stopped / "out")
    (hidden / "made" / "0000000-900").write_bytes(OWN)
    wanted = target.format(victim, "victim")
    entry(stopped, original, lambda found: found.append([output, wanted, "0000000-900", digest(OWN)]))
    assert resumed(stopped, original) == whole
    assert not victim.exists()


@pytest.mark.parametrize("name", ["{0}", "../../secret", "0000001-000.html", "0000000-000.html/../../secret"])
def test_a_planted_piece_from_outside_is_not_read(
    name: str, finished: tuple[dict[str, bytes], Path], stopped: Path
) -> None:
    whole, original = finished
    secret = stopped / "secret"
    secret.write_bytes(OWN)
    named = name.format(secret)
    entry(stopped, original, lambda found: found.append(["records", "key.csv", named, digest(OWN)]))
    assert resumed(stopped, original) == whole
    assert secret.read_bytes() == OWN


def folders(kind: str, hidden: Path, victim: Path) -> None:
    """Put something in the place of the parts."""
    if kind == "link":
        hidden.symlink_to(victim)
        return
    if kind == "file":
        hidden.write_bytes(OWN)
        return
    hidden.mkdir()
    if kind == "lock":
        (hidden / "lock").symlink_to(victim / "file")
    elif kind == "inner link":
        (hidden / "plan.json").write_text("{}")
        (hidden / "drawn").symlink_to(victim)
    elif kind == "linked part":
        (hidden / "plan.json").write_text("{}")
        (hidden / "drawn").mkdir()
        (hidden / "drawn" / "0000000-0").symlink_to(victim / "file")
    elif kind == "someone's":
        (hidden / "thesis.tex").write_bytes(OWN)
    elif kind == "someone's in ours":
        (hidden / "plan.json").write_text("{}")
        (hidden / "made").mkdir()
        (hidden / "made" / "thesis.tex").write_bytes(OWN)
    elif kind == "no plan":
        (hidden / "drawn").mkdir()
        (hidden / "drawn" / "0000000-0").write_bytes(OWN)
    elif kind == "pipe":
        os.mkfifo(hidden / "lock")


@pytest.mark.parametrize("resume", [False, True])
@pytest.mark.parametrize(
    "kind",
    ["link", "file", "lock", "inner link", "linked part", "someone's", "someone's in ours", "no plan", "pipe"],
)
def test_what_is_no_folder_of_parts_is_left_alone(
    kind: str, resume: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    victim, hidden = tmp_path / "victim", tmp_path / ".out.unfinished"
    victim.mkdir()
    (victim / "file").write_bytes(OWN)
    (victim / "drawn").mkdir()
    (victim / "drawn" / "mine").write_bytes(OWN)
    folders(kind, hidden, victim)
    before = content(tmp_path)
    arguments = ["build", "sample_en", "--variants", "1", "--out", str(tmp_path / "out"), "--no-solutions"]
    assert main([*arguments, "--resume"] if resume else arguments) == 2
    output = capsys.readouterr().err
    assert str(hidden) in output
    assert "move what is there away" in output
    assert content(tmp_path) == before
    assert not (tmp_path / "out").exists()


def test_the_folder_of_another_user(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / ".out.unfinished").mkdir()
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    with pytest.raises(InputError, match="another user"), locked_folder(tmp_path / ".out.unfinished", tmp_path / "out"):
        pass


def test_an_output_that_appears_during_the_build_does_not_cost_the_parts(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "exam.toml").write_text(TEXT, "utf-8")
    out = tmp_path / "out"

    def progress(stage: str, done: int, total: int) -> None:
        out.mkdir(exist_ok=True)

    with pytest.raises(InputError, match="exists"):
        build(exam(tmp_path, TEXT), numbered(STUDENTS), out, progress=progress)
    made = unfinished_folder(out) / "made"
    assert {"0000000.json", "0000001.json"} <= {path.name for path in made.iterdir()}
    arguments = ["build", str(tmp_path / "exam.toml"), "--variants", str(STUDENTS), "--out", str(out), "--resume"]
    assert main(arguments) == 2, "it is still there"
    assert made.is_dir()
    out.rmdir()
    capsys.readouterr()
    assert main(arguments) == 0


def test_a_disk_without_locks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import fcntl

    def refused(*_: object) -> None:
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(fcntl, "flock", refused)
    with locked_folder(tmp_path / ".out.unfinished", tmp_path / "out"):
        assert (tmp_path / ".out.unfinished").is_dir()
    assert list(tmp_path.iterdir()) == []


def test_the_lock_is_held_until_the_folder_is_gone(tmp_path: Path) -> None:
    """Two that take turns never have the folder at the same time, and none removes it under the other."""
    folder = tmp_path / ".out.unfinished"
    inside: list[int] = []
    clashes: list[str] = []
    turns = [0, 0]

    def take(who: int) -> None:
        while turns[who] < 60:
            try:
                with locked_folder(folder, tmp_path / "out"):
                    inside.append(who)
                    if len(inside) > 1:
                        clashes.append("two at once")
                    (folder / "plan.json").write_text(str(who))
                    if (folder / "plan.json").read_text() != str(who):
                        clashes.append("another one's plan")
                    (folder / "plan.json").unlink()
                    inside.remove(who)
                turns[who] += 1
            except InputError as error:
                if "another build" not in str(error) and "comes and goes" not in str(error):
                    clashes.append(str(error))
            except OSError as error:
                clashes.append(str(error))

    threads = [threading.Thread(target=take, args=(who,)) for who in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    assert clashes == []
    assert turns == [60, 60]
    assert not folder.exists()
