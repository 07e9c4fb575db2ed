"""How large and how fast a machine is: the limits beyond which a reader would smile at a variant."""

from __future__ import annotations

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.families.parameters.units import parse_value, unit
from variantgen.tables import Table

LIMITS = {"length": "m", "speed": "m/s", "acceleration": "m/s^2", "omega": "rad/s", "epsilon": "rad/s^2"}


class Machine(Struct, frozen=True):
    """Largest plausible values of a size class, in SI.

    ``length`` of the whole drawing (m), ``speed`` (m/s) and ``acceleration`` (m/s^2) of any point that is drawn,
    ``omega`` (rad/s) and ``epsilon`` (rad/s^2) of any body.
    """

    size: str
    length: float
    speed: float
    acceleration: float
    omega: float
    epsilon: float

    def rule(self, name: str) -> str:
        """A limit in words: ``speed up to 5 m/s (hand)``."""
        return f"{name} up to {getattr(self, name):g} {LIMITS[name]} ({self.size})"


# Chosen by judgement: what a person's hand, a bench motor, a workshop drive, a road wheel, a hoist would do in a
# problem that a student should believe. A hand-turned or bench mechanism stays below 3 g.
SIZES = {
    machine.size: machine
    for machine in (
        Machine("hand", 6.5, 5.0, 20.0, 15.0, 40.0),
        Machine("bench", 2.0, 5.0, 29.0, 15.0, 60.0),
        Machine("workshop", 3.5, 8.0, 60.0, 20.0, 100.0),
        Machine("vehicle", 4.0, 8.0, 40.0, 15.0, 40.0),
        Machine("hoist", 6.0, 3.0, 5.0, 8.0, 20.0),
    )
}


def read_machine(table: Table) -> Machine | None:
    """The table ``[machine]``: a size class, and limits of its own in place of those of the class."""
    if not table.data:
        return None
    table.expect(*LIMITS)
    table.need("size", str, "", "one of " + ", ".join(SIZES))
    size = table.choice("size", list(SIZES))
    own: dict[str, float] = {}
    for name, unit_name in LIMITS.items():
        if name in table.data:
            written = table.take(name, str, "", f'a number with its unit in quotes: "12 {unit_name}"')
            if written:
                with table.collecting(name):
                    own[name] = _limit(written, unit_name)
    table.finish()
    known = SIZES[size]
    return Machine(size, **{name: own.get(name, getattr(known, name)) for name in LIMITS})


def _limit(written: str, unit_name: str) -> float:
    """A limit in SI. Raises InputError."""
    known = unit(unit_name)
    found = known.to_si(parse_value(written, known, ""))
    if not any(letter.isalpha() for letter in written) or not found > 0:
        raise InputError(Problem("expected a number above 0 with its unit", value=written, remedy=f"12 {unit_name}"))
    return found
