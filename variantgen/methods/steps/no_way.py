"""What the methods of solution may raise where they do not lead to what is sought.

Not every mechanism that the solver solves can be gone through link by link: a method then raises one of ``NO_WAY``, and
whoever asked it takes another method, or the answers alone.
"""

from __future__ import annotations

import numpy as np


class NoWayError(LookupError):
    """A step of a method does not apply to the position at hand."""


# Also what arithmetic raises where lines that should cross are parallel.
NO_WAY: tuple[type[Exception], ...] = (LookupError, ArithmeticError, np.linalg.LinAlgError)
