"""The hidden folder of the parts for one build alone: nobody else's folder is taken for it, and no link is followed."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from variantgen.errors import InputError, Problem

PLAN, DRAWN_MARKS, LOCK = "plan.json", "settled.json", "lock"
DRAWN, CHANGED, MADE = FOLDERS = ("drawn", "changed", "made")
NEW = ".new"  # ending of a file that is being written
PIECE = r"\d{7,9}-\d{3,7}(\.[a-z]{1,8})?"  # the name of a piece in ``made``
_NAMES = re.compile(
    rf"({LOCK}|({PLAN}|{DRAWN_MARKS}|({DRAWN}|{CHANGED})/\d{{7,9}}-\d{{1,6}}|{MADE}/(\d{{7,9}}\.json|{PIECE}))({NEW})?)"
)
_TRIES = 100  # of getting the lock while another build is removing it
# Systems without one of these have no such links or files.
_CAREFULLY = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)


@contextmanager
def locked_folder(folder: Path, target: Path) -> Iterator[None]:
    """The folder for this process alone, where the system has locks that end with a process.

    If it holds nothing at the end of the block, it is removed before it is given up. Raises InputError if another
    process has it, or if it is not such a folder of this user: a link, or with anything in it that no build puts there.
    """
    lock = _lock(folder, target)
    try:
        yield
    finally:
        if os.name == "nt":  # which removes no file that is open
            os.close(lock)
        _remove_if_bare(folder)
        if os.name != "nt":
            os.close(lock)


def empty(folder: Path) -> None:
    """Remove everything but the lock, as far as it can be; the plan is the last: without it the rest would be nobody's.

    No folder is emptied that is not one of parts: what came into it since stays.
    """
    for name in FOLDERS:
        for path in (folder / name).glob("*"):
            with suppress(OSError):
                path.unlink()
        with suppress(OSError):
            (folder / name).rmdir()
    for name in (f"{DRAWN_MARKS}{NEW}", f"{PLAN}{NEW}", DRAWN_MARKS, PLAN):
        with suppress(OSError):
            (folder / name).unlink(missing_ok=True)


def _lock(folder: Path, target: Path) -> int:
    """The descriptor of the locked file in the folder, which is made if it is not there."""
    for _ in range(_TRIES):
        made = True
        try:  # an interrupt may come as soon as the folder is there
            try:
                folder.mkdir(mode=0o700)
            except FileExistsError:
                made = False
                _check_ours(folder)
            except OSError as error:
                made = False
                raise InputError(Problem(f"cannot be made: {error.strerror}", key="--out", value=str(target))) from None
            file = _locked(folder, target)
        except BaseException:
            if made:
                _remove_again(folder, target)
            raise
        if file is not None:
            return file
    raise InputError(Problem("the folder of its parts comes and goes", key="--out", value=str(target)))


def _locked(folder: Path, target: Path) -> int | None:
    """The descriptor of the locked file, which is made if it is not there; None if the build that had it removed it."""
    try:
        file = os.open(folder / LOCK, os.O_RDWR | os.O_CREAT | _CAREFULLY, 0o600)
    except FileNotFoundError:
        return None
    try:
        if not _is_locked(file):
            remedy = "wait until it is done, or choose another folder"
            raise InputError(
                Problem("another build is making this folder now", key="--out", value=str(target), remedy=remedy)
            )
        is_still = _is_still(folder / LOCK, file)
    except BaseException:
        os.close(file)
        raise
    if is_still:
        return file
    os.close(file)
    return None


def _remove_again(folder: Path, target: Path) -> None:
    """Remove a folder that was made for a build which was interrupted at once, if no other build has begun in it."""
    with suppress(OSError, InputError):
        file = _locked(folder, target)
        if file is not None:
            _remove_if_bare(folder)
            os.close(file)


def _remove_if_bare(folder: Path) -> None:
    """Remove a folder that holds nothing but the lock, which the caller has."""
    with suppress(OSError):
        if [path.name for path in folder.iterdir()] == [LOCK]:
            (folder / LOCK).unlink()
            folder.rmdir()  # fails if another build has begun in it, which is right


def _is_locked(file: int) -> bool:
    """Lock a file, if nobody else has; where the system or the disk has no locks, it is taken to be free."""
    try:
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    except (ImportError, OSError):
        pass
    return True


def _is_still(path: Path, file: int) -> bool:
    """Whether the file of this name is still the one that is open: whoever had it may have removed it."""
    try:
        return os.path.samestat(path.lstat(), os.fstat(file))
    except FileNotFoundError:
        return False


def _check_ours(folder: Path) -> None:
    """Raise InputError if a folder is none of this user with nothing in it but the parts of a build."""
    try:
        what = _foreign(folder)
    except FileNotFoundError:
        return  # being removed by the build that had it
    if what:
        remedy = "a build keeps its parts under this name: move what is there away, or choose another --out"
        raise InputError(Problem(what, key="--out", value=str(folder), remedy=remedy))


def _foreign(folder: Path) -> str:
    """Why a folder is not one of parts, in words; empty if it is one."""
    found = folder.lstat()
    if not stat.S_ISDIR(found.st_mode):
        return "there is a link or a file where the parts of the build should be"
    if hasattr(os, "geteuid") and found.st_uid != os.geteuid():
        return "the folder for the parts of the build belongs to another user"
    names: set[str] = set()
    for top in (folder, *(folder / name for name in FOLDERS)):
        if top is not folder and not os.path.lexists(top):
            continue
        with os.scandir(top) as entries:
            for entry in entries:
                name = entry.name if top is folder else f"{top.name}/{entry.name}"
                if entry.is_dir(follow_symlinks=False) and name in FOLDERS:
                    continue
                if not (entry.is_file(follow_symlinks=False) and _NAMES.fullmatch(name)):
                    return f"the folder for the parts of the build holds something else ({name})"
                names.add(name)
    plans = {PLAN, f"{PLAN}{NEW}"}
    # Another build may have made or removed its plan meanwhile.
    if names - {LOCK} and not names & plans and not any(os.path.lexists(folder / name) for name in plans):
        return "the folder for the parts of the build has no plan of one"
    return ""
