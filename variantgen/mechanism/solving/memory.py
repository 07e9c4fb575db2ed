"""Memory for the temporary arrays of large batches."""

from __future__ import annotations

from functools import cache

import numpy as np

LARGE = 2000  # variants of a batch from which on its arrays are large for the C library
# The largest block whose freeing the C library of Linux takes for a sign that more of the kind will come (32 MB, less
# what it adds itself).
_BLOCK = (32 << 20) - (64 << 10)


@cache
def keep_freed_memory() -> None:
    """Let the C library keep the memory of freed arrays for the next ones, once for the process.

    Arrays of a large batch lie at the end of the heap. As soon as some of them are freed, glibc gives their pages back
    to the system, only to fetch them again for the next arrays: that costs two to three times as much as the
    arithmetic. Freeing one large block raises the thresholds above which it does so (see mallopt(3), M_MMAP_THRESHOLD);
    no page of the block is ever touched. Elsewhere this does nothing.
    """
    np.empty(_BLOCK, dtype=np.uint8)
