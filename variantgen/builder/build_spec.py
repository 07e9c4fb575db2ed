"""What a worker needs to know of an exam, as data that any process on any machine can be given."""

from __future__ import annotations

import hashlib
import pickle
import tempfile
import threading
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from functools import cached_property
from pathlib import Path
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import VariantgenError
from variantgen.exam.allocation import ProblemSampler
from variantgen.exam.exam import Exam
from variantgen.exam.manifest import made_with
from variantgen.families.reading.files import family_files
from variantgen.outputs.formats import parse_exam
from variantgen.outputs.typst.typesetter import Typesetter, typesetter
from variantgen.resources import catalog_dir

_FROM_TEXT = ("tasks", "path", "hash", "text")
_LOCK = threading.Lock()


class OtherVersionError(VariantgenError):
    """A worker would not make the same bytes: it has other versions or other families."""

    may_pass = True


class BuildSpec(Struct, frozen=True):
    """An exam to be built with a seed.

    Its problems are read again from its ``text``, with the ``families`` that are not in the catalogue (content of their
    files by name and path); ``settings`` are its other fields. ``made_with`` and ``tasks`` (a hash) must be the same
    for the worker.
    """

    path: str
    text: str
    settings: Mapping[str, Any]
    families: Mapping[str, Mapping[str, bytes]]
    made_with: Mapping[str, str]
    tasks: str

    @staticmethod
    def of(exam: Exam) -> BuildSpec:
        """The description of an exam for its workers."""
        fields = [name for name in Exam.__struct_fields__ if name not in _FROM_TEXT]
        return BuildSpec(
            str(exam.path),
            exam.text,
            {name: getattr(exam, name) for name in fields},
            dict(_own_families(exam)),
            made_with(exam),
            _tasks(exam),
        )

    @property
    def name(self) -> str:
        """A name that no other exam has."""
        parts = (self.path, self.text, repr(self.settings), repr(self.families), self.tasks)
        return hashlib.sha256(pickle.dumps((*parts, sorted(self.made_with.items())))).hexdigest()

    def exam(self, folder: Path) -> Exam:
        """The exam, in a process that does not have it; files of families are put into a folder, where they must stay.

        Raises OtherVersionError.
        """
        for name, files in self.families.items():
            for inside, content in files.items():
                path = folder / name / inside
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
        exam = replace(parse_exam(self.text, Path(self.path), (folder,)), **self.settings)
        here = made_with(exam)
        other = [name for name, value in self.made_with.items() if here.get(name) != value]
        if other:
            described = ", ".join(f"{name} {here.get(name)} in place of {self.made_with[name]}" for name in other)
            raise OtherVersionError(
                f"a worker has other versions than this program: {described}; install the same there"
            )
        if _tasks(exam) != self.tasks:
            raise OtherVersionError("the exam was changed after it was read: workers can only read it from its text")
        return exam


def _own_families(exam: Exam) -> Iterator[tuple[str, dict[str, bytes]]]:
    """The files of families that are not in the catalogue."""
    for family in (family for task in exam.tasks for family in task.families):
        folder = family.folder
        if folder is not None and catalog_dir().resolve() not in folder.resolve().parents:
            yield family.name, family_files(folder)


def _tasks(exam: Exam) -> str:
    """A hash of what the problems of an exam are drawn from."""
    described: list[object] = []
    for task in exam.tasks:
        described.append((task.number, task.ask, task.points, task.methods, task.nice))
        for family in task.families:
            for form in family.forms.values():
                described.append((family.name, form.name, [(name, p.printed) for name, p in form.parameters.items()]))
    return hashlib.sha256(repr(described).encode()).hexdigest()


class WorkerContext(Struct, frozen=True, dict=True):
    """The exam and the typesetting engine that all jobs of a build share in one process."""

    exam: Exam
    engine: Typesetter

    @cached_property
    def drawer(self) -> ProblemSampler:
        """Draws problems; it remembers what follows from the exam alone."""
        return ProblemSampler(self.exam)


_settings: dict[str, WorkerContext] = {}
_lasting = ExitStack()


@contextmanager
def preloaded(spec: BuildSpec, exam: Exam, engine: Typesetter) -> Iterator[None]:
    """Jobs in this process, and in those forked from it inside the block, find the exam as it is."""
    _settings[spec.name] = WorkerContext(exam, engine)
    try:
        yield
    finally:
        _settings.pop(spec.name, None)


@contextmanager
def worker_context(spec: BuildSpec) -> Iterator[WorkerContext]:
    """The setting of a build in this process, for one thread at a time (the engine has but one memory)."""
    with _LOCK:
        if spec.name not in _settings:
            _settings.clear()
            _lasting.close()
            import multiprocessing.util

            # At the end of a process, of whatever kind, its folders are removed.
            multiprocessing.util.Finalize(None, _lasting.close, exitpriority=1)
            folder = Path(_lasting.enter_context(tempfile.TemporaryDirectory(prefix="variantgen-")))
            engine = _lasting.enter_context(typesetter())
            _settings[spec.name] = WorkerContext(spec.exam(folder), engine)
        yield _settings[spec.name]
