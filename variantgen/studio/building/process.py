"""A build in a process of its own: told what to build on its input, it tells how far it is on its output, as JSON."""

from __future__ import annotations

import json
import os
import sys
import threading
from pathlib import Path
from typing import Any

from variantgen.errors import InputError, VariantgenError

_PATIENCE = 10  # how much less urgent it is than the pages
_PHASES = {"drawing variants": "drawing", "typesetting": "typesetting"}  # of a build, as pages call them


def main() -> None:
    """Build what the first line of the input says; ends when the studio has gone."""
    wanted = json.loads(sys.stdin.readline())
    threading.Thread(target=_end_with_studio, daemon=True).start()
    if hasattr(os, "nice"):
        os.nice(_PATIENCE)
    try:
        made = _built(wanted)
    except VariantgenError as error:
        _say(phase="failed", text=str(error))
        return
    except OSError as error:
        _say(phase="failed", text=f"{error.strerror}: {error.filename or ''}")
        return
    _say(phase="built", done=made, total=made)


def _built(wanted: dict[str, Any]) -> int:
    """The number of students for whom was built."""
    from variantgen.builder import build
    from variantgen.exam.roster import numbered, read_class
    from variantgen.families.reading.folders import family_folders
    from variantgen.outputs.formats import read_exam

    path, out = Path(wanted["exam"]), Path(wanted["out"])
    exam = read_exam(path, family_folders((), beside=path))
    students = read_class(Path(wanted["roster"])).students if wanted["roster"] else numbered(wanted["variants"])
    for resume in (True, False):  # another exam may have left parts that do not fit
        try:
            return build(exam, students, out, jobs=wanted["jobs"], progress=_progress, resume=resume).students
        except InputError:
            if not resume:
                raise
    raise AssertionError("one of the two ways ends")


def _progress(stage: str, done: int, total: int) -> None:
    _say(phase=_PHASES[stage], done=done, total=total)


def _say(**data: Any) -> None:
    sys.stdout.write(json.dumps(data, ensure_ascii=False) + "\n")
    sys.stdout.flush()


def _end_with_studio() -> None:
    """The input ends when the studio does, also when it was killed; parts that are finished are kept."""
    sys.stdin.read()
    os.kill(os.getpid(), 15)


if __name__ == "__main__":
    main()
