"""The jobs of a build: each can be done by any process, and its result depends on nothing but the job."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any, Protocol

from msgspec import Struct

from variantgen.builder.build_spec import BuildSpec, WorkerContext, worker_context
from variantgen.builder.kept import KeptParts, KeptProblem
from variantgen.exam.allocation import DrawRequest
from variantgen.exam.content import Content
from variantgen.exam.exam import Exam
from variantgen.exam.packing import pack, unpack
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.files.records import RECORDS, key_rows, manifest_lines
from variantgen.outputs.formats import STUDENTS_PER_PART, Chunk, Fragment, format_of
from variantgen.variants.attempts import VerificationError
from variantgen.variants.similarity import Traits


class Job(Protocol):
    """Some work of a build."""

    def run(self, setting: WorkerContext) -> Any:
        """Do it."""


def perform(spec: BuildSpec, job: Job) -> Any:
    """Do a job in this process.

    Raises VerificationError, with the seed, where two computations of a variant disagree.
    """
    with worker_context(spec) as setting, _without_collector():
        try:
            return job.run(setting)
        except VerificationError as error:
            raise VerificationError(f"{error} (seed {setting.exam.seed})") from error


class Made(Protocol):
    """What a job has made."""

    def keep(self, kept: KeptParts, place: Any) -> Any:
        """Put it to the finished parts; what the main process has to know of it."""


class KeepJob(Struct, frozen=True):
    """A job whose worker keeps what it has made, at a place among the finished parts, and hands back the rest."""

    job: Job
    kept: KeptParts
    place: Any

    def run(self, setting: WorkerContext) -> Any:
        """Do it and keep it."""
        made: Made = self.job.run(setting)
        return made.keep(self.kept, self.place)


class Compared(Struct, frozen=True):
    """What is compared of some variants, and how many were drawn again for the exam's ceiling of tolerances."""

    traits: Traits
    cut: int


class DrawnProblems(Struct, frozen=True):
    """Packed problems by parts of students, and what is compared of their variants."""

    parts: tuple[bytes, ...]
    compared: Compared

    def keep(self, kept: KeptParts, place: tuple[int, int]) -> Compared:
        """Keep the problems as the first draws of the students from a place on, of a problem."""
        kept.put_drawn(*place, self.parts)
        return self.compared


class DrawJob(Struct, frozen=True):
    """Some requests drawn, solved and verified."""

    requests: tuple[DrawRequest, ...]

    def run(self, setting: WorkerContext) -> DrawnProblems:
        """Draw, solve, verify."""
        variants = setting.drawer.variants(self.requests)
        items = setting.drawer.items(self.requests, variants)
        parts = [items[i : i + STUDENTS_PER_PART] for i in range(0, len(items), STUDENTS_PER_PART)]
        packed = tuple(pack(setting.exam, part) for part in parts)
        drawer = setting.drawer
        traits, cut = drawer.traits(self.requests, variants), drawer.cut(self.requests, variants)
        return DrawnProblems(packed, Compared(traits, cut))


class CompareJob(Struct, frozen=True):
    """The next draws of some requests, only to be compared."""

    requests: tuple[DrawRequest, ...]

    def run(self, setting: WorkerContext) -> Traits:
        """Draw."""
        found = setting.drawer.traits(self.requests, setting.drawer.variants(self.requests))
        setting.drawer.forget()
        return found


class PackedChunk(Struct, frozen=True):
    """Some students with the codes of their sheets, and their packed problems: each problem for all of them, or where
    it is kept.
    """

    students: tuple[tuple[Student, str], ...]
    problems: tuple[bytes | KeptProblem, ...]

    def sheets(self, exam: Exam) -> tuple[Sheet, ...]:
        """Their sheets."""
        problems = [unpack(exam, one.read() if isinstance(one, KeptProblem) else one) for one in self.problems]
        return tuple(
            Sheet(student, code, items)
            for (student, code), items in zip(self.students, zip(*problems, strict=True), strict=True)
        )


class RenderedChunk(Struct, frozen=True):
    """The pieces of a part by format, and the families of problems in it that have no worked solution."""

    pieces: tuple[tuple[str, Fragment], ...]
    unexplained: tuple[str, ...] = ()

    def keep(self, kept: KeptParts, place: int) -> None:
        """Keep the pieces."""
        kept.put_made(place, self.pieces, self.unexplained)


class RenderJob(Struct, frozen=True):
    """All outputs of a few students, or one overview of one format.

    ``beginning`` are the groups whose first student is among them, ``first`` says whether that of all is.
    """

    parts: tuple[PackedChunk, ...]
    beginning: frozenset[str]
    first: bool
    summary: tuple[str, int] | None = None

    def run(self, setting: WorkerContext) -> RenderedChunk:
        """Make the pieces."""
        exam = setting.exam
        sheets = tuple(sheet for part in self.parts for sheet in part.sheets(exam))
        content = Content(exam, sheets)
        part = Chunk(content, self.first, setting.engine, self.beginning)
        pieces = [(name, piece) for name, make in self._makers(exam.formats) for piece in make(part)]
        return RenderedChunk(tuple(pieces), () if self.summary else content.unexplained)

    def _makers(self, chosen: Iterable[str]) -> Iterator[tuple[str, Callable[[Chunk], Iterable[Fragment]]]]:
        if self.summary:
            name, place = self.summary
            yield name, format_of(name).SUMMARIES[place][1]
        else:
            yield RECORDS, _records
            yield from ((name, format_of(name).make) for name in chosen)


def _records(part: Chunk) -> Iterator[Fragment]:
    """What every build has, whatever its formats are."""
    yield Fragment("key.csv", key_rows(part.sheets).encode())
    yield Fragment("manifest.json", manifest_lines(part.exam, part.sheets).encode())


class CallJob(Struct, frozen=True):
    """A function of a module, applied to files that are on the disk of all workers."""

    function: Callable[[Any], Any]
    given: Any

    def run(self, setting: WorkerContext) -> Any:
        """Call it."""
        return self.function(self.given)


@contextmanager
def _without_collector() -> Iterator[None]:
    """Nothing is searched for cycles of references inside the block: in the many small objects of a part the search
    would take a tenth of the time, and what it could free until the end of the part is little.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()
