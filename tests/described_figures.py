"""Figures of every form with their texts in words, and what tests of these texts share."""

from __future__ import annotations

import math
import re
import string
from dataclasses import dataclass
from functools import cache

from msgspec.structs import replace

from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Drawing
from variantgen.mechanism.motion import Motion
from variantgen.resources import languages
from variantgen.variants.draw import FamilySampler as VariantDrawing
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import letters, to_plain
from variantgen.wording.language import Language, load_language

SEEDS = 3
COMPASS = ("e", "ene", "ne", "nne", "n", "nnw", "nw", "wnw", "w", "wsw", "sw", "ssw", "s", "sse", "se", "ese")


@dataclass(frozen=True)
class DescribedFigure:
    """A figure in one language with what it was made of."""

    variant: Variant
    asked: list[Quantity]
    motion: Motion
    place: int
    language: Language
    figure: Drawing

    @property
    def z(self) -> dict[str, complex]:
        return {name: complex(self.motion.z[name][self.place]) for name in self.motion.z}

    @property
    def words(self) -> dict[str, str]:
        return dict(self.language.words("figure"))

    @property
    def of_graphs(self) -> set[str]:
        """The symbols at the axes of the graphs below the mechanism, without their units."""
        below = (to_plain(label.formula) for label in self.figure.labels if label.at.imag <= self.figure.graphs)
        return {text.partition(", ")[0] for text in below}

    @property
    def labels(self) -> set[str]:
        """Those of the mechanism: a graph below it is told by what it shows."""
        return {to_plain(label.formula) for label in self.figure.labels if label.at.imag > self.figure.graphs}

    def named(self, name: str) -> str:
        return to_plain(self.language.symbol(name, self.variant.form.symbols))

    def items(self, key: str) -> list[str]:
        """The items of a sentence like ``Positions: a; b.``; none where there is no such sentence."""
        head, tail = self.words[key].split("{items}")
        found = re.search(re.escape(head) + "(.*?)" + re.escape(tail) + "(?: |$)", self.figure.alt)
        return found[1].split("; ") if found else []


@cache
def described_figures(name: str, velocities: bool = False) -> list[DescribedFigure]:
    """Every form and language, a few variants each; with ``velocities`` only what needs no accelerations is asked."""
    found = []
    for form in load_family(name).forms.values():
        family = replace(load_family(name), forms={form.name: form})
        variants = VariantDrawing(family, None).after([("told", i) for i in range(SEEDS)], [0] * SEEDS)
        motion = solve_variants(variants, 2)
        asked = [parse_quantity(text, form.sample) for text in form.ask]
        if velocities:
            asked = [q for q in asked if q.order == 1]
        for language in map(load_language, languages()):
            for i, variant in enumerate(variants if asked else []):
                figure = statement_figure(variant, motion, i, asked, language)
                found.append(DescribedFigure(variant, asked, motion, i, language, figure))
    return found


def pattern(phrase: str, **groups: str) -> re.Pattern[str]:
    """A phrase as a pattern that fits a whole item; its slots are the named groups."""
    parts = []
    for text, slot, _, _ in string.Formatter().parse(phrase):
        parts.append(re.escape(text))
        if slot:
            name = slot.partition(".")[0]
            parts.append(f"(?P<{name}>{groups.get(name, '.+?')})")
    return re.compile("".join(parts) + r"\Z")


def asked_together(name: str, quantity: str) -> list[DescribedFigure]:
    """The first form of a family in each language, with one quantity asked."""
    form = next(iter(load_family(name).forms.values()))
    variants = VariantDrawing(load_family(name), None).after([("told", 0)], [0])
    asked = [parse_quantity(quantity, form.sample)]
    motion = solve_variants(variants, 2)
    spoken = [load_language(lang) for lang in languages()]
    return [
        DescribedFigure(
            variants[0], asked, motion, 0, language, statement_figure(variants[0], motion, 0, asked, language)
        )
        for language in spoken
    ]


def words_of(text: str) -> set[str]:
    """Names and symbols in a text: everything in Latin or Greek letters and digits."""
    return set(
        re.findall(r"[A-Za-zα-ωΑ-Ω][A-Za-zα-ω0-9]*(?:_[A-Za-zа-яА-Яα-ω0-9]+(?: [A-Z]\d?(?![a-z0-9A-Z]))?)?", text)
    )


def sector(vector: complex) -> str:
    """The direction of a vector in degrees, from a table: within 1 of an axis, within 22.5 of it, or else."""
    angle = math.degrees(math.atan2(vector.imag, vector.real)) % 360
    bounds = (1, 22.5, 67.5, 89, 91, 112.5, 157.5, 179, 181, 202.5, 247.5, 269, 271, 292.5, 337.5, 359)
    return COMPASS[sum(angle >= bound for bound in bounds) % 16]


def is_between(each: DescribedFigure, z: dict[str, complex], point: str) -> bool:
    """Whether the parts say of a point that it lies between the ends of a bar, and it does."""
    phrase = pattern(each.words["points_on_bar"], bar=r"(?:[A-Z]\d?){2}", points=r"[^()]+").pattern.removesuffix(r"\Z")
    for found in re.finditer(phrase, each.figure.alt):
        first, second = ("".join(part) for part in letters(found["bar"]))
        if point in words_of(found["points"]):
            part = (z[point] - z[first]) / (z[second] - z[first])
            return 0 < part.real < 1 and abs(part.imag) < 1e-9
    return False


def said_arrows(each: DescribedFigure) -> dict[str, str]:
    """What the text says of each given rate, by its symbol."""
    symbols = sorted(each.labels, key=len, reverse=True)
    return {next(s for s in symbols if item.startswith(s + " ")): item for item in each.items("arrows")}
