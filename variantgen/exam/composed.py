"""Composed families, accepted like those of the catalogue and with a worked case: for exams, for the command."""

from __future__ import annotations

import atexit
import tempfile
from collections.abc import Sequence
from contextlib import ExitStack, suppress
from dataclasses import replace
from functools import cache
from pathlib import Path

from variantgen.errors import InputError
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.solution_figures import solution_figure_faults
from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.families.files import CASES, FAMILY
from variantgen.figure.build import statement_figure
from variantgen.figure.faults import figure_faults
from variantgen.mechanism.verify import recompute
from variantgen.resources import languages
from variantgen.synthesis.chance import Chance
from variantgen.synthesis.compose import compose
from variantgen.synthesis.levels import chosen_structures
from variantgen.synthesis.structures import Structure, code
from variantgen.tables import Table
from variantgen.variants.draw import draw
from variantgen.variants.seeding import digest
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import explain

_LOOKED_AT = 3  # variants whose figures are drawn before a family is accepted
_POOL, _MOST = 10, 60  # structures of a problem of an exam
_KEY = ("compose", 0)  # in the place of student and problem
_lasting = ExitStack()


def _drawn(family: Family) -> list[Variant]:
    keys = [(str(seed), *_KEY) for seed in range(_LOOKED_AT)]
    return draw(replace(family, name="composed"), None, keys, screening=AnswerTolerances())


def _faults(family: Family) -> str:
    """What is wrong with figures of the statement or of the solution; nothing where all is well."""
    variants = _drawn(family)
    asked = read_ask(variants[0].form)
    motion = solve_variants(variants, 2)
    for name in languages():
        language = load_language(name)
        for place, variant in enumerate(variants):
            for fault in figure_faults(statement_figure(variant, motion, place, asked, language)):
                return str(fault)
        text = explain(variants[0], motion, 0, asked, language)
        for fault in solution_figure_faults(variants[0], motion, asked, language, text):
            return fault
    return ""


def _case(family: Family) -> str:
    """``cases.toml`` with the first variant, worked out by the independent computation."""
    variant = _drawn(family)[0]
    form = variant.form
    motion = replace(variant, sense=1, turns=0).motion()
    again = recompute(motion)
    own = replace(
        motion,
        v={**motion.v, **again.v}, a={**motion.a, **again.a},
        omega={**motion.omega, **again.omega}, epsilon={**motion.epsilon, **again.epsilon},
    )  # fmt: skip
    exact = []
    for quantity in read_ask(form):
        value = quantity.unit(family.length_unit).from_si(float(quantity.value(own)[0]))
        exact.append(f"{quantity.name} = {value:.9f}")
    given = [
        f'{n} = "{variant.word(n)}"' if p.unit is None else f"{n} = {variant.printed[n]}"
        for n, p in form.parameters.items()
    ]
    return "\n".join(
        [
            "# Worked out by moving the closed chain through small steps of time and differentiating its positions:",
            "# no construction, no velocity equation of the solver. Put results of your own calculation beside it.",
            "[[case]]",
            'id = "moved-1"',
            'source = "the chain moved in time and differentiated numerically"',
            f"set = {{ {', '.join(given)} }}",
            f"exact = {{ {', '.join(exact)} }}",
            "",
        ]
    )


def read_composed(table: Table, folders: Sequence[Path]) -> tuple[str, ...]:
    """The families of ``compose = { groups, links, level, structures, seed }`` of a problem: names, or paths.

    Those that one of the folders has by its name are taken from there; the others are made, in a folder that lasts as
    long as the process. Mistakes are noted in the table.
    """
    groups, wanted = table.strings("groups"), table.take("level", str, "")
    links = table.take("links", int, 0) or None
    count = table.take("structures", int, _POOL)
    seed = table.take("seed", (int, str), 0, "a whole number or a word")
    table.finish()
    if not 1 <= count <= _MOST:
        table.problem(f"expected a number from 1 to {_MOST}", "structures", count)
        return ()
    structures: list[Structure] = []
    with table.collecting(""):
        structures = chosen_structures(tuple(groups), links, wanted)
    chance, found = Chance("structures", *groups, links, wanted, seed), list[str]()
    while structures and len(found) < count:
        structure = structures.pop(chance.below(len(structures)))
        name = _name(structure, seed)
        if any((folder / name / FAMILY).is_file() for folder in folders):
            found.append(name)
        else:
            with suppress(InputError):  # another structure takes its place
                found.append(str(_made(structure, str(seed))))
    return tuple(found)


def _name(structure: Structure, seed: object) -> str:
    """The name of the family of a structure and a seed."""
    mark = digest("composed", code(structure), seed).hex()[:6]
    return f"{code(structure).lower().replace('-', '_')}_{mark}"


@cache
def _made(structure: Structure, seed: str) -> Path:
    """The folder of a composed family in this process. Raises InputError."""
    folder = _lasting_folder() / _name(structure, seed)
    write(structure, seed, folder, with_case=False)
    return folder


@cache
def _lasting_folder() -> Path:
    atexit.register(_lasting.close)
    return Path(_lasting.enter_context(tempfile.TemporaryDirectory(prefix="variantgen-composed-")))


def write(structure: Structure, seed: object, folder: Path, with_case: bool = True) -> None:
    """Write a composed family to a folder that is not there yet: complete, or not there. Raises InputError.

    ``with_case``: with a worked case, whose last digits may differ between machines.
    """
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}-") as scratch:
        made = Path(scratch) / folder.name
        made.mkdir()
        found = compose(structure, seed, AnswerTolerances(), made, _faults)
        files = found.files | ({CASES: _case(found.family)} if with_case else {})
        for name, text in files.items():
            (made / name).write_text(text, "utf-8")
        made.rename(folder)
