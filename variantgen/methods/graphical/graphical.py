"""The graphical method: velocity and acceleration plans to scale, with the numbers that a ruler gives.

The groups of links are gone through as in the analytical solution; only their vector equations are drawn instead of
projected. The scales are those of the plans that the figures print. What follows from a law (gears, threads, rolling)
is computed, and the drawing goes on from there. Bodies that can only be treated together have no such construction.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from msgspec.structs import replace

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.by_groups import solve_groups
from variantgen.methods.graphical.drawn_geometry import DrawnGeometry
from variantgen.methods.graphical.plan_drawing import PlanDrawing
from variantgen.methods.graphical.plan_scale import per_millimetre, places_of, pole_letter
from variantgen.methods.graphical.vector_chain import VectorChain, chain_of
from variantgen.methods.groups.group import Group, ThirdClassGroup
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book, Known
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.methods.steps.step import NumberOf, Sentence, Step, Term
from variantgen.variants.printed_data import shown_points

_AT_REST = 1e-9  # of the largest velocity
_VIEWS = {"v": "velocity_plan", "a": "acceleration_plan"}


def applies(task: Task) -> bool:
    """Whether something is found by a plan, and no bodies are coupled so that lines of one group do not cross."""
    book = Book(task)
    plans = prepare(book)
    groups = _walk(book)
    return bool(plans.made) and not any(isinstance(group, ThirdClassGroup) for group in groups)


def solve(book: Book) -> None:
    """Enter the velocities and, where asked, the accelerations, found by drawing."""
    prepare(book)
    _walk(book)


def _walk(book: Book) -> list[Group]:
    groups = solve_groups.velocities(book)
    if book.task.order == 2:
        solve_groups.accelerations(book, groups)
    return groups


def prepare(book: Book) -> Plans:
    """Make a book solve its equations by drawing, on the position of the drawn mechanism."""
    plans = Plans(book.task)
    book.geometry = DrawnGeometry(book.task)
    book.graphics = plans
    book.style = MethodStyle("velocity_pole")
    return plans


class Plans:
    """The plans of velocities and accelerations of one solution, each begun when it is first needed."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.made: dict[str, PlanDrawing] = {}
        self._step: Step | None = None

    def write(self, book: Book, left: Sequence[Term], right: Sequence[Term], start: int) -> None:
        """Write a vector equation; see :meth:`PlanDrawing.write`."""
        items = len(book.items)
        plan = self._plan(book, book.letter)
        plan.write(book, left, right, start + len(book.items) - items)

    def solve(self, book: Book, left: Sequence[Term], right: Sequence[Term], wanted: Sequence[Term]) -> list[Value]:
        """Solve a vector equation; see :meth:`PlanDrawing.solve`."""
        return self._plan(book, book.letter).solve(book, left, right, wanted)

    def compose(self, book: Book, name: Name, terms: Sequence[Term]) -> Known:
        """Add known vectors; see :meth:`PlanDrawing.compose`."""
        return self._plan(book, name.kind).compose(book, name, terms)

    def size(self, book: Book, name: Name, terms: Known) -> Value:
        """Measure a known vector; see :meth:`PlanDrawing.size`."""
        return self._plan(book, name.kind).size(book, name, terms)

    def component(self, book: Book, name: Name, terms: Sequence[Term]) -> Expression:
        """Measure a projection; see :meth:`PlanDrawing.component`."""
        return self._plan(book, name.kind).component(book, name, terms)

    def _plan(self, book: Book, letter: str) -> PlanDrawing:
        """The plan of a kind; begun in the step that is being written if it is new."""
        if letter not in self.made:
            plan = begun(self.task, letter)
            self.made[letter] = plan
            self._step = book.steps[-1]
            self._step.views += (_VIEWS[letter],)
            start = Sentence(
                f"graphical.plan_{letter}",
                {"scale": plan.scale, "value": NumberOf(plan.scale), "pole": plan.pole.name},
                detail=False,
            )
            book.items.insert(0, start)
            if len(self.made) == 1:
                book.items.insert(1, Sentence("graphical.lengths", detail=False))
        elif book.steps[-1] is not self._step:
            book.steps[-1].views = ()  # one plan shows all steps
        return self.made[letter]


def begun(task: Task, letter: str) -> PlanDrawing:
    """An empty plan of velocities (``v``) or accelerations (``a``), to the scale of the printed figure."""
    order = 1 if letter == "v" else 2
    now = _in_si(task)
    chain = chain_of(task.form, now, task.sought, shown_points(task.variant, task.asked))
    places = [place / task.length_unit for place in places_of(chain, now, order)]
    scale = Value(Name("scale", letter), "velocity" if order == 1 else "acceleration", float(per_millimetre(places)))
    return PlanDrawing(letter, scale, pole_letter(_moving(chain, now)) if order == 1 else "pi")


def _moving(chain: VectorChain, now: Instant) -> list[str]:
    largest = max(abs(now.v[point]) for point in chain.points)
    return [point for point in chain.points if abs(now.v[point]) > _AT_REST * largest]


def _in_si(task: Task) -> Instant:
    """The motion in metres, as the scene has its numbers."""

    def metres(table: Mapping[str, complex]) -> dict[str, complex]:
        return {name: vector * task.length_unit for name, vector in table.items()}

    now = task.now
    return replace(now, z=metres(now.z), v=metres(now.v), a=metres(now.a))
