"""The families of the folder as the page Author edits them: their texts, what is wrong with them, what they show."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from markupsafe import Markup

from variantgen.errors import InputError, Problem
from variantgen.families.reading.files import CASES, FAMILY
from variantgen.limits import TOML_BYTES
from variantgen.studio.documents.document import ConflictError
from variantgen.studio.documents.journal import version_of
from variantgen.studio.documents.mistakes import Mistake, line_of, located
from variantgen.studio.messages import explained
from variantgen.studio.studio import UnknownKeyError
from variantgen.studio.words import LANGUAGES
from variantgen.studio.workspace import Workspace, is_own, write_whole
from variantgen.tables import read_limited

STATEMENTS = {language: f"statement.{language}.j2" for language in LANGUAGES}
FILES = (FAMILY, CASES, *STATEMENTS.values())


def own_families(workspace: Workspace) -> dict[str, Path]:
    """The folders of the families that lie in the folder of the studio, by name."""
    found = sorted(workspace.folder.glob(f"*/{FAMILY}"))
    return {path.parent.name: path.parent for path in found if is_own(path, workspace.folder) and _is_plain(path)}


def _is_plain(path: Path) -> bool:
    """Whether an address can have the name of a family."""
    return path.parent.name.replace("_", "").replace("-", "").isalnum()


def folder_of(workspace: Workspace, name: str) -> Path:
    """The folder of a family. Raises UnknownKeyError."""
    found = own_families(workspace).get(name)
    if found is None:
        raise UnknownKeyError(name)
    return found


def texts(folder: Path) -> dict[str, str]:
    """The texts of the files of a family; '' for one that is not there. Raises InputError for what is no text."""
    return {name: _text(folder / name) for name in FILES}


def _text(path: Path) -> str:
    if path.is_symlink():
        raise InputError(
            Problem("a file of a family may not be a link", file=str(path), remedy="copy it to this place")
        )
    if not path.exists():
        return ""
    if not path.is_file():
        raise InputError(Problem("is no file", file=str(path), remedy="move it elsewhere"))
    try:
        return read_limited(path, TOML_BYTES).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(Problem("is no text in UTF-8", file=str(path), remedy="save it as UTF-8")) from None


def versions(found: Mapping[str, str]) -> dict[str, str]:
    """The versions of texts, by file."""
    return {name: version_of(text) for name, text in found.items()}


def save(workspace: Workspace, name: str, file: str, text: str, version: str, settles: bool = False) -> str:
    """Write a file of a family that was seen in a version; its new version. Raises ConflictError, InputError.

    It is written with mistakes too: it is the author's, and what is wrong with it is said beside it. Ends of lines
    stay as the file has them. A text in conflict is a draft until it is kept after all or a choice ``settles`` it.
    """
    if file not in FILES:
        raise InputError(Problem("is no file of a family", key="file", value=file[:40]))
    path, draft = folder_of(workspace, name) / file, _draft(workspace, name, file)

    def compare() -> None:
        now = _text(path)
        if version_of(now) != version and _lines(now) != _lines(text):
            write_whole(draft, text)
            raise ConflictError(file, text, now)

    before = _text(path)
    compare()
    if "\r\n" in before:
        text = _lines(text).replace("\n", "\r\n")
    if text != before:
        write_whole(path, text, compare)
    if settles or (draft.is_file() and _lines(_text(draft)) == _lines(text)):
        draft.unlink(missing_ok=True)
    return version_of(text)


def drafts(workspace: Workspace, name: str, found: Mapping[str, str]) -> dict[str, str]:
    """The texts that were in conflict when their window was closed, by file; ``found`` are those of the files."""
    own = {file: _text(_draft(workspace, name, file)) for file in found if _draft(workspace, name, file).is_file()}
    return {file: text for file, text in own.items() if _lines(text) != _lines(found[file])}


def _draft(workspace: Workspace, name: str, file: str) -> Path:
    return workspace.state("author", name, file)


def _lines(text: str) -> str:
    """A text with ends of lines as browsers have them."""
    return text.replace("\r\n", "\n")


def begin(workspace: Workspace, name: str, start: str) -> None:
    """A new family: a working beginning, or a copy of the family ``start``. Raises InputError."""
    from variantgen.families.reading.files import family_files
    from variantgen.families.reading.folders import file_of
    from variantgen.skeletons import new_family

    source = file_of(start, (workspace.folder,)) if start else None
    if start and (source is None or not start.replace("_", "").isalnum()):
        raise InputError(Problem("unknown family", key="start", value=start))
    content = family_files(source.parent) if source else {}
    target = new_family(name, workspace.folder)
    for file in FILES if content else ():
        if file in content:
            write_whole(target / file, content[file])
        else:
            (target / file).unlink(missing_ok=True)


def look(workspace: Workspace, name: str, form: str, seed: int, language: str) -> dict[str, Any]:
    """A variant of a family as it stands in its files: figure, data, answers, statements; or what is wrong.

    ``mistakes`` have the file and the line where they are.
    """
    from variantgen.families.reading.load import load_family
    from variantgen.single import one_variant

    folder = folder_of(workspace, name)
    files = texts(folder)
    found: dict[str, Any] = {"versions": versions(files), "forms": [], "names": [], "mistakes": []}
    folders = (workspace.folder.resolve(),)
    try:
        family = load_family(name, folders)
        found |= {"title": family.title(language), "forms": list(family.forms), "names": sorted(family.names)}
        form = form if form in family.forms else next(iter(family.forms))
        variant = one_variant(name, seed=str(seed), form=form, folders=folders)
        found |= {"form": form, **_shown(variant, language)}
    except InputError as error:
        found["mistakes"] = _mistakes(error, files, folder, FAMILY, language)
        return found
    found["statements"] = {}
    for each, file in STATEMENTS.items():
        try:
            found["statements"][each] = _told(variant, each)
        except InputError as error:
            found["mistakes"] += _mistakes(error, files, folder, file, language, found["names"])
    return found


def _shown(variant: Any, language: str) -> dict[str, Any]:
    """The figure of a variant, its data and its answers."""
    from variantgen.single import answers, asked_quantities
    from variantgen.studio.gallery.figures import drawn
    from variantgen.wording.formula import Equation, Measured
    from variantgen.wording.html import to_html
    from variantgen.wording.language import load_language
    from variantgen.wording.statement import given

    spoken = load_language(language)
    found = [
        Equation(
            spoken.quantity(answer.quantity, variant.form.symbols),
            Measured(spoken.answer(answer.quantity, answer.value), spoken.unit(answer.unit)),
        )
        for answer in answers(variant)
    ]
    data = given(variant, asked_quantities(variant), spoken)
    return {"figure": drawn(variant, language), "given": [*map(to_html, data)], "answers": [*map(to_html, found)]}


def _told(variant: Any, language: str) -> str:
    """The statement of a variant as markup. Raises InputError."""
    from variantgen.single import asked_quantities
    from variantgen.wording.html import to_html
    from variantgen.wording.language import load_language
    from variantgen.wording.statement import statement

    said = statement(variant, asked_quantities(variant), load_language(language))
    parts = (part if isinstance(part, str) else Markup(to_html(part)) for part in said.text)  # noqa: S704
    return str(Markup("").join(parts))


def _mistakes(
    error: InputError, files: Mapping[str, str], folder: Path, usual: str, language: str, names: Sequence[str] = ()
) -> list[dict[str, Any]]:
    """Mistakes with the file of the family and the line that they are at; of an unknown name also the ``nearest``."""
    found = []
    for problem in error.problems:
        file = Path(problem.file).name if Path(problem.file).name in FILES else usual
        if file in STATEMENTS.values():
            value = f" ({problem.value})" if problem.value else ""
            places = [Mistake(_line_in(files[file], problem), problem.key, problem.message + value, problem.remedy)]
        else:
            places = located([problem], files[file], folder / file)
        near = get_close_matches(problem.value, names, 1) if problem.value in files[file] else []
        more = {"file": file, "word": problem.value, "nearest": near[0] if near else ""}
        found += [{**more, **explained(mistake, language)} for mistake in places]
    return found


def _line_in(text: str, problem: Problem) -> int:
    """The line of a statement that a problem is at: the one it names, else that of the value."""
    named = line_of(problem.message)
    if named > 1 or not problem.value or problem.value not in text:
        return named
    return text.count("\n", 0, text.index(problem.value)) + 1


def solution_page(workspace: Workspace, name: str, form: str, seed: int, language: str) -> bytes:
    """The page of a variant with its worked solution, as SVG. Raises InputError."""
    from variantgen.outputs.single.explanation import explain
    from variantgen.single import one_variant

    folder_of(workspace, name)
    variant = one_variant(name, seed=str(seed), form=form, folders=(workspace.folder.resolve(),))
    with tempfile.TemporaryDirectory() as scratch:
        path = Path(scratch) / "solution.svg"
        explain(variant, language).save(path)
        return path.read_bytes()
