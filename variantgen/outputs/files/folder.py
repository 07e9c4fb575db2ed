"""Output folders that are complete or not there."""

from __future__ import annotations

import glob
import os
import shutil
import signal
import tempfile
import threading
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import contextmanager
from fnmatch import fnmatchcase
from pathlib import Path
from types import FrameType

from variantgen.errors import InputError, Problem
from variantgen.outputs.files.edited import EDITED, file_hash, keep_edited

_SINGLY = 100  # files that are brought to the disk one by one, at some 5 ms each; of more, all at once is sooner

KnownFiles = Callable[[], Iterable[str]]


class WritingError(InputError):
    """The system refused to write: no room, no rights, no disk; or the place was taken in the meantime."""

    may_pass = True


def check_free(target: Path, force: bool, known: KnownFiles) -> None:
    """Raise InputError if the target exists and may not be replaced, or cannot be made.

    ``known`` says the files of an output, which may be replaced: names or patterns like ``figures/*.svg`` (a star
    stands for folders too). It is asked only where there is something to replace, and for no more than it takes.
    """
    if target.exists() and not target.is_dir():
        raise InputError(Problem("the output is a file, not a folder", key="--out", value=str(target)))
    if target.exists() and not force:
        remedy = "choose another, or --force replaces an earlier output"
        raise InputError(Problem("the output folder exists", key="--out", value=str(target), remedy=remedy))
    if target.exists():
        foreign = list(_foreign(target, _Asked(known())))
        if foreign or target.resolve() in (Path.cwd(), *Path.cwd().parents):
            remedy = "--force replaces only an empty folder or an earlier output; choose another folder"
            what = ", ".join(foreign[:3]) or "the working folder"
            raise InputError(
                Problem(
                    f"the output folder holds something else ({what})", key="--out", value=str(target), remedy=remedy
                )
            )
    parent = target.resolve().parent
    if not parent.is_dir():
        raise InputError(
            Problem("the parent folder does not exist", key="--out", value=str(parent), remedy="make it first")
        )
    if not os.access(parent, os.W_OK):
        raise InputError(Problem("the parent folder cannot be written to", key="--out", value=str(parent)))


class _Asked:
    """What an iterator gives, any number of times, taken from it only as far as somebody wants it."""

    def __init__(self, given: Iterable[str]) -> None:
        self._left, self._taken = iter(given), list[str]()

    def __iter__(self) -> Iterator[str]:
        yield from self._taken
        for item in self._left:
            self._taken.append(item)
            yield item


def _foreign(folder: Path, known: Iterable[str], within: str = "") -> Iterator[str]:
    """What a folder holds besides known files, and those that were kept because somebody had edited them."""
    for path in sorted(folder.iterdir()):
        name = within + path.name
        if name == EDITED and path.is_dir() and not path.is_symlink():
            continue
        inside = (p.startswith(f"{name}/") or fnmatchcase(f"{name}/", p) for p in known)
        if path.is_dir() and not path.is_symlink() and any(inside):
            yield from _foreign(path, known, f"{name}/")
        elif path.is_dir() or not any(fnmatchcase(name, pattern) for pattern in known):
            yield name


def file_hashes(folder: Path) -> dict[str, str]:
    """SHA-256 of all files below a folder by their paths in it, in the order of the alphabet."""
    found = {}
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        found[path.relative_to(folder).as_posix()] = file_hash(path)
    return found


@contextmanager
def whole_folder(
    target: Path,
    force: bool,
    known: KnownFiles,
    notes: list[str] | None = None,
    renewed: Collection[str] | None = None,
) -> Iterator[Path]:
    """A new folder beside the target that takes the target's name when the block ends without an error.

    An error, Ctrl-C or a termination signal removes it; if the process is killed outright, only a hidden folder
    ``.NAME.partial-*`` is left behind, which the next run removes. An earlier output that is being replaced keeps
    the name ``.NAME.replaced`` for the moment of the change; the next run ends the change if it was cut short.
    ``known`` says the files of an output (see :func:`check_free`). With ``notes``, for outputs that have a manifest,
    files that were edited are kept (see :func:`variantgen.outputs.files.edited.keep_edited`), and it is noted where;
    ``renewed``, which may be filled inside the block, are the only ones that the new folder does not have as they are.
    """
    target = target.resolve()
    replaced = target.with_name(f".{target.name}.replaced")
    _tidy(target, replaced, notes)
    _check_still_free(target, force, known)
    mine = f".{target.name}.partial-{os.getpid()}-"
    # The handler comes before the folder, so that no signal can find a folder that nobody would remove.
    with terminable(), writing(target):
        try:
            work = _made(target, mine)
            yield work
            _flush(work)
            _check_still_free(target, force, known)
            if target.exists():
                target.rename(replaced)
            work.rename(target)
            _finish(target, replaced, notes, renewed)
        finally:
            for left in target.parent.glob(f"{glob.escape(mine)}*"):
                shutil.rmtree(left, ignore_errors=True)


def _flush(folder: Path) -> None:
    """See to it that all files below a folder are on the disk: what they were made of is removed after that."""
    if os.name != "posix":
        return  # only files that are being written can be asked for it
    files = [path for path in folder.rglob("*") if path.is_file()]
    if len(files) > _SINGLY:
        os.sync()
        return
    for path in files:
        with path.open("rb") as file:
            os.fsync(file.fileno())


def _check_still_free(target: Path, force: bool, known: KnownFiles) -> None:
    """Raise WritingError if the target was taken since the work began: the work is not lost."""
    try:
        check_free(target, force, known)
    except InputError as error:
        raise WritingError(error.problems) from None


def _finish(target: Path, replaced: Path, notes: list[str] | None, renewed: Collection[str] | None = None) -> None:
    """Remove an output that was replaced, but for what somebody has edited in it."""
    if notes is not None and replaced.is_dir() and not replaced.is_symlink():
        notes += filter(None, [keep_edited(replaced, target, renewed)])
    if replaced.is_dir():
        # Under its name it would be taken for one with work in it if this is cut short.
        old = replaced.rename(target.with_name(f".{target.name}.partial-{os.getpid()}-replaced"))
        shutil.rmtree(old, ignore_errors=True)


@contextmanager
def terminable() -> Iterator[None]:
    """A termination signal ends the block as SystemExit does, so that what it has begun is cleared away."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    previous = signal.signal(signal.SIGTERM, _terminate)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, previous)


@contextmanager
def writing(target: Path) -> Iterator[None]:
    """Turn errors of the system inside the block into WritingError, which names the target."""
    try:
        yield
    except OSError as error:
        if error.strerror is None:
            raise
        remedy = "free some space or choose another folder"
        raise WritingError(
            Problem(f"writing failed: {error.strerror}", key="--out", value=str(target), remedy=remedy)
        ) from None


def _made(target: Path, prefix: str) -> Path:
    """A new folder beside the target."""
    try:
        work = Path(tempfile.mkdtemp(prefix=prefix, dir=target.parent))
    except OSError as error:
        raise WritingError(Problem(f"cannot be made: {error.strerror}", key="--out", value=str(target))) from None
    work.chmod(0o755)
    return work


def _tidy(target: Path, replaced: Path, notes: list[str] | None) -> None:
    """Clear away what a killed run has left beside the target, but nothing of a run that is still going on."""
    if replaced.is_dir() and not target.exists():
        replaced.rename(target)
    _finish(target, replaced, notes)
    for stale in target.parent.glob(f".{glob.escape(target.name)}.partial-*"):
        number = stale.name.split(".partial-")[1].split("-")[0]
        if not (number.isdigit() and _is_running(int(number))):
            shutil.rmtree(stale, ignore_errors=True)


def _is_running(process: int) -> bool:
    """Whether a process of that number exists (where the system can tell without harm)."""
    if os.name != "posix":
        return False
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True


def _terminate(number: int, frame: FrameType | None) -> None:
    raise SystemExit(128 + number)
