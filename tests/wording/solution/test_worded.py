"""What solutions tell: zero terms left out of numbers, rays behind angles, introduced ways, centres in the figure."""

from __future__ import annotations

import re
from pathlib import Path

from variantgen.figure.views import accelerations, velocities
from variantgen.methods.solution_options import SolutionOptions
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import to_plain
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import FormulaLines, Paragraph, SolutionText
from variantgen.wording.solution.explain import explain

EN = load_language("en")


def solved(name: str, form: str, seed: int, *methods: str) -> tuple[Variant, SolutionText]:
    variant = one_variant(name, seed=str(seed), form=form)
    asked = asked_quantities(variant)
    motion = solve_variants([variant], max(quantity.order for quantity in asked))
    return variant, explain(variant, motion, 0, asked, EN, SolutionOptions(methods))


def lines(text: SolutionText) -> list[str]:
    found = []
    for section in text.sections:
        for block in section.blocks:
            if isinstance(block, FormulaLines):
                found += ["".join(f" {s} {to_plain(f)}" for s, f in line.pieces) for line in block.lines]
    return found


def sentences(text: SolutionText) -> str:
    blocks = [block for section in text.sections for block in section.blocks if isinstance(block, Paragraph)]
    return " ".join("".join(p if isinstance(p, str) else to_plain(p) for p in block.text) for block in blocks)


def test_numbers_leave_out_what_is_zero_now_and_symbols_keep_it() -> None:
    # The angle of the cam counts from the given place: psi = 0 in numbers, but its function stays in symbols.
    _, text = solved("cam_disc", "flat", 1, "analytical")
    rates = [line for line in lines(text) if "ψ" in line and "sin" in line and "≈" not in line]
    assert rates
    assert all(re.search(r"sin\(ψ [+−]", line) for line in rates)
    assert not any(re.search(r"(?<!\d)0° [+−]", line) for line in rates)


def test_a_way_along_an_oblique_line_is_introduced_before_it_is_used() -> None:
    for method in ("analytical", "coordinates"):
        _, text = solved("scotch_yoke", "oblique", 1, method)
        output = sentences(text)
        assert "the distance h_A" in output
        assert "its way s_A" in output
        assert re.search(r"the line makes the angle −?\d+° with the x axis", output)


def test_the_acceleration_centre_of_a_solution_is_in_its_figure_though_it_is_not_asked() -> None:
    variant, text = solved("rolling_wheel", "", 1, "acceleration_centre")
    asked = asked_quantities(variant)
    assert all(quantity.kind != "Q" for quantity in asked)
    assert {quantity.component for quantity in text.centres} == {"O", "A", "M"}
    motion = solve_variants([variant], 2)
    with_centre = accelerations.draw(variant, motion, 0, (*asked, *text.centres), EN, text.vectors)
    without = accelerations.draw(variant, motion, 0, asked, EN)
    assert "Q" in [to_plain(label.formula) for label in with_centre.labels]
    assert "Q" not in [to_plain(label.formula) for label in without.labels]
    # Components about a pole belong to another method.
    assert not any("^n" in to_plain(label.formula) for label in with_centre.labels)


def test_a_contact_at_rest_has_the_letter_of_the_velocity_centre() -> None:
    _, text = solved("planetary_train", "two_planets", 1)
    assert "the pitch point P_2 is its instantaneous centre" in sentences(text)


def test_the_centre_of_the_only_link_that_turns_freely_is_p_in_the_text_as_in_the_figure(tmp_path: Path) -> None:
    # A rack on the slider B is a body too, but has no velocity centre.
    (path := tmp_path / "rack.toml").write_text("""
length_unit = "cm"
ask = ["v_B"]
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { coordinates = { x = 12, y = 16 } }
B = { coordinates = { x = 60, y = 0 } }
E = { coordinates = { x = 90, y = 0 } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
rackB = ["B", "E"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B" }
[[joints]]
translation = { body = "rackB" }
[[drivers]]
rotation = { body = "OA", omega = 2 }
""")
    variant, text = solved(str(path), "", 0, "velocity_centre")
    assert "instantaneous centre P." in sentences(text)
    drawing = velocities.draw(variant, solve_variants([variant], 1), 0, asked_quantities(variant), EN)
    assert "P" in [to_plain(label.formula) for label in drawing.labels]
