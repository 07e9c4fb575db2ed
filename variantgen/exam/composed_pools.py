"""Pools of composed families for the problems of exams: comparable in work, made once, then read like any family."""

from __future__ import annotations

import atexit
import math
import tempfile
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack, suppress
from functools import cache
from pathlib import Path
from typing import NamedTuple

from variantgen.errors import InputError
from variantgen.exam.composed import write
from variantgen.exam.work.wanted_work import LEVELS, MOST, Span
from variantgen.families.asking import read_ask
from variantgen.families.quantities import motion_order
from variantgen.families.reading.files import FAMILY
from variantgen.families.reading.load import load_family
from variantgen.synthesis.levels import chosen_structures, level
from variantgen.synthesis.structures import FRAME, Structure, code
from variantgen.tables import Table
from variantgen.variants.seeding import digest

_MOST = 60  # structures of a problem of an exam
_USUAL, _ENOUGH = 10, 5  # of one that does not say how many
_WIDTH = 1.2  # most calculations over fewest of a pool
_SETTLED = 3  # families of a pool that say what work the others should take: one alone may lie at the edge of a level
_EACH, _ROUNDS = 6, 3  # structures looked at for each that is wanted; families of each, of near ones twice as many
_lasting = ExitStack()
_pools: dict[tuple[_Options, int | None], tuple[Path, ...]] = {}  # that were made in this process


class _Options(NamedTuple):
    """What an exam file says of a pool, all but how large it is."""

    groups: tuple[str, ...]
    links: int | None
    level: str
    seed: str

    @property
    def mark(self) -> str:
        """The end of the names of its families."""
        return f"_{digest('pool', ','.join(self.groups), self.links, self.level, self.seed).hex()[:6]}"


class _Member(NamedTuple):
    """A family that a pool may take: its calculations, whether accelerations are asked, its structure, its folder."""

    calculations: int
    accelerations: bool
    structure: Structure
    folder: Path


def read_composed(
    table: Table, folders: Sequence[Path], made: bool = True, tell: Callable[[str], object] = str
) -> tuple[str, ...]:
    """The families of ``compose = { groups, links, level, structures, seed }`` of a problem: names, or paths.

    A pool that lies in one of the folders is taken as it lies there; else it is made, in a folder that lasts as long as
    the process, or none is returned if it shall not be ``made`` yet. Mistakes are noted in the table, and that there
    are fewer than wanted. ``tell`` is told how many families of it are made.
    """
    noted = len(table.problems)
    options, said = _read_options(table)
    if len(table.problems) > noted:
        return ()
    for folder in folders:
        if names := sorted(path.parent.name for path in folder.glob(f"*{options.mark}/{FAMILY}")):
            if said not in (None, len(names)):
                remedy = f"structures = {len(names)}; or remove them, and the pool is made anew"
                table.problem(f"{folder} has {len(names)} families of this pool", "structures", said, remedy)
            return tuple(names)
    if not made:
        return ()
    found = _pools.get((options, said))
    if found is None:
        where = table.path.removesuffix("].compose").replace("[", " ")
        found = _pools[options, said] = _pool(
            options, said, lambda ready, count: tell(f"composing {where}: {ready} of {count} families")
        )
    if len(found) < (said or 1):
        remedy = f"structures = {len(found)}, " if found else ""
        message = f"only {len(found)} structures give problems that are comparable in work"
        table.problem(message, "structures", said or _USUAL, f"{remedy}another seed, level or groups")
    return tuple(map(str, found))


def _read_options(table: Table) -> tuple[_Options, int | None]:
    """What families shall be like, and how many of different structures; mistakes are noted."""
    groups = table.strings("groups")
    wanted = table.choice("level", tuple(LEVELS)) if "level" in table.data else ""
    table.expect("level")
    links = table.take("links", int, 0) if "links" in table.data else None
    table.expect("links")
    said = table.take("structures", int, _USUAL) if "structures" in table.data else None
    table.expect("structures")
    options = _Options(groups, links, wanted, str(table.take("seed", (int, str), 0, "a whole number or a word")))
    table.finish()
    if said is not None and not 1 <= said <= _MOST:
        table.problem(f"expected a number from 1 to {_MOST}", "structures", said)
    if len(set(groups)) < len(groups):
        table.problem("a kind is named twice", "groups", ", ".join(groups), "name each kind once")
    with table.collecting(""):
        there = len(chosen_structures(groups, links))
        if there < (said or 1):
            many = "is only 1 such structure" if there == 1 else f"are only {there} such structures"
            table.problem(f"there {many}", "structures", said, f"structures = {there}")
    return options, said


def _pool(options: _Options, said: int | None, report: Callable[[int, int], object]) -> tuple[Path, ...]:
    """The folders of so many families, or of as many as there are.

    One after the other is made, of each structure one and then another one, until so many of different structures take
    nearly the same number of calculations: first of those that usually are of the level, then of the others, if these
    are needed.
    """
    count = said or _USUAL
    report(0, count)
    structures = shuffled(chosen_structures(options.groups, options.links), options.seed, options.level)[
        : _EACH * count
    ]
    usual = [structure for structure in structures if options.level in ("", level(structure))]
    others = [structure for structure in structures if structure not in usual]
    far = [s for s in others if any(FRAME not in (dyad.on, dyad.to) for dyad in s)]  # these take too much most times
    near = [structure for structure in others if structure not in far]
    few = said or _ENOUGH
    tried = _lasting_folder() / f"tried-{said}"
    made, best = list[_Member](), list[_Member]()
    for own, enough, rounds in ((usual, count, _ROUNDS), (near, few, 2 * _ROUNDS), (far, few, 1)):
        for structure, round_ in ((structure, round_) for round_ in range(rounds) for structure in own):
            if len(best) >= enough:
                break
            if any(member.structure == structure for member in best):
                continue
            with suppress(InputError):  # other structures take its place
                made.append(_member(options, structure, round_, tried, _aims(options, best, round_)))
                before, best = len(best), max(best, _alike(made, count), key=len)
                if len(best) > before:
                    report(len(best), count)
    # In the order of their names, as they are found where the pool lies beside the exam file.
    return tuple(sorted((member.folder for member in best), key=lambda folder: folder.name))


def _member(options: _Options, structure: Structure, round_: int, tried: Path, aims: Mapping[int, Span]) -> _Member:
    """A family that may be taken, in a folder below ``tried``. Raises InputError."""
    folder = tried / f"{round_}" / f"{code(structure).lower().replace('-', '_')}{options.mark}"
    calculations = write(structure, (options.seed, round_), folder, aims, with_case=False)
    accelerations = motion_order(read_ask(next(iter(load_family(folder).forms.values())))) == 2
    return _Member(calculations, accelerations, structure, folder)


def _aims(options: _Options, best: Sequence[_Member], round_: int) -> dict[int, Span]:
    """How many calculations the next family should take, with accelerations (2) or without (1).

    So many that it goes with those that there are already; any of the level where there are few, at
    first with accelerations.
    """
    least, most = LEVELS.get(options.level, (1, MOST))
    if len(best) < _SETTLED:
        return dict.fromkeys((2, 1) if round_ else (2,), (least, most))
    own = [member.calculations for member in best]
    span = max(least, math.ceil(max(own) / _WIDTH)), min(most, int(min(own) * _WIDTH))
    return {2 if best[0].accelerations else 1: span}


def _alike(made: Sequence[_Member], count: int) -> list[_Member]:
    """The most families of different structures, at most so many, that ask for the same and take nearly the same."""
    best: list[_Member] = []
    for least, accelerations in sorted({(member.calculations, member.accelerations) for member in made}):
        own: dict[Structure, _Member] = {}
        for member in made:
            if member.accelerations == accelerations and least <= member.calculations <= _WIDTH * least:
                own.setdefault(member.structure, member)
        best = max(best, list(own.values())[:count], key=len)
    return best


def shuffled(structures: Sequence[Structure], seed: object, wanted: str) -> list[Structure]:
    """The structures in an order that depends on the seed; those that usually are of the wanted level come first."""

    def place(structure: Structure) -> tuple[bool, bytes]:
        return bool(wanted) and level(structure) != wanted, digest("order", code(structure), seed)

    return sorted(structures, key=place)


def folder_of(families: Mapping[str, Mapping[str, str]]) -> Path:
    """A folder that lasts as long as the process, with families: the texts of their files, by name and file."""
    folder = _lasting_folder() / digest("recorded", repr(sorted(families.items()))).hex()[:16]
    for name, files in families.items():
        (folder / name).mkdir(parents=True, exist_ok=True)
        for file, text in files.items():
            (folder / name / file).write_text(text, "utf-8")
    return folder


@cache
def _lasting_folder() -> Path:
    atexit.register(_lasting.close)
    return Path(_lasting.enter_context(tempfile.TemporaryDirectory(prefix="variantgen-composed-")))
