"""Output folders that are complete or not there."""

from __future__ import annotations

import os
import shutil
import signal
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

from variantgen.errors import InputError, Problem


def check_free(target: Path, force: bool) -> None:
    """Raise InputError if the target exists and may not be replaced, or cannot be made."""
    if target.exists() and not force:
        raise InputError(
            Problem(
                "the output folder exists",
                key="--out",
                value=str(target),
                remedy="choose another, or --force replaces it whole",
            )
        )
    if target.exists() and not target.is_dir():
        raise InputError(Problem("the output is a file, not a folder", key="--out", value=str(target)))
    parent = target.resolve().parent
    if not parent.is_dir():
        raise InputError(
            Problem("the parent folder does not exist", key="--out", value=str(parent), remedy="make it first")
        )
    if not os.access(parent, os.W_OK):
        raise InputError(Problem("the parent folder cannot be written to", key="--out", value=str(parent)))


@contextmanager
def whole_folder(target: Path, force: bool = False) -> Iterator[Path]:
    """A new folder beside the target that takes the target's name when the block ends without an error.

    An error, Ctrl-C or a termination signal removes it; if the process is killed outright, only a hidden folder
    ``.NAME.partial-*`` is left behind, which the next run removes.
    """
    check_free(target, force)
    target = target.resolve()
    for stale in target.parent.glob(f".{target.name}.partial-*"):
        shutil.rmtree(stale, ignore_errors=True)
    try:
        work = Path(tempfile.mkdtemp(prefix=f".{target.name}.partial-", dir=target.parent))
    except OSError as error:
        raise InputError(
            Problem(f"the output folder cannot be made: {error.strerror}", key="--out", value=str(target))
        ) from None
    work.chmod(0o755)
    previous = signal.signal(signal.SIGTERM, _terminate)
    try:
        yield work
        old = work.with_name(work.name + ".old")
        if target.exists():
            target.rename(old)
        work.rename(target)
        shutil.rmtree(old, ignore_errors=True)
    except OSError as error:
        if error.strerror is None:
            raise
        raise InputError(
            Problem(
                f"writing failed: {error.strerror}",
                key="--out",
                value=str(target),
                remedy="free some space or choose another folder",
            )
        ) from None
    finally:
        signal.signal(signal.SIGTERM, previous)
        shutil.rmtree(work, ignore_errors=True)


def _terminate(number: int, frame: FrameType | None) -> None:
    raise SystemExit(128 + number)
