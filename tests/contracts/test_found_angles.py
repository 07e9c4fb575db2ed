"""Positions that follow from systems of equations only: the printed angles lead a fair reader to every answer.

The readers compute on their own, from the printed lengths and angles; only on which side of a line another one lies
they see in the figure.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import asin, radians

import numpy as np
import pytest

from variantgen.exam.sections.tolerance import Tolerance
from variantgen.exam.sheets import answer_variants
from variantgen.families.asking import read_ask
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Measured, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement

READERS = 150
Places = Mapping[str, complex]


def printed(variant: Variant, decimals: int) -> dict[str, float]:
    """The data of the sheet in cm and rad; angles found numerically with so many decimals of a degree."""
    found = {}
    for equation in statement(variant, read_ask(variant.form), load_language("en")).given:
        assert isinstance(equation.right, Measured)
        value, unit = float(equation.right.number.text), to_plain(equation.right.unit)
        name = to_plain(equation.left)
        if name.startswith("\N{ANGLE}"):
            assert equation.right.number.text[-3] == "."
            value = round(value, decimals)
        found[name] = radians(value) if unit == "\N{DEGREE SIGN}" else value
    return found


def turned(ray: complex, angle: float, seen: complex) -> complex:
    """The direction at an angle from a ray, on the side where it is seen."""
    unit = ray / abs(ray)
    return complex(unit * np.exp(1j * angle * np.sign(np.angle(seen / ray))))


def rates(columns: list[list[complex]], known: list[complex]) -> list[float]:
    """Unknown rates x of complex equations ``sum x_k c_k = d``."""
    matrix = np.array([[part(c) for c in row] for row in columns for part in (np.real, np.imag)])
    right = np.array([part(d) for d in known for part in (np.real, np.imag)])
    return [float(x) for x in np.linalg.solve(matrix, right)]


def three_rod_plate(data: Mapping[str, float], z: Places, w: float, e: float, across: complex) -> dict[str, float]:
    """Answers of the plate on three rods, in cm and s; ``w`` and ``e`` of OA with their signs."""
    oa = data["OA"] * turned(z["E"] - z["O"], data["φ"], z["A"] - z["O"])
    ab = data["AB"] * turned(-oa, data["∠OAB"], z["B"] - z["A"])
    bc = data["BC"] * turned(-ab, data["∠ABC"], z["C"] - z["B"])
    cf = data["BC"] * turned(-bc, radians(60), z["F"] - z["C"])
    dc = -data["CD"] * turned(-bc, data["∠BCD"], z["D"] - z["C"])
    ef = -data["EF"] * turned(-cf, data["∠CFE"], z["E"] - z["F"])
    bf = bc + cf
    # Unknown: AB, plate, CD, EF. v_C = v_B + i w BC, v_F = v_B + i w BF.
    columns = [[1j * ab, 1j * bc, -1j * dc, 0], [1j * ab, 1j * bf, 0, -1j * ef]]
    rod, plate, cd, last = rates(columns, [-1j * w * oa] * 2)
    start = (1j * e - w**2) * oa - rod**2 * ab
    known = [plate**2 * arm - start - far**2 * end for arm, far, end in ((bc, cd, dc), (bf, last, ef))]
    rod_e, plate_e, *_ = rates(columns, known)
    return {
        "v_B": abs(1j * (w * oa + rod * ab)),
        "omega_BCF": plate,
        "omega_CD": cd,
        "a_B": abs(start + 1j * rod_e * ab),
        "epsilon_BCF": plate_e,
    }


def guided_plate(data: Mapping[str, float], z: Places, w: float, e: float, across: complex) -> dict[str, float]:
    """Answers of the plate in two guides; the guide of C lies in the direction ``across``."""
    oa = data["OA"] * turned(across, data["φ"], z["A"] - z["O"])
    ab = data["AB"] * turned(-oa, data["∠OAB"], z["B"] - z["A"])
    bc = data["BC"] * turned(-ab, data["∠ABC"], z["C"] - z["B"])
    bd = data["BC"] * turned(bc, 2 * asin(data["CD"] / 2 / data["BC"]), z["D"] - z["B"])
    # Unknown: AB, plate, v_C along its guide, v_D across it.
    columns = [[1j * ab, 1j * bc, -across, 0], [1j * ab, 1j * bd, 0, -1j * across]]
    rod, plate, v_c, _ = rates(columns, [-1j * w * oa] * 2)
    start = (1j * e - w**2) * oa - rod**2 * ab
    _, plate_e, a_c, _ = rates(columns, [plate**2 * arm - start for arm in (bc, bd)])
    v_b = abs(1j * (w * oa + rod * ab))
    return {"omega_BCD": plate, "v_C": abs(v_c), "v_B": v_b, "omega_AB": rod, "epsilon_BCD": plate_e, "a_C": abs(a_c)}


Reader = Callable[[Mapping[str, float], Places, float, float, complex], dict[str, float]]
FAMILIES: dict[str, Reader] = {"three_rod_plate": three_rod_plate, "guided_plate": guided_plate}


def test_these_are_the_families_with_positions_that_are_found() -> None:
    every = {name: load_family(name).forms.values() for name in family_names()}
    assert {name for name, forms in every.items() if any(form.conditions for form in forms)} == set(FAMILIES)
    assert {name for name, forms in every.items() if any(form.figure.found for form in forms)} == set(FAMILIES)


@pytest.mark.parametrize(("decimals", "share"), [(2, 1.0), (1, 0.99)])
@pytest.mark.parametrize("name", FAMILIES)
def test_fair_readers_are_within_the_tolerance(name: str, decimals: int, share: float) -> None:
    variants = draw(load_family(name), None, [("reader", i) for i in range(READERS)])
    motion = solve_variants(variants, 2)
    keys = answer_variants(variants, [None] * READERS, [Tolerance()] * READERS)
    within = 0
    for i, (variant, key) in enumerate(zip(variants, keys, strict=True)):
        places = {point: complex(z[i]) for point, z in motion.z.items()}
        w, e = float(motion.omega["OA"][i]), float(motion.epsilon["OA"][i])
        across = complex(np.ravel(motion.frame.place(1.0 + 0j))[i])
        read = FAMILIES[name](printed(variant, decimals), places, w, e, across)
        within += all(abs(read[a.quantity.name] - a.value) <= a.tolerance for a in key)
        if decimals == 2:
            assert read == pytest.approx({a.quantity.name: a.value for a in key}, rel=4e-3)
    assert within >= share * READERS
