"""The command line."""

from __future__ import annotations

import atexit
import gc
import os
from collections.abc import Sequence

# A search for cycles of references after so many new objects. After every 700, as Python has it, most of what a short
# command reads and imports would be searched several times, which took a twentieth of its time, and none is garbage.
_COLLECTION = 200_000, 20, 100


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit code."""
    gc.set_threshold(*_COLLECTION)
    atexit.register(gc.freeze)  # nor is a last search at the end of the process of any use
    # numpy starts threads for large matrices as it is loaded, and there are none here: a quarter of its loading.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from variantgen.cli import app  # after the settings: it loads the first tenth of what a short command needs

    return app.main(argv)
