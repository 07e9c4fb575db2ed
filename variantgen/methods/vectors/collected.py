"""Known projections put together: collinear vectors first, and the quotient that gives an unknown magnitude."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.algebra.expression import Applied, Constant, Expression, Times, Total, Value
from variantgen.methods.steps.not_applicable import NotApplicableError
from variantgen.methods.steps.step import Share

PARALLEL = 1e-7  # degrees within which two angles are one


def collected(known: Sequence[tuple[int, Share]]) -> list[tuple[int, Expression]]:
    """Known projections with their signs as expressions; vectors at one angle with the axis are added first.

    So collinear vectors are subtracted before they are projected: ``(220 - 121) cos 40.60``.
    """
    if len(known) == 1:
        return [_written(*known[0])]
    groups: list[list[tuple[int, Share]]] = []
    for sign, share in known:
        group = next((found for found in groups if has_angle(share, found[0][1])), None)
        groups.append([(sign, share)]) if group is None else group.append((sign, share))
    found: list[tuple[int, Expression]] = []
    for group in groups:
        factor = group[0][1].factor if len(group) > 1 else None
        if factor is None:
            found += [_written(sign, share) for sign, share in group]
            continue
        sizes = [_derivative(sign, share.term.size) for sign, share in group if share.term.size is not None]
        flip = 1 if sum(sign * size.exact for sign, size in sizes) >= 0 else -1
        inner = sorted(((flip * sign, size) for sign, size in sizes), key=lambda term: -term[0])
        found.append((flip, Total(tuple(inner)) * factor))
    return found


def has_angle(first: Share, second: Share) -> bool:
    """Whether two vectors make the same angle with the axis."""
    if first.angle is None or second.angle is None:
        return first.angle is second.angle
    acute = [
        abs(s.angle.exact - (90.0 if s.function == "sin" else 0.0)) for s in (first, second) if s.angle is not None
    ]
    return abs(acute[0] - acute[1]) < PARALLEL


def quotient(parts: Sequence[tuple[int, Expression]], factor: Expression | None) -> Expression:
    """The sum of the parts over the cosine that stands with the unknown."""
    if not parts:
        return Constant(0.0)
    if len(parts) == 1 and isinstance(factor, Applied) and (found := _by_tangent(parts[0][1], factor)) is not None:
        return found if parts[0][0] > 0 else -found
    above: Expression = parts[0][1] if len(parts) == 1 and parts[0][0] > 0 else Total(tuple(parts))
    return above if factor is None else above / factor


def _by_tangent(above: Expression, factor: Applied) -> Expression | None:
    """``v sin x / cos x`` as ``v tan x``, ``v cos x / sin x`` as ``v / tan x``; None for other functions or angles."""
    *rest, last = above.factors if isinstance(above, Times) else (above,)
    if not rest or not isinstance(last, Applied) or {last.function, factor.function} != {"sin", "cos"}:
        return None
    if abs(last.argument.number(True) - factor.argument.number(True)) > PARALLEL:
        return None
    size, tangent = rest[0] if len(rest) == 1 else Times(tuple(rest)), Applied("tan", factor.argument)
    return size * tangent if last.function == "sin" else size / tangent


def projection_of(share: Share) -> Expression:
    """A known projection as an expression, without its sign."""
    if share.term.size is None:
        raise NotApplicableError(
            f"more than one unknown vector is left: {share.term.name.kind} of {share.term.name.of}"
        )
    return share.size


def _written(sign: int, share: Share) -> tuple[int, Expression]:
    """A known projection as a sign and an expression, in which derivatives of coordinates have their own signs."""
    own = _derivative(sign, share.term.size) if share.term.size is not None else (sign, projection_of(share))
    factor = share.factor
    return own[0], own[1] if factor is None else own[1] * factor


def _derivative(sign: int, size: Value) -> tuple[int, Value]:
    """A magnitude; where it is that of a negative derivative, whose symbol it would be written with, the derivative."""
    match size.expression:
        case Total(terms=((-1, Value(name=name) as own),)) if name is not None and name == size.name and name.dots:
            return -sign, own
    return sign, size
