"""A law given by its velocity or acceleration and by where it begins, integrated: ``v = 3 t^2``, ``a = -0.4 v``.

Trees here are in numbers of their own: plain ones in the unit of the law and seconds, or SI. The law ``s`` is a name in
them, its velocity ``s_dot``, its acceleration ``s_ddot``; constants of integration are ``C_1`` and ``C_2``.
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from variantgen.algebra.antiderivative import antiderivative, at, has, polynomial, straight
from variantgen.algebra.expression import Applied, Constant, Expression, Raised, Ratio, SquareRoot, Times, Variable
from variantgen.algebra.normal_form import Maybe, added, product, summed, terms_of
from variantgen.families.parameters.expressions import FamilyExpression

_DIGITS = 12  # of a number that is worked out when the law is read
_ZERO = Constant(0.0)
_KEPT = ("deg", "pi")  # in a formula these say more than their numbers


class Start(Struct, frozen=True):
    """Where a law begins: the time or the place, the value of the law there (None by place), its velocity or None."""

    where: Expression
    value: Expression | None
    rate: Expression | None


class RateLaw(Struct, frozen=True):
    """The velocity (``order`` 1) or the acceleration (2) of the law ``name`` as its file states it.

    ``variable`` is the name of the time, or that of the law itself, whose velocity at a given place is wanted.
    ``unit`` is that of its plain numbers, empty for SI; ``text`` is what the file says.
    """

    name: str
    variable: str
    order: int
    tree: Expression
    unit: str
    start: Start | None
    text: str

    @property
    def is_by_place(self) -> bool:
        """Whether the place is given, not the time."""
        return self.variable == self.name

    def uses(self, name: str) -> bool:
        """Whether a name stands in what is stated."""
        return has(self.tree, name)


class Integrated(Struct, frozen=True):
    """A law that has been integrated: how (the key of a sentence), its place and velocity by the variable.

    What is None has to be worked out numerically. ``lines`` are equations that a solution shows.
    """

    way: str
    value: Expression | None = None
    rate: Expression | None = None
    lines: tuple[tuple[Expression, Expression], ...] = ()


def integrated(law: RateLaw, sample: Mapping[str, float]) -> Integrated:
    """The law by its variable; ``sample`` are values of the parameters in SI, which tell the sign of a velocity."""
    found = _by_place(law, sample) if law.is_by_place else _by_time(law)
    stated = (_rate(law, law.order), law.tree)
    return Integrated(found.way, found.value, found.rate, (stated, *found.lines))


def _rate(law: RateLaw, order: int) -> Variable:
    return Variable(law.name + ("", "_dot", "_ddot")[order])


def _by_time(law: RateLaw) -> Integrated:
    own, rate = law.uses(law.name), law.uses(f"{law.name}_dot")
    try:
        if not own and not rate:
            return _of_time(law)
        if not law.uses(law.variable) and own != rate:
            return _separated(law)
    except LookupError:
        pass
    return Integrated("numerical")


def _of_time(law: RateLaw) -> Integrated:
    """Antiderivatives by time, with the constants that the start demands."""
    start = law.start
    assert start is not None, "a law by time has one"
    found: Maybe = law.tree
    lines: list[tuple[Expression, Expression]] = []
    known: list[Maybe] = []
    begun = (start.value, start.rate)
    for order in range(law.order - 1, -1, -1):
        found = antiderivative(found, law.variable) if found is not None else None
        letter = Variable("C" if law.order == 1 else f"C_{law.order - order}")
        constant = _folded(added((1, begun[order]), (-1, at(found, law.variable, start.where))))
        lines += [(_rate(law, order), summed([(1, found), (1, letter)])), (letter, constant or _ZERO)]
        found = added((1, found), (1, constant))
        known.append(found)
    return Integrated("antiderivative", known[-1] or _ZERO, known[0] or _ZERO if law.order == 2 else None, tuple(lines))


def _separated(law: RateLaw) -> Integrated:
    """Velocities and accelerations that are straight functions of the place or the velocity, or a square of it.

    Raises LookupError for others.
    """
    start = law.start
    assert start is not None and start.value is not None, "a law by time has one"
    of_rate = law.uses(f"{law.name}_dot")
    by = f"{law.name}_dot" if of_rate else law.name
    begun = start.rate if of_rate else start.value
    passed = _passed(law)
    if law.order == 2 and not of_rate:
        return _oscillating(law)
    assert begun is not None, "a law of second order has a velocity at its start"
    form = straight(law.tree, by)
    if form is not None:
        found = _growing(form, begun, passed)
    else:
        square = _square(law.tree, by)
        below = summed([(1, Constant(1.0)), (-1, product(square, begun, passed))])
        found = Ratio(begun, below)
    if law.order == 1:
        return Integrated("separated", found, None, ((_rate(law, 0), found),))
    if form is not None:
        way = _way(form, begun, passed)
    else:
        way = product(_folded(Ratio(Constant(-1.0), square)), Applied("ln", below))
    place = summed([(1, start.value), (1, way)])
    lines = ((_rate(law, 1), found), (_rate(law, 0), place))
    return Integrated("separated", place, found, lines)


def _passed(law: RateLaw) -> Expression:
    """What the variable has passed since the start: t, or t - 2."""
    assert law.start is not None
    return summed([(1, Variable(law.variable)), (-1, _folded(law.start.where))])


def _growing(form: tuple[Maybe, Maybe], begun: Expression, passed: Expression) -> Expression:
    """The solution of ``y' = p + q y``: ``(y_0 + p/q) e^(q x) - p/q``. Raises LookupError for q = 0."""
    p, q = form
    if q is None:
        raise LookupError("does not grow")
    rest = None if p is None else _folded(Ratio(p, q))
    grown = product(_folded(added((1, begun), (1, rest))), Applied("exp", product(q, passed) or _ZERO))
    return summed([(1, grown), (-1, rest)])


def _way(form: tuple[Maybe, Maybe], begun: Expression, passed: Expression) -> Maybe:
    """The integral of :func:`_growing` from the start."""
    p, q = form
    assert q is not None, "it grows"
    rest = None if p is None else _folded(Ratio(p, q))
    grown = summed([(1, Applied("exp", product(q, passed) or _ZERO)), (-1, Constant(1.0))])
    factor = _folded(Ratio(summed([(1, begun), (1, rest)]), q))
    return added((1, product(factor, grown)), (-1, product(rest, passed)))


def _square(tree: Expression, by: str) -> Expression:
    """The factor k of ``k y^2``. Raises LookupError for another expression."""
    found = polynomial(tree, by)
    if found is None or len(found) != 3 or found[0] is not None or found[1] is not None or found[2] is None:
        raise LookupError("no square")
    return _folded(found[2]) or _ZERO


def _oscillating(law: RateLaw) -> Integrated:
    """``y'' = p - k^2 y`` with numbers: cosine and sine of k times the time. Raises LookupError for others."""
    start = law.start
    assert start is not None and start.value is not None and start.rate is not None, "second order"
    p, q = straight(law.tree, law.name) or (None, None)
    slope, rest = _number(q), _number(p)
    if slope is None or rest is None or slope >= 0:
        raise LookupError("does not oscillate")
    middle = Constant(_short(-rest / slope)) if rest else None
    k = Constant(_short((-slope) ** 0.5))
    angle = product(k, _passed(law)) or _ZERO
    side = _folded(added((1, start.value), (-1, middle)))
    swing = _folded(Ratio(start.rate, k))
    cosine, sine = Applied("cos", angle), Applied("sin", angle)
    place = summed([(1, middle), (1, product(side, cosine)), (1, product(swing, sine))])
    rate = summed([(1, product(start.rate, cosine)), (-1, product(side, k, sine))])
    return Integrated("oscillation", place, rate, ((_rate(law, 0), place), (_rate(law, 1), rate)))


def _by_place(law: RateLaw, sample: Mapping[str, float]) -> Integrated:
    rate = Variable(f"{law.name}_dot")
    if law.order == 1:
        return Integrated("direct", None, law.tree) if not law.uses(rate.name) else Integrated("numerical")
    start = law.start
    assert start is not None and start.rate is not None, "an acceleration has a velocity at its start"
    try:
        if not law.uses(rate.name):
            return _by_energy(law, sample)
        if not law.uses(law.name):
            return _by_way(law)
    except LookupError:
        pass
    return Integrated("numerical")


def _by_energy(law: RateLaw, sample: Mapping[str, float]) -> Integrated:
    """``v dv = a ds``: half the square of the velocity is the antiderivative of the acceleration by the place."""
    start, rate = law.start, Variable(f"{law.name}_dot")
    assert start is not None and start.rate is not None
    found = antiderivative(law.tree, law.name)
    letter, half = Variable("C"), Constant(0.5)
    constant = _folded(added((1, product(half, Raised(start.rate, 2))), (-1, at(found, law.name, start.where))))
    twice = added(
        *((sign, product(Constant(2.0), term)) for part in (found, constant) for sign, term in terms_of(part))
    )
    root = SquareRoot(twice or _ZERO)
    lines = ((Ratio(Raised(rate, 2), Constant(2.0)), summed([(1, found), (1, letter)])), (letter, constant or _ZERO))
    return Integrated("energy", None, root if starting_sign(law, sample) > 0 else -root, lines)


def _by_way(law: RateLaw) -> Integrated:
    """``v dv/ds = a(v)`` for accelerations like ``k v`` and ``k v^2``. Raises LookupError for others."""
    start, rate = law.start, f"{law.name}_dot"
    assert start is not None and start.rate is not None
    found = polynomial(law.tree, rate) or []
    if len(found) == 2 and found[0] is None:
        velocity = summed([(1, start.rate), (1, product(found[1], _passed(law)))])
    else:
        velocity = Times((start.rate, Applied("exp", product(_square(law.tree, rate), _passed(law)) or _ZERO)))
    return Integrated("separated_way", None, velocity, ((Variable(rate), velocity),))


def starting_sign(law: RateLaw, sample: Mapping[str, float]) -> int:
    """The sign of the velocity after the start: that of the velocity there, or of the acceleration at rest."""
    start = law.start
    assert start is not None and start.rate is not None
    velocity = float(FamilyExpression("", start.rate).value(sample))
    if velocity == 0:
        here = {Variable(law.name): start.where, Variable(f"{law.name}_dot"): start.rate}
        tree = law.tree
        for name, value in here.items():
            tree = at(tree, name.name, value) or _ZERO
        velocity = float(FamilyExpression("", tree).value(sample))
    return -1 if velocity < 0 else 1


def _number(item: Maybe) -> float | None:
    """The number of an expression without names; None for another one."""
    folded = _folded(item)
    return 0.0 if folded is None else folded.value if isinstance(folded, Constant) else None


def _folded(item: Maybe) -> Maybe:
    """An expression without names as its number, which is left out where it is zero."""
    if item is None or FamilyExpression("", item).names:
        return item
    value = _short(float(FamilyExpression("", item).value({})))
    if value and any(has(item, name) for name in _KEPT):
        return item
    return Constant(value) if value else None


def _short(value: float) -> float:
    return float(f"{value:.{_DIGITS}g}")
