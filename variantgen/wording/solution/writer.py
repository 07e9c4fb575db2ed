"""Writes a solution in a language: fills the sentences with their facts, and sets the lines of formulas."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.steps.step import (
    Ascending,
    AxisOf,
    Balance,
    Body,
    CentreOf,
    Derived,
    EquationLine,
    Fact,
    Item,
    LinearSystem,
    NumberOf,
    Point,
    ProgramListing,
    Projection,
    Segment,
    Sentence,
    Share,
    Step,
    Term,
    TermTable,
    VectorLine,
    VectorOf,
    Word,
)
from variantgen.methods.steps.step_geometry import ChainGraph
from variantgen.methods.steps.whole_vectors import written_sides
from variantgen.wording.formula import (
    Equation,
    Formula,
    Graph,
    Number,
    Product,
    Sum,
    Surd,
    Symbol,
    Vector,
    is_number_of,
)
from variantgen.wording.solution.document import (
    Block,
    FormulaLine,
    FormulaLines,
    Paragraph,
    Program,
    Section,
    VectorTable,
    VectorTableRow,
    append_block,
    ascending,
    both_sides,
)
from variantgen.wording.solution.formulas import Formulas, without_sign
from variantgen.wording.solution.phrases import Letter, SentenceField
from variantgen.wording.solution.quantity_symbols import Symbols
from variantgen.wording.surds import surd
from variantgen.wording.text import Text

_NOTHING = Number("0")
_MANY = 6  # vectors of an equation that make a table
_UNSAID = ("ways.unknown", "ways.given")  # what the figure shows, or is sought
_EQUALS, _NEARLY = "=", "≈"
_COMMENT = re.compile(r"#\{([\w.]+)\}")


class Writer:
    """Writes the steps of one variant. A ``short`` text leaves out the sentences that only explain, and the tables.

    ``closed``: simple roots and fractions stand beside their decimals.
    """

    def __init__(self, symbols: Symbols, formulas: Formulas, short: bool = False, closed: bool = False) -> None:
        self.symbols = symbols
        self.formulas = formulas
        self.phrases = symbols.phrases
        self.short = short
        self.closed = closed

    def section(self, step: Step) -> Section:
        """A step with its heading; formulas that follow each other are set together."""
        return Section(self.text(step.heading, capital=True), self.blocks(step.items), step.views)

    def blocks(self, items: Iterable[Item]) -> tuple[Block, ...]:
        """The blocks of a run of items."""
        found: list[Block] = []
        for item in items:
            if self.short and (isinstance(item, TermTable) or getattr(item, "detail", False)):
                continue
            if isinstance(item, Projection):
                for sentence in item.words:
                    append_block(found, Paragraph(self.text(sentence, capital=True)))
                if item.is_bare:
                    continue
            append_block(found, self._block(item))
        return tuple(found)

    def _block(self, item: Item) -> Block:
        match item:
            case Sentence():
                return Paragraph(self.text(item, capital=True))
            case Derived():
                return FormulaLines((self._derived(item),))
            case VectorLine():
                sides = [self._sum([(1, self.vector(term.name)) for term in side]) for side in written_sides(item)]
                return FormulaLines((FormulaLine((("", sides[0]), (_EQUALS, sides[1]))),))
            case TermTable(terms):
                return self._table(terms)
            case Projection():
                return self._projection(item)
            case Balance(left, right):
                first, second = (right, left) if _is_quantity(right) and not _is_quantity(left) else (left, right)
                return both_sides(self._side(first, by_symbol=True), self._side(second))
            case Ascending(values):
                return ascending([self._side(value) for value in values])
            case LinearSystem():
                return FormulaLines(tuple(self._equation(item, i) for i in range(len(item.rows))))
            case EquationLine(left, right, numeric):
                write = self.formulas.numeric if numeric else self.formulas.symbolic
                return FormulaLines((FormulaLine((("", write(left)), (_EQUALS, write(right)))),))
            case ProgramListing(code, _):
                return Program(self._commented(code))
            case ChainGraph():
                return FormulaLines((FormulaLine((("", self._graph(item)),)),))

    def _graph(self, chain: ChainGraph) -> Formula:
        """A chain of links as a graph, with their numbers above its arrows."""
        legs = ((Number(str(number)), Symbol(end)) for number, end in enumerate(chain.ends, 1))
        return Graph(Symbol(chain.start), tuple(legs))

    def _commented(self, code: str) -> str:
        """A program with its comments in the language: ``#{listing.data}`` is the sentence of that key."""
        return _COMMENT.sub(lambda match: "# " + "".join(map(str, self.phrases.sentence(match[1]))), code)

    # Sentences.

    def text(self, sentence: Sentence, capital: bool = False, form: str = "") -> Text:
        """A sentence, or a form of it, filled with its facts."""
        parts: list[str | Formula] = []
        for part in self.phrases.sentence(f"{sentence.key}.{form}" if form else sentence.key):
            if isinstance(part, SentenceField):
                parts += self._fact(sentence.facts[part.name], part.form)
            elif isinstance(part, Letter):
                parts.append(Symbol(self.formulas.language.axis(part.name)))
            else:
                parts.append(part)
        if capital and parts and isinstance(parts[0], str):
            parts[0] = parts[0][:1].upper() + parts[0][1:]
        return tuple(parts)

    def _fact(self, fact: Fact, form: str) -> Sequence[str | Formula]:
        match fact:
            case Body(name):
                return self.symbols.body(name, form)
            case Point(name):
                return (Symbol(f"{name}′" if form == "under" else name),)
            case Segment(start, end, centre_of):
                part, body = ("centre", centre_of) if centre_of else ("", "")
                return (self.symbols.of(Name("length", start, end, part, body)),)
            case Word(key):
                return (self.phrases.words[key],)
            case VectorOf(name):
                return (self.vector(name),)
            case CentreOf(body, kind):
                return (self.symbols.centre(kind, body),)
            case AxisOf(letter):
                return (Symbol(self.formulas.language.axis(letter)),)
            case NumberOf(Value(expression=Expression() as whole) as value, worked_out=True):
                return (Equation(self.formulas.numeric(whole), self.formulas.measured(value)),)
            case NumberOf(value):
                return (self.formulas.measured(value),)
            case Value():
                return (self.formulas.symbol(fact),)
            case Name():
                return (self.symbols.of(fact),)
            case Sentence():
                return self.text(fact, form=form)
        return self._list(fact, form)

    def _list(self, facts: tuple[Fact, ...], form: str) -> Sequence[str | Formula]:
        """Facts with commas, and a word before the last."""
        parts: list[str | Formula] = []
        for number, fact in enumerate(facts):
            if number:
                parts.append(f" {self.phrases.words['and']} " if number == len(facts) - 1 else ", ")
            parts += self._fact(fact, form)
        return parts

    # Formulas.

    def vector(self, name: Name) -> Formula:
        """A vector with its arrow."""
        return Vector(self.symbols.letter(name))

    def _derived(self, item: Derived) -> FormulaLine:
        """``name = symbols = numbers = result``; what says the same twice is said once. A sum may have no name."""
        value, expression = item.value, item.value.expression
        result = self.formulas.measured(value)
        pieces = [] if item.law is None else [self.formulas.symbolic(item.law)]
        if expression is not None and not _is_plain(expression):
            writes: list[tuple[bool, Callable[[Expression], Formula]]] = [
                (item.symbolic, self.formulas.symbolic),
                (item.numeric, self.formulas.numeric),
            ]
            pieces += [write(expression) for wanted, write in writes if wanted]
        elif isinstance(expression, Value) and item.symbolic and expression.name is not None:
            pieces.append(self.formulas.symbolic(expression))
        kept = list(dict.fromkeys(piece for piece in pieces if not is_number_of(piece, result)))
        closed = self._closed_form(value)
        sign = _EQUALS if value.comes_out or not kept else _NEARLY
        end = ((_EQUALS, closed), (_NEARLY, result)) if closed is not None else ((sign, result),)
        symbols = [] if value.name is None else [self.symbols.of(value.name)]
        (_, first), *rest = ((_EQUALS, side) for side in (*symbols, *kept))
        return FormulaLine((("", first), *rest, *end))

    def _closed_form(self, value: Value) -> Surd | None:
        """The root or fraction that a value is; none where its decimal, computed from rounded numbers, is another."""
        if not self.closed or value.measure == "angle":
            return None
        found = surd(value.exact)
        # A fraction whose decimal is printed whole tells nothing new: 2523/2 is 1261.5.
        whole = found is not None and found.radicand == 1 and found.numerator == value.shown * found.denominator
        return None if whole else found

    def _directions(self, terms: Sequence[Term]) -> Paragraph:
        """Where vectors point, in a sentence; nothing where the figure shows all."""
        parts: list[str | Formula] = []
        for number, term in enumerate(terms):
            start = " " if number == 0 else "; "
            parts += [start, self.vector(term.name), self.phrases.words["dash"], *self.text(term.way)]
        return Paragraph((self.phrases.words["directions"], *parts, ".") if parts else ())

    def _sum(self, terms: Sequence[tuple[int, Formula]]) -> Formula:
        if not terms:
            return _NOTHING
        return terms[0][1] if len(terms) == 1 and terms[0][0] > 0 else Sum(tuple(terms))

    def _projection(self, item: Projection) -> FormulaLines:
        sides = [self._sum([(share.sign, self._share(share)) for share in side]) for side in (item.left, item.right)]
        return FormulaLines((FormulaLine((("", sides[0]), (_EQUALS, sides[1]))),))

    def _share(self, share: Share) -> Formula:
        size = self.symbols.of(share.term.name)
        if share.factor is None:
            return size
        return Product((size, self.formulas.symbolic(share.factor)))

    def _equation(self, system: LinearSystem, row: int) -> FormulaLine:
        """A row of a linear system with its numbers: ``9.63 omega_2 - 37.91 omega_3 = -84.85``."""
        terms: list[tuple[int, Formula]] = []
        for unknown, coefficient in zip(system.unknowns, system.rows[row], strict=True):
            if coefficient.shown == 0:
                continue
            symbol = self.formulas.symbol(unknown)
            size = self.formulas.numeric(without_sign(coefficient))
            term = symbol if abs(coefficient.shown) == 1 else Product((size, symbol))
            terms.append((1 if coefficient.shown > 0 else -1, term))
        right = self.formulas.printed(system.right[row])
        return FormulaLine((("", self._sum(terms)), (_EQUALS, right)))

    def _side(self, value: Value, by_symbol: bool = False) -> FormulaLine:
        """A sum in numbers with its result; ``by_symbol`` a single quantity by its symbol: its number is known."""
        assert value.expression is not None
        if by_symbol and isinstance(value.expression, Value) and _is_quantity(value):
            return FormulaLine((("", self.formulas.symbol(value.expression)),))
        written, result = self.formulas.numeric(value.expression), self.formulas.printed(value)
        if written == result:
            return FormulaLine((("", result),))
        return FormulaLine((("", written), (_EQUALS if value.comes_out else _NEARLY, result)))

    def _table(self, terms: Sequence[Term]) -> Block:
        """The vectors of an equation with their directions: a table of many, a sentence of a few."""
        words = self.phrases.words
        if len(terms) < _MANY:
            return self._directions([term for term in terms if term.way.key not in _UNSAID])
        rows = []
        for term in terms:
            magnitude = None if term.size is None else self.formulas.measured(term.size)
            rows.append(VectorTableRow(self.vector(term.name), self.text(term.way), magnitude))
        return VectorTable((words["vector"], words["direction"], words["magnitude"]), words["unknown"], tuple(rows))


def _is_quantity(side: Value) -> bool:
    """Whether a side of a check is one quantity that the solution has found."""
    return isinstance(side.expression, Value) and side.expression.name is not None


def _is_plain(expression: Expression) -> bool:
    """Whether an expression is a number or another value, so that it has no arithmetic to show."""
    return isinstance(expression, Constant | Value)
