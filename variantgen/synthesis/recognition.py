"""The structure of a mechanism that is there: which family of the catalogue has which."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joints.gears import Gears
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.joints.translation import Translation
from variantgen.mechanism.scene import Scene
from variantgen.synthesis.structures import (
    CRANK,
    FRAME,
    KINDS,
    ROLLING,
    SINGLE,
    AssurGroup,
    Structure,
    normal,
    single_groups,
)

_Pair = tuple[str, str, str]  # letter of the joint, two links
_FRAME = "(frame)"


def structures_of(scene: Scene) -> set[Structure]:
    """The structures as which a mechanism can be read: several where a pin joins more than two links.

    None where it is not driven by one crank, has other joints than hinges and straight slides, or other groups than
    dyads.
    """
    if any(not isinstance(joint, Pivot | Guide | Slot | Translation | Rolling | Gears) for joint in scene.joints):
        return set()
    driver = scene.drivers[0] if len(scene.drivers) == 1 else None
    if not isinstance(driver, Rotation) or driver.relative_to is not None:
        return set()
    pins, slides = _pins(scene), list[_Pair]()
    still = {joint.body for joint in scene.joints if isinstance(joint, Translation)}
    for place, joint in enumerate(scene.joints):
        if isinstance(joint, Guide):
            slides.append(("P", _slider(pins, joint.point, f"slider {place}", still), _FRAME))
        elif isinstance(joint, Rolling):
            slides.append(("W", joint.body, joint.on or _FRAME))
        elif isinstance(joint, Gears):
            slides.append(("W", joint.body, joint.other or _FRAME))
        elif isinstance(joint, Slot):
            alike = still - {joint.body} if joint.body in still else set[str]()
            block = joint.sleeve or _slider(pins, joint.point, f"block {place}", alike)
            slides.append(("P", block, joint.body))
    found = set()
    for hinges in product(*(_trees(links) for links in pins.values())):
        structure = _grown([pair for tree in hinges for pair in tree] + slides, driver.body)
        if structure is not None:
            found.add(normal(structure))
    return found


def _pins(scene: Scene) -> dict[str, list[str]]:
    """The links at each point."""
    fixed = {joint.point for joint in scene.joints if isinstance(joint, Pivot)}
    return {
        point: [body for body, points in scene.bodies.items() if point in points] + [_FRAME] * (point in fixed)
        for point in scene.points
    }


def _slider(pins: dict[str, list[str]], point: str, name: str, still: set[str]) -> str:
    """The link that slides at a point: a body there that does not turn, or a block on the pin."""
    own = [body for body in pins[point] if body in still]
    if own:
        return own[0]
    pins[point].append(name)
    return name


def _trees(links: Sequence[str]) -> list[list[_Pair]]:
    """The ways in which hinges between two links each make a pin of several: all trees (by their Pruefer codes)."""
    size = len(links)
    if size < 3:
        return [[("R", links[0], links[1])]] if size == 2 else [[]]
    found = []
    for sequence in product(range(size), repeat=size - 2):
        degrees = [1 + sequence.count(i) for i in range(size)]
        tree: list[_Pair] = []
        for inner in sequence:
            leaf = degrees.index(1)
            tree.append(("R", links[leaf], links[inner]))
            degrees[leaf] -= 1
            degrees[inner] -= 1
        one, other = (i for i in range(size) if degrees[i] == 1)
        found.append([*tree, ("R", links[one], links[other])])
    return found


def _grown(joints: Sequence[_Pair], crank: str) -> Structure | None:
    """The dyads in an order in which they can be grown from frame and crank, or None."""
    links = {link for _, one, other in joints for link in (one, other)}
    known = {_FRAME: FRAME, crank: CRANK}
    if not any(letter == "R" and {one, other} == {_FRAME, crank} for letter, one, other in joints):
        return None
    found: list[AssurGroup] = []
    while links - known.keys():
        step = next(_dyads(joints, known), None) or next(_singles(joints, known, tuple(found)), None)
        if step is None:
            return None
        dyad, first, second = step
        found.append(dyad)
        known |= {first: len(known), second: len(known) + 1}
    return tuple(found) if len(joints) == 1 + sum(len(group.kind) for group in found) else None


def _singles(joints: Sequence[_Pair], known: dict[str, int], grown: Structure) -> Iterator[tuple[AssurGroup, str, str]]:
    """Gears and racks that end what is grown; the second name stands for no link."""
    for new in sorted({link for _, *pair in joints for link in pair} - known.keys()):
        own = {letter: next(link for link in pair if link != new) for letter, *pair in joints if new in pair}
        for kind in SINGLE:
            if own.keys() == set(kind) and set(own.values()) <= known.keys():
                group = AssurGroup(kind, *(known[own[letter]] for letter in kind))
                if group in single_groups(grown):
                    yield group, new, f"({new})"


def _dyads(joints: Sequence[_Pair], known: dict[str, int]) -> Iterator[tuple[AssurGroup, str, str]]:
    """Dyads on what is known: two new links, joined with each other, each with one joint to a known link."""
    to_known: dict[str, list[tuple[str, int]]] = {}
    for letter, one, other in joints:
        for new, old in ((one, other), (other, one)):
            if new not in known and old in known:
                to_known.setdefault(new, []).append((letter, known[old]))
    for letter, one, other in joints:
        for first, second in ((one, other), (other, one)):
            ends = [to_known.get(link, []) for link in (first, second)]
            if first in known or second in known or any(len(end) != 1 for end in ends):
                continue
            kind = ends[0][0][0] + letter + ends[1][0][0]
            if kind in (*KINDS, ROLLING):
                yield AssurGroup(kind, ends[0][0][1], ends[1][0][1]), first, second
