"""What the methods of solution may raise where they do not lead to what is sought.

Not every mechanism that the solver solves can be gone through link by link: a method then raises one of
``NOT_APPLICABLE``, and the caller takes another method, or the answers alone.
"""

from __future__ import annotations

import numpy as np


class NotApplicableError(LookupError):
    """A step of a method does not apply to the position at hand."""


# Also what arithmetic raises where lines that should cross are parallel.
NOT_APPLICABLE: tuple[type[Exception], ...] = (LookupError, ArithmeticError, np.linalg.LinAlgError)
