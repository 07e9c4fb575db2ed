"""Names of quantities as symbols, bodies and centres as they are called in a language."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.algebra.name import ON_LINE, Name
from variantgen.families.family import Form
from variantgen.families.quantities import split_name
from variantgen.mechanism.linkage import Linkage
from variantgen.wording.formula import Dotted, Formula, FormulaList, Function, Index, Quotient, Symbol, Vector
from variantgen.wording.formula.tree import ANGLE
from variantgen.wording.language import Language, on_line
from variantgen.wording.solution.phrases import Phrases

_COMPOUND = ("rel", "tr", "cor")
_AXES = {"x": "x", "y": "y", "on_n": "n", "on_tau": "tau", "xi": "xi", "eta": "eta"}
_COMPONENTS = ("n", "tau")  # of an acceleration: towards the centre, along the path


class Symbols(Struct, frozen=True, eq=False):
    """How the names of one variant are written. ``centres`` are the letters of velocity centres by body."""

    form: Form
    language: Language
    phrases: Phrases
    centres: Mapping[str, Symbol]
    _letters: dict[Name, Symbol] = field(default_factory=dict)

    def of(self, name: Name) -> Formula:
        """The symbol of a name; a derivative by time has dots; direction cosines are functions."""
        if name.kind == "cosine":
            vector = self._vector(Name(name.body, name.of))
            return Function(self.phrases.functions["cos"], FormulaList((Vector(vector), Symbol(name.part))))
        if name.kind == "turn":
            return self.language.quantity(split_name(name.of), self.form.symbols)
        if name.kind == "ratio":
            return Quotient(self.letter(Name("omega", name.of)), self.letter(Name("omega", name.about)))
        return Dotted(self.letter(name), name.dots) if name.dots else self.letter(name)

    def letter(self, name: Name) -> Symbol:
        """The symbol of a name without dots."""
        if name not in self._letters:
            self._letters[name] = self._letter(name)
        return self._letters[name]

    def _letter(self, name: Name) -> Symbol:
        match name.kind:
            case "parameter":
                return self.language.symbol(name.of, self.form.symbols)
            case "x" | "y" if name.body:
                centre = self.centre(name.of, name.body)
                return Symbol(name.kind, (Index(centre.base), *centre.index))
            case "rope":
                return self.language.of_rope(name.of, name.about, self.form.symbols)
            case "turn_between":
                return Symbol("theta")
            case "limit":
                return Symbol(name.of, (Index(name.about),))
            case "limit_corner":
                start, end = name.of.split()
                return Symbol(f"{ANGLE}{start}{name.body}{end}", (Index(name.about),))
            case "curvature":
                return Symbol("rho", (Index(name.of),))
            case "x" | "y":
                return Symbol(name.kind, (Index(name.of),))
            case "angle":
                return self._corner(name)
            case "inclination":
                return Symbol(name.of, (Index(name.about),) if name.about else ())
            case "mu":
                return Symbol("mu", self._body_index(name.of))
            case "length" | "direction":
                return self._of_points(name)
            case "rotation":
                return Symbol("psi", self._body_index(name.of))
            case "slide" | "arc" | "swing" | "offset":
                letters = {"slide": "s", "arc": "chi", "swing": "theta", "offset": "h"}
                return Symbol(letters[name.kind], self._body_index(name.of + name.about))
            case "radius":
                number = (Index(name.about),) if name.about else ()
                return Symbol("r", (*number, *self._body_index(name.of)))
            case "heading":
                return Symbol("theta", self._vector(replace(name, kind=name.body, body="")).index)
            case "omega" | "epsilon":
                index = [*self._body_index(name.of), *([Index("z")] if name.part == "z" else [])]
                return Symbol(self.language.letter(name.kind), tuple(index))
            case "drawn":
                return self._drawn(name)
            case "scale":
                return Symbol("mu", (Index(name.of),))
            case "pole":
                return Symbol(name.of)
            case "image":
                return Symbol(name.of.lower(), self._words(name), (Index("prime"),) if name.body == "a" else ())
        return self._vector(name)

    def _drawn(self, name: Name) -> Symbol:
        """The length on paper of a segment, ``l_AB``, or of a vector: ``l`` with its index."""
        if name.body == "l":
            return Symbol("l", (Index(name.of + name.about),))
        vector = self._vector(name)
        return vector._replace(base="l")

    def _of_points(self, name: Name) -> Symbol:
        """A segment ``AB``, ``AP``; the direction of a ray, ``phi_AB``."""
        end = self.centre(name.about, name.body) if name.part == "centre" else Symbol(name.about)
        if name.kind == "direction":
            if {name.of, end.base} & set(self.form.figure.hidden):  # of a slot that has no letters
                return Symbol("phi", (Index(self.language.words("index")["rel"], True),))
            return Symbol("phi", (Index(name.of + end.base),))
        return Symbol(name.of + end.base, end.index)

    def _corner(self, name: Name) -> Symbol:
        """A corner of a triangle by its three points, ``BAP``; one at a centre by this alone."""
        start, end = name.about.split()
        if name.part == "vertex":
            centre = self.centre(name.of, name.body)
            return Symbol(f"{ANGLE}{centre.base}", centre.index)
        last = self.centre(end, name.body) if name.part == "centre" else Symbol(end)
        return Symbol(f"{ANGLE}{start}{name.of}{last.base}", last.index)

    def centre(self, letter: str, body: str) -> Symbol:
        """The letter of a velocity centre (P) or an acceleration centre (Q), with the index that tells bodies apart."""
        found = self.centres[body]
        return found if letter == found.base else Symbol(letter, found.index)

    def _body_index(self, body: str) -> tuple[Index, ...]:
        text = self.form.symbols.get(body, body)
        return (Index(text),) if text else ()

    def _vector(self, name: Name) -> Symbol:
        """A vector or its component: ``v_BA``, ``a^n_BA``, ``v_rel D``, ``v_Bx``."""
        words = name.part.split()
        axes = [Index(self.language.axis(_AXES[w])) for w in words if w in _AXES]
        axes += [Index(on_line(word)) for word in words if word.startswith(ON_LINE)]
        carried = self.language.carrying(name.of) if "tr" in words else (Index(name.of),)
        before, point = carried[:-1], carried[-1]
        if name.about:
            end = self.language.carrying(name.of)[-1] if self._is_carried(name) else point
            point = self.language.relative_to(end.text, name.about)
        spoken = self._words(replace(name, part=" ".join(word for word in words if word != "tr")))
        symbol = Symbol(self.language.letter(name.kind), (*before, *spoken, point, *axes))
        for word in words:
            if word in _COMPONENTS:
                symbol = self.language.with_component(symbol, word)
        return symbol

    def _is_carried(self, name: Name) -> bool:
        """Whether a vector about a point of a body is that of its place under another point, in a straight slot of it.

        About the centre of a round slot it is that of the point itself, whose distance is constant.
        """
        bodies = self.form.bodies
        straight = (path.body for path in Linkage(self.form.sample).slides if path.point == name.of and path.line)
        return any(name.about in bodies[body] and name.of not in bodies[body] for body in straight)

    def _words(self, name: Name) -> tuple[Index, ...]:
        """What an index says of a compound motion: relative, transport, Coriolis."""
        words = (word for word in name.part.split() if word in _COMPOUND)
        return tuple(Index(self.language.words("index")[word], True) for word in words)

    def body(self, name: str, form: str) -> tuple[str | Symbol, ...]:
        """A body in a form of its name, ``link AB``, ``disc 2``; one without a name is called by its kind alone."""
        kind = self._kind(name)
        noun = self.phrases.bodies[kind][form or "name"]
        called = self.form.symbols.get(name, name.removeprefix(kind) if kind in name else name)
        if not called:
            return (self.phrases.words["the"] + noun,)
        return (f"{noun}\N{NO-BREAK SPACE}", Symbol(called))

    def _kind(self, name: str) -> str:
        """The kind of a body: as the family calls it, by its name (``wheel``, ``gear2``), or by how it is drawn."""
        if self.form.nouns.get(name) in self.phrases.bodies:
            return self.form.nouns[name]
        if (noun := name.rstrip("0123456789")) in self.phrases.bodies:
            return noun
        if any(disc.body == name for disc in self.form.figure.discs):
            return "disc"
        return "plate" if name in self.form.figure.plates else "link"


def centre_letters(bodies: Mapping[str, str], taken: Collection[str]) -> dict[str, Symbol]:
    """The letters of velocity centres by body; ``bodies`` gives the index of each, ``taken`` are names of points."""
    if len(bodies) == 1 and "P" not in taken:
        return dict.fromkeys(bodies, Symbol("P"))
    unnamed = Symbol("P", (Index("v"),)) if "P" in taken else Symbol("P")
    return {body: Symbol("P", (Index(name),)) if name else unnamed for body, name in bodies.items()}
