"""Equations of joints in arrangements that no family of the catalogue has, against the solver."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.methods.forms import answers, exact
from tests.methods.test_listings import listing, run
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.methods.agreement import deviation
from variantgen.methods.coordinates import coordinates
from variantgen.methods.linkage.problem import AGREES, Task, task_of
from variantgen.methods.solution.book import Book
from variantgen.variants.variant import Variant, solve_variants

HEAD = """
schema = 1
title = { en = "Scene", ru = "Сцена" }
length_unit = "m"
[parameters]
omega = { unit = "rad/s", from = 1, to = 4, step = 0.5 }
epsilon = { unit = "rad/s^2", from = 1, to = 4, step = 0.5 }
omega_1 = { unit = "rad/s", from = 3, to = 6, step = 0.5 }
epsilon_1 = { unit = "rad/s^2", from = 3, to = 6, step = 0.5 }
v = { unit = "m/s", from = 1, to = 4, step = 0.5 }
a = { unit = "m/s^2", from = 1, to = 4, step = 0.5 }
"""

SCENES = {
    "a wheel rolls on a plank that turns": """
ask = ["v_M", "a_M"]
[points]
O = { coordinates = { x = 0, y = 0 } }
B = { polar = { origin = "O", distance = 2, angle = 0.3 } }
K = { polar = { origin = "O", distance = 1.2, angle = 0.3 } }
W = { polar = { origin = "K", distance = 0.25, towards = "B", angle = "90*deg" } }
M = { polar = { origin = "W", distance = 0.25, angle = 0.4 } }
[bodies]
plank = ["O", "B"]
wheel = ["W", "M"]
[[joints]]
pivot = { point = "O" }
[[joints]]
rolling = { body = "wheel", centre = "W", contact = "K", on = "plank", on_point = "O" }
[[drivers]]
rotation = { body = "plank", omega = "omega", epsilon = "epsilon" }
[[drivers]]
rotation = { body = "wheel", omega = "-omega_1", epsilon = "epsilon_1" }
""",
    "a rope that swings over a fixed pulley": """
ask = ["v_B", "a_B"]
[points]
K = { coordinates = { x = 0, y = 0 } }
A = { coordinates = { x = -1.5, y = -0.9 } }
B = { coordinates = { x = 0.2, y = -1.1 } }
[[joints]]
guide = { point = "A" }
[[joints]]
guide = { point = "B", angle = 90 }
[[joints]]
rope.path = [{ point = "A" }, { point = "K", radius = 0.2, side = "right", fixed = true }, { point = "B" }]
[[drivers]]
travel = { point = "A", v = "v", a = "a" }
""",
    "gears whose line of centres no body carries": """
ask = ["omega_small", "epsilon_small", "v_M", "a_M"]
[points]
C = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "C", distance = 1.4, angle = 0.6 } }
M = { polar = { origin = "A", distance = 0.3, angle = 2.0 } }
B = { coordinates = { x = 1.9, y = 0.1 } }
[bodies]
small = ["A", "M"]
rod = ["A", "B"]
[[joints]]
arc_slot = { point = "A", centre = "C" }
[[joints]]
guide = { point = "B" }
[[joints]]
gears = { body = "small", centre = "A", radius = 0.4, other_centre = "C" }
[[drivers]]
travel = { point = "B", v = "v", a = "a" }
""",
    "a sleeve that does not swivel": """
ask = ["omega_arm", "epsilon_arm", "v_B", "a_B"]
[points]
O = { coordinates = { x = 0, y = 0 } }
E = { polar = { origin = "O", distance = 3, angle = 0.5 } }
C = { polar = { origin = "O", distance = 1.5, angle = 0.5 } }
B = { polar = { origin = "C", distance = 0.8, angle = 1.9 } }
[bodies]
rod = ["O", "E"]
arm = ["C", "B"]
[[joints]]
pivot = { point = "O" }
[[joints]]
slot = { point = "C", body = "rod", along = ["O", "E"], sleeve = "arm" }
[[drivers]]
rotation = { body = "rod", omega = "omega", epsilon = "epsilon" }
[[drivers]]
relative_travel = { point = "C", body = "rod", along = ["O", "E"], v = "v", a = "a" }
""",
    "a point led along a line of a body and across it": """
ask = ["v_M", "a_M"]
[points]
O = { coordinates = { x = 0, y = 0 } }
E = { polar = { origin = "O", distance = 3, angle = 0.5 } }
M = { polar = { origin = "O", distance = 1.5, angle = 0.5 } }
[bodies]
rod = ["O", "E"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "M", angle = "40*deg" }
[[drivers]]
rotation = { body = "rod", omega = "omega", epsilon = "epsilon" }
[[drivers]]
relative_travel = { point = "M", body = "rod", along = ["O", "E"], v = "v", a = "a" }
""",
}


@pytest.fixture(params=SCENES, ids=lambda name: name.replace(" ", "-"))
def task(request: pytest.FixtureRequest, tmp_path: Path) -> Task:
    folder = tmp_path / "scene"
    folder.mkdir()
    ask, _, rest = SCENES[request.param].lstrip().partition("\n")
    path = folder / "family.toml"
    path.write_text(HEAD.replace("[parameters]", f"{ask}\n[parameters]") + rest, encoding="utf-8")
    family = load_family(str(path))
    (form,) = family.forms.values()
    variant = Variant(family, form, {name: parameter.printed[2] for name, parameter in form.parameters.items()})
    return task_of(variant, solve_variants([variant], 2), 0, read_ask(form))


def test_the_scene_is_solved_in_coordinates(task: Task) -> None:
    book = Book(task)
    coordinates.solve(book)
    assert deviation(book) < AGREES
    found, (printed,) = answers(book), run([listing(task)])
    for quantity in task.asked:
        wanted = exact(task, quantity)
        assert wanted != 0
        assert found[quantity.name] == pytest.approx(wanted, rel=1e-9)
        assert printed[quantity.name] == pytest.approx(wanted, rel=1e-9)
