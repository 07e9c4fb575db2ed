"""Figures of all forms for their author: which way round a rope goes, on which side a point lies.

A file says in a comment that a check has drawn it, with the hash of the rest. Only such files are replaced, and only if
nobody has worked in them since.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from variantgen.errors import InputError, Problem
from variantgen.families.asking import read_ask
from variantgen.families.family import Family, Form
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.mechanism.outcome import Outcome
from variantgen.outputs.figures import write_whole
from variantgen.outputs.figures.svg import render
from variantgen.outputs.files.file_names import file_names
from variantgen.single import one_variant
from variantgen.tables import read_limited
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language

_MAX_BYTES = 5_000_000
_MARK = b"<!-- drawn by variantgen check, sha256 %s -->\n"


class FigureFolder:
    """The folder of the figures of some families; ``count`` is the number of those drawn so far.

    Raises InputError if the folder cannot be made, or holds files of the same names that no check has drawn.
    """

    def __init__(self, folder: Path, names: Sequence[str], folders: tuple[Path, ...]) -> None:
        self.count = 0
        self._folder, self._folders = folder, folders
        forms: list[tuple[str, str, str]] = []
        for name in dict.fromkeys(names):
            with suppress(InputError):  # the check itself tells what is wrong with it
                family = load_family(name, folders)
                forms += [(name, form, "-".join(filter(None, (family.name, form)))) for form in family.forms]
        stems = file_names([stem for _, _, stem in forms])
        self._paths = {(name, form): folder / f"{stem}.svg" for (name, form, _), stem in zip(forms, stems, strict=True)}
        _check_folder(folder)
        foreign = [path for path in self._paths.values() if not _is_free(path)]
        if foreign:
            remedy = "choose another folder: only unchanged figures of an earlier check are replaced"
            raise InputError(
                Problem("is no figure of a check", key="--figures", value=str(path), remedy=remedy) for path in foreign
            )

    def draw(self, name: str) -> list[str]:
        """Draw the forms of a family, as their seed 0 is; remarks on those that cannot be drawn. Raises InputError."""
        family, remarks = load_family(name, self._folders), []
        for form in family.forms.values():
            try:
                content = _figure(family, form, _one_or_middle(name, family, form, self._folders))
            except InputError as error:
                remarks.append(f"no figure of {form.name or family.name}: {error}")
                continue
            self._folder.mkdir(exist_ok=True)
            write_whole(self._paths[name, form.name], content, "--figures")
            self.count += 1
        return remarks


def _one_or_middle(name: str, family: Family, form: Form, folders: tuple[Path, ...]) -> Variant:
    """Seed 0 of a form; where nothing can be drawn at random, the middle of all grids."""
    with suppress(InputError):
        return one_variant(name, form=form.name, folders=folders)
    return Variant(family, form, {key: p.printed[len(p.printed) // 2] for key, p in form.parameters.items()})


def _figure(family: Family, form: Form, variant: Variant) -> bytes:
    """The figure as a file that says what it is. Raises InputError if there is nothing to draw."""
    motion = solve_variants([variant], 0)
    outcome = Outcome(int(motion.outcome[0]))
    if outcome is not Outcome.SOLVED:
        raise InputError(Problem(outcome.text, key=form.name, value=family.name))
    drawing = statement_figure(variant, motion, 0, read_ask(variant.form), load_language("en"))
    return _marked(render(drawing))


def _marked(content: bytes) -> bytes:
    """A figure with the comment, below the first line, that it was drawn by a check."""
    head, rest = content.split(b"\n", 1)
    return head + b"\n" + _MARK % hashlib.sha256(rest).hexdigest().encode() + rest


def _is_free(path: Path) -> bool:
    """Whether a path may be written: nothing is there, or a figure as a check has drawn it."""
    if path.is_symlink() or not path.is_file():
        return not path.is_symlink() and not path.exists()
    try:
        lines = read_limited(path, _MAX_BYTES).split(b"\n", 2)
    except (InputError, OSError):
        return False
    return len(lines) == 3 and lines[1] + b"\n" == _MARK % hashlib.sha256(lines[2]).hexdigest().encode()


def _check_folder(folder: Path) -> None:
    """Raise InputError if there is no such folder and it cannot be made."""
    if folder.exists() and not folder.is_dir():
        raise InputError(Problem("is a file, not a folder", key="--figures", value=str(folder)))
    if not folder.resolve().parent.is_dir():
        raise InputError(
            Problem("the parent folder does not exist", key="--figures", value=str(folder), remedy="make it first")
        )
