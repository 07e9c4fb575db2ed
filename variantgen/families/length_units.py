"""The data of a family in another unit of length: metres, inches, feet in place of centimetres.

Every length, velocity and acceleration is multiplied by the same round number, 1, 2 or 5 times a power of ten, that is
nearest to the ratio of the units: 1 cm becomes 10 mm and 0.01 m exactly, but half an inch (1.27 cm) and 0.05 ft
(1.52 cm). So a round grid stays round, the shapes, right triangles and simple answers of a family stay what they are,
and the mechanism itself is a little larger or smaller. Constants of nature are converted and rounded to three digits:
g = 32.2 ft/s^2.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from decimal import Context, Decimal

from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.families.family import Family, Form
from variantgen.families.parameters.draw_rules import TiedValues
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.units import LENGTHS, UNITS, Unit
from variantgen.tables import Table

_CONSTANT = Context(prec=3)
_ROUND = (1, 2, 5)


def check_length_unit(name: str, key: str) -> str:
    """The name of a unit of length itself; InputError for any other."""
    if name not in LENGTHS:
        remedy = "one of " + ", ".join(LENGTHS)
        raise InputError(Problem("expected a unit of length", key=key, value=name, remedy=remedy))
    return name


def read_length_unit(table: Table) -> str:
    """The key ``units`` of an exam or of one problem; '' if nothing is said there. Mistakes are noted in the table."""
    name = table.take("units", str, "")
    if "units" in table.data:
        with table.collecting("units"):
            return check_length_unit(name, "")
    return ""


def in_unit(family: Family, length: str) -> Family:
    """The family with all lengths, velocities and accelerations in a unit of length and those made of it.

    Raises InputError for a scene file, whose numbers are what they are, and for a unit that the family does not offer.
    """
    if family.is_scene:
        remedy = f'write length_unit = "{length}" and the numbers with their units in the file'
        raise InputError(Problem("a scene has the units of its file", key="units", value=length, remedy=remedy))
    if family.units and length not in family.units:
        remedy = f"{family.name} offers " + ", ".join(family.units)
        raise InputError(Problem("the family is not given in this unit", key="units", value=length, remedy=remedy))
    forms = {name: _form(form, length) for name, form in family.forms.items()}
    return replace(family, length_unit=length, forms=forms)


def round_ratio(old: Unit, new: Unit) -> Decimal:
    """By what a number in one unit is multiplied for the other: of 1, 2, 5, 10, ... the nearest in proportion."""
    ratio = old.factor / new.factor
    power = math.floor(ratio.log10())
    near = [Decimal(digit).scaleb(power + more) for more in (0, 1) for digit in _ROUND]
    return min(near, key=lambda number: abs((number / ratio).ln()))


def _form(form: Form, length: str) -> Form:
    nice = form.nice
    grids = {**form.parameters, **nice.parameters}
    return replace(
        form,
        parameters=_parameters(form.parameters, length),
        nice=replace(nice, parameters=_parameters(nice.parameters, length), ties=_ties(nice.ties, grids, length)),
        ties=_ties(form.ties, form.parameters, length),
    )


def _parameters(parameters: Mapping[str, Parameter], length: str) -> dict[str, Parameter]:
    return {name: _parameter(parameter, length) for name, parameter in parameters.items()}


def _parameter(parameter: Parameter, length: str) -> Parameter:
    old = parameter.unit
    if old is None or old.dimension[0] == 0:
        return parameter
    new = _made_of(length, old)
    if parameter.constant:
        printed = tuple(_CONSTANT.plus(value * old.factor / new.factor) for value in parameter.printed)
    else:
        ratio = round_ratio(old, new)
        printed = tuple(value * ratio for value in parameter.printed)
    return replace(parameter, unit=new, printed=tuple(map(_plain, printed)))


def _ties(ties: TiedValues | None, grids: Mapping[str, Parameter], length: str) -> TiedValues | None:
    if ties is None:
        return None
    found = []
    for name, column in zip(ties.names, zip(*ties.rows, strict=True), strict=True):
        found.append(_parameter(replace(grids[name], printed=column), length).printed)
    return TiedValues(ties.names, tuple(zip(*found, strict=True)))


def _made_of(length: str, old: Unit) -> Unit:
    """The unit of the same kind with another length in it."""
    return UNITS[length + {0: "", -1: "/s", -2: "/s^2"}[old.dimension[1]]]


def _plain(value: Decimal) -> Decimal:
    """A number without zeros at its end and without an exponent."""
    return Decimal(f"{value.normalize():f}")
