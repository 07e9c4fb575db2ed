"""A family that nobody wrote: laid out, asked for what it is good for, examined on draws, written to a folder."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem, VariantgenError
from variantgen.families.family import Family
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.families.reading.files import FAMILY
from variantgen.families.reading.load import load_family
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import ComplexField, Motion
from variantgen.synthesis.chance import Chance
from variantgen.synthesis.crowding import crossed
from variantgen.synthesis.draft import Draft, LayoutError
from variantgen.synthesis.family_text import changes_speed, family_text
from variantgen.synthesis.layout import lay_out
from variantgen.synthesis.revolving import called
from variantgen.synthesis.statement_text import composed_languages, statement_text, title
from variantgen.synthesis.structures import Structure, code, moving_links
from variantgen.variants.attempts import FormSampler
from variantgen.variants.batch import MakeScreening, RejectionCounts
from variantgen.variants.screening import motion_screens, sensitivity
from variantgen.variants.seeding import Stream
from variantgen.variants.variant import Variant

MOST_TRIES = 320  # layouts of a structure
_LOOKED_AT, _BY_HAND = 48, 6  # draws of a layout: all of them, and those whose solutions are worked out
_VALID, _VALID_ASKED = 0.3, 0.15  # least shares of them that pass the screens, without answers and with them
_CM = 100.0  # of a metre
_MANY = 1000  # on which no links cross, and are called cranks and rockers
_GOOD, _FIT = 0.6, 3  # share of draws on which a quantity is a good answer; draws that a hand can work out
_MOST_ASKED = {1: 5, 2: 6, 3: 5}
_FEWEST = 3
_AT_REST = 1e-9  # of the largest angular velocity
_WIDTHS = (1.0, 0.5)  # how far values vary: less where links would cross


class Composed(Struct, frozen=True):
    """A family that was accepted: its structure, its files by their names."""

    structure: Structure
    files: dict[str, str]
    family: Family


def compose(
    structure: Structure,
    seed: object,
    screening: MakeScreening,
    scratch: Path,
    faults: Callable[[Family], str],
    unfit: Callable[[Variant, Sequence[Quantity]], str],
    orders: Sequence[int] = (2,),
    tries: int = MOST_TRIES,
    fewer_too: bool = False,
) -> Composed:
    """A family of a structure that passes all screens; which one depends on the seed.

    ``screening`` are further screens of draws, ``faults`` says what else is wrong with a family, "" for nothing, and
    ``unfit`` of one variant and what is asked, before much is worked out; ``scratch`` is a folder to try layouts in, at
    most ``tries``. ``orders``: first accelerations are asked as well (2), then velocities alone (1); ``fewer_too``: of
    each all, then fewer. Raises InputError where none passes.
    """
    chance, why = Chance("compose", code(structure), seed), "no layout"
    for _ in range(tries):
        try:
            draft = lay_out(structure, chance)
            varied = _varied(draft, structure, scratch)
        except (LayoutError, VariantgenError) as error:
            why = str(error)
            continue
        for asked in _askings(draft, varied[1], orders, fewer_too):
            try:
                files, family = _accepted(draft, varied, structure, screening, scratch, asked, unfit)
                why = faults(family)
                if not why:
                    return Composed(structure, files, family)
            except (LayoutError, VariantgenError) as error:
                why = str(error)
    raise InputError(
        Problem(
            f"no layout of the structure passes the screens, the last one: {why}",
            key="structure",
            value=code(structure),
            remedy="try another seed or another structure",
        )
    )


def sketched(structure: Structure, seed: object, scratch: Path) -> Family:
    """A family of a structure for a picture: it has not been examined whether its answers are any good.

    Raises InputError where the tries are used up. ``scratch`` is a folder to write it to.
    """
    chance = Chance("sketch", code(structure), seed)
    for _ in range(MOST_TRIES):
        with suppress(LayoutError, VariantgenError):
            return _varied(lay_out(structure, chance), structure, scratch)[0]
    raise InputError(Problem("no layout was found", key="structure", value=code(structure)))


def _varied(draft: Draft, structure: Structure, scratch: Path) -> tuple[Family, _Draws, float]:
    """The family of a draft that asks for nothing in particular, draws of it, and how far its values vary.

    Raises LayoutError where few draws are valid, a link is at rest, or links cross on some; what shows on few draws is
    looked for first.
    """
    _write_statements(draft, scratch)
    why = ""
    for width in _WIDTHS:
        family = _family(family_text(draft, _titles(draft, structure), code(structure), ["a_A"], width), scratch)
        try:
            draws = _Draws(family, _quantities(family, ["a_A"]), _VALID)
        except LayoutError as error:
            why = str(error)
            continue
        if draws.has_resting_rotation():
            raise LayoutError("a link that could turn does not turn in this position")
        why = "links cross in other variants"
        if _are_crossed(draft, draws.motion.z):
            continue
        many = draws.many()
        if not _are_crossed(draft, many):
            draft.called = called(draft, many)
            _write_statements(draft, scratch)
            return family, draws, width
    raise LayoutError(why)


def _are_crossed(draft: Draft, z: Mapping[str, ComplexField]) -> bool:
    """Whether links cross on any of some draws, whose places are in metres."""
    return bool(np.any(crossed(draft, {name: _CM * places for name, places in z.items()})))


def _statements(draft: Draft) -> dict[str, str]:
    return {f"statement.{language}.j2": statement_text(draft, language) for language in composed_languages()}


def _write_statements(draft: Draft, scratch: Path) -> None:
    for name, text in _statements(draft).items():
        (scratch / name).write_text(text, "utf-8")


def _titles(draft: Draft, structure: Structure) -> dict[str, str]:
    return {language: title(language, draft, moving_links(structure)) for language in composed_languages()}


def _accepted(
    draft: Draft,
    varied: tuple[Family, _Draws, float],
    structure: Structure,
    screening: MakeScreening,
    scratch: Path,
    asked: list[str],
    unfit: Callable[[Variant, Sequence[Quantity]], str],
) -> tuple[dict[str, str], Family]:
    """The files of a draft that passes, and its family. Raises LayoutError, InputError."""
    family, draws, width = varied
    if unfit(draws.variant(0), _quantities(family, asked)) and not draft.brief:
        draft.brief = True  # the statement may be too long
        _write_statements(draft, scratch)
    if why := unfit(draws.variant(0), _quantities(family, asked)):
        raise LayoutError(why)
    text = family_text(draft, _titles(draft, structure), code(structure), asked, width)
    family = _family(text, scratch)
    draws = _Draws(family, _quantities(family, asked), _VALID_ASKED)
    if draws.fit(screening) < _FIT:
        raise LayoutError("rounding by hand leads too far")
    return {FAMILY: text, **_statements(draft)}, family


def _family(text: str, scratch: Path) -> Family:
    (scratch / FAMILY).write_text(text, "utf-8")
    return load_family(scratch)


def _quantities(family: Family, names: Sequence[str]) -> list[Quantity]:
    form = next(iter(family.forms.values()))
    return [parse_quantity(name, form.sample) for name in names]


class _Draws:
    """Draws of a form that pass its own screens for some answers. Raises LayoutError where there are too few."""

    def __init__(self, family: Family, asked: Sequence[Quantity], least: float) -> None:
        self.form = next(iter(family.forms.values()))
        self.sampler = FormSampler(family, self.form, asked, RejectionCounts(), "composed")
        words = Stream("compose", "draws").words(_LOOKED_AT * (len(self.form.parameters) + 1)).reshape(_LOOKED_AT, -1)
        numbers = np.arange(_LOOKED_AT)
        self.attempts = self.sampler.valid(self.sampler.attempts(words, numbers, numbers))
        if self.attempts.motion is None or self.attempts.number.size < least * _LOOKED_AT:
            raise LayoutError("few draws are valid")
        self.motion: Motion = self.attempts.motion

    def many(self) -> Mapping[str, ComplexField]:
        """The places of points on very many draws that pass the screens of the form, not only on those."""
        words = Stream("compose", "many").words(_MANY * (len(self.form.parameters) + 1)).reshape(_MANY, -1)
        motion = self.sampler.valid(self.sampler.attempts(words, np.arange(_MANY), np.arange(_MANY))).motion
        return self.motion.z if motion is None else motion.z

    def good(self, name: str) -> NDArray[np.bool_]:
        """On which of them a quantity is neither trivial nor touchy."""
        quantity = parse_quantity(name, self.form.sample)
        passed = np.all(list(motion_screens(self.form, self.motion, [quantity]).values()), axis=0)
        values, on_paper = self.sampler.si(self.attempts), self.sampler.frame(self.attempts)
        found = sensitivity(self.form, values, on_paper, [quantity], self.motion)
        return np.asarray(passed & (found <= self.form.screens.sensitivity))

    def has_resting_rotation(self) -> bool:
        """Whether a link that nothing keeps from turning has no angular velocity on any draw."""
        held = Linkage(self.form.sample).translating
        turning = {body: rates for body, rates in self.motion.omega.items() if body not in held}
        least = _AT_REST * max(float(np.max(np.abs(rates))) for rates in turning.values())
        return any(np.all(np.abs(rates) < least) for rates in turning.values())

    def variant(self, place: int) -> Variant:
        """One of them."""
        return self.sampler.variant(self.attempts, place)

    def fit(self, screening: MakeScreening) -> int:
        """How many of the first of them can be worked out by hand, with a solution that leads to the answers."""
        values, on_paper = self.sampler.si(self.attempts), self.sampler.frame(self.attempts)
        screens = screening(self.form, values, on_paper, self.sampler.asked, self.motion)
        places = np.flatnonzero(np.all(list(screens.of_all().values()), axis=0))[:_BY_HAND].tolist()
        variants = [self.variant(place) for place in places]
        if not variants:
            return 0
        return int(np.count_nonzero(np.all(list(screens.of_survivors(variants, places).values()), axis=0)))


def _askings(draft: Draft, draws: _Draws, orders: Sequence[int], fewer_too: bool) -> Iterator[list[str]]:
    """What may be asked, one after the other: all that is good, and then less of it."""
    tried: list[list[str]] = []
    for order in orders:
        with suppress(LayoutError):
            full = _asked(draft, draws, order)
            velocities = [name for name in full if name.split("_")[0] in ("v", "omega")]
            fewer = max(_FEWEST, len(velocities) + 1 if order == 2 else 0)
            for asked in (full, full[:fewer]) if fewer_too else (full,):
                if asked not in tried:
                    tried.append(asked)
                    yield asked


def _asked(draft: Draft, draws: _Draws, order: int) -> list[str]:
    """What is asked: of the last dyad most, of every dyad something, as long as most draws are good for all of it."""
    *earlier, last = draft.asked
    wanted = [*last, *(name for names in earlier[::-1] for name in names[:2])]
    if order == 2 and (changes_speed(draft) or len(draft.asked) < 3):
        wanted += [_second(name) for name in last[:2]] + [_second(names[0]) for names in earlier]
    found: list[str] = []
    passed = np.ones(draws.motion.size, dtype=bool)
    for name in dict.fromkeys(wanted):
        good = passed & draws.good(name)
        if np.mean(good) >= _GOOD and len(found) < _MOST_ASKED[len(draft.asked)]:
            found.append(name)
            passed = good
    if not set(found) & set(last[:2]) or len(found) < _FEWEST:
        raise LayoutError("answers are trivial or touchy")
    return [name for order in ("v", "omega", "a", "epsilon") for name in found if name.split("_")[0] == order]


def _second(name: str) -> str:
    """The acceleration that goes with a velocity."""
    kind, _, rest = name.partition("_")
    return {"v": "a_", "omega": "epsilon_"}[kind] + rest
