"""A given rate and its acceleration told by a graph over time: which parameters, and the grid on which both are read.

The rate changes uniformly. At the instant of the problem, and at twice that time, the line of the graph passes through
crossings of the grid, so that nothing has to be estimated.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from itertools import product
from math import gcd

from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.families.family import Family, Form
from variantgen.families.parameters.draw_rules import TiedValues
from variantgen.families.parameters.units import unit

_TIMES = tuple(map(Decimal, ("0.1", "0.2", "0.25", "0.4", "0.5", "1", "2", "2.5", "4", "5", "10")))  # s
_MOST = 26  # lines of the grid, zero not counted


def grid_of(rate: Decimal, acceleration: Decimal) -> tuple[Decimal, Decimal] | None:
    """The instant (s) and the step of the grid for the magnitudes of a rate and its acceleration; None for none.

    The latest instant at which the rate has not changed its sense within that time, before and after.
    """
    for time in reversed(_TIMES):
        change = acceleration * time
        if 0 < change <= rate:
            step = _common(rate, change)
            if (rate + change) / step <= _MOST:
                return time, step
    return None


def _common(first: Decimal, second: Decimal) -> Decimal:
    """The largest number of which both are multiples."""
    places = max(0, *(-int(number.normalize().as_tuple().exponent) for number in (first, second)))
    whole = Decimal(gcd(*(int(number.scaleb(places)) for number in (first, second))))
    return whole.scaleb(-places)


def with_graph(family: Family) -> Family:
    """The family with the rate and the acceleration of the first driver told by a graph.

    Raises InputError for a form that gives not both by numbers of their own, and as :func:`read_from_graph` does.
    """
    return replace(family, forms={name: read_from_graph(form, _pair(form)) for name, form in family.forms.items()})


def read_from_graph(form: Form, names: Sequence[str]) -> Form:
    """The form with a rate and its acceleration told by a graph: of their values those are drawn that a grid shows.

    Raises InputError for names that are none of such a pair, and where no values are left.
    """
    first, *others = (*names, "")
    if len(names) != 2 or not {*names} <= form.parameters.keys() or not _is_derivative(form, first, others[0]):
        remedy = 'such as ["omega_OA", "epsilon_OA"]'
        said = "expected the parameters of a rate and of its acceleration"
        raise InputError(Problem(said, key="graph", value=", ".join(names), remedy=remedy))
    pair = first, others[0]
    values = product(*(form.parameters[name].printed for name in pair))
    ties = TiedValues(pair, tuple(two for two in values if grid_of(*map(abs, two)) is not None))
    if form.ties and form.ties.names != pair:
        ties = _joined(form.ties, ties)
    if not ties.rows:
        said = f"no values of {' and '.join(pair)} can be read from one grid"
        remedy = "give them other values or ranges: the acceleration times 0.1 s at most as large as the rate"
        raise InputError(Problem(said, key="graph", value=form.name, remedy=remedy))
    return replace(form, ties=ties, figure=replace(form.figure, graph=pair))


def _pair(form: Form) -> tuple[str, str]:
    """The rate and the acceleration of the first driver, by the names of their parameters."""
    names = [
        name
        for template in form.drivers[:1]
        for name, parameter in form.parameters.items()
        if parameter.is_rate and parameter.given and name in template.names
    ]
    pairs = [(a, b) for a in names for b in names if _is_derivative(form, a, b)]
    if len(names) != 2 or len(pairs) != 1:
        said = "the first driver has not a velocity and an acceleration of its own"
        raise InputError(Problem(said, key="graph", value=form.name, remedy="choose another form"))
    return pairs[0]


def _joined(first: TiedValues, second: TiedValues) -> TiedValues:
    """The rows of both that agree in the names that they share."""
    names = tuple(dict.fromkeys(first.names + second.names))
    tables = [[dict(zip(tied.names, row, strict=True)) for row in tied.rows] for tied in (first, second)]
    rows = [one | other for one, other in product(*tables) if one | other == other | one]
    return TiedValues(names, tuple(tuple(row[name] for name in names) for row in rows))


def _is_derivative(form: Form, rate: str, acceleration: str) -> bool:
    first, second = form.parameters[rate].unit, form.parameters[acceleration].unit
    if first is None or second is None:
        return False
    return first.name.endswith("/s") and second == unit(f"{first.name}^2")
