"""The sides of a vector equation as they are written: components along laid axes are one vector again."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import groupby

from variantgen.algebra.expression import Value
from variantgen.methods.steps.step import Sentence, Term, VectorLine


def written_sides(line: VectorLine) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
    """Both sides with one term for each run of components of a vector along axes that the solution has laid.

    What was found as ``v_B xi`` and ``v_B eta`` on the axes of one equation is ``v_B`` in the next.
    """
    return _put_together(line.left), _put_together(line.right)


def _put_together(side: Sequence[Term]) -> tuple[Term, ...]:
    found: list[Term] = []
    for name, run in groupby(side, lambda term: term.name.whole if term.is_laid else term.name):
        terms = list(run)
        if not terms[0].is_laid:
            found += terms
            continue
        sizes = [(term.size.exact, term.angle.exact) for term in terms if term.size is not None]
        whole = sum((cmath.rect(size, math.radians(angle)) for size, angle in sizes), 0j)
        angle = Value(None, "angle", math.degrees(cmath.phase(whole)))
        found.append(Term(name, Value(None, "number", abs(whole)), angle, Sentence("ways.components")))
    return tuple(found)
