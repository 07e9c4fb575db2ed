"""A structure laid out at one instant, dyad by dyad; each is tried again alone, so that tries add up."""

from __future__ import annotations

from variantgen.synthesis.chance import Chance
from variantgen.synthesis.crowding import crowded, too_long
from variantgen.synthesis.draft import OPENINGS, Datum, Draft, LayoutError
from variantgen.synthesis.dyads import place_dyad
from variantgen.synthesis.structures import CRANK, FRAME, Structure

MOST_DATA = 10
_LETTERED, _MANY_GROUPS = 0.6, 3  # how often fixed points have letters as others; letters would not do for more
_TRIES, _TOO_MANY = 60, 12  # of one dyad on what is there; of these with too many data


def lay_out(structure: Structure, rng: Chance) -> Draft:
    """A mechanism of a structure at one instant. Raises LayoutError where the tries are used up."""
    uses = _uses(structure)
    draft = _crank(rng, "R" not in uses[CRANK])
    draft.lettered = len(structure) < _MANY_GROUPS and rng.random() < _LETTERED
    for place in range(len(structure)):
        draft = _next(draft, place, structure, uses)
    if problem := too_long(draft):
        raise LayoutError(problem)
    return draft


def _uses(structure: Structure) -> dict[int, str]:
    """The letters of the joints that dyads make on each link, with an M for each one from which a way leads on to
    another moving link: there, it matters where the joint is.
    """
    found = dict.fromkeys(range(2 + 2 * len(structure)), "")
    for place, (kind, on, to) in reversed([*enumerate(structure)]):
        leads_on = FRAME not in (on, to) or "M" in found[2 * place + 2] + found[2 * place + 3]
        found[on] += kind[0] + "M" * leads_on
        found[to] += kind[-1] + "M" * leads_on
    return found


def _crank(rng: Chance, only_slid_on: bool) -> Draft:
    """The driving link, at an angle to the horizontal that is away from the axes."""
    draft = Draft(rng, rng.choice(OPENINGS))
    draft.z["O"] = 0j
    draft.points["O"] = "coordinates", {"x": 0, "y": 0}
    draft.pivots.append("O")
    draft.joint("pivot", point="O")
    size = rng.choice((44, 50, 56, 60)) if only_slid_on else rng.choice((24, 28, 30, 32, 36, 40))
    angle = rng.choice((30, 40, 45, 50, 60, 120, 130, 135, 140, 150))
    draft.data["OA"] = Datum("cm", size, 2, 6)
    draft.data["phi"] = Datum("deg", abs(90 - angle) if draft.upright else angle, 5, 10)
    draft.data["omega_OA"] = Datum("rad/s", rng.choice((2, 2.5, 3, 3.5, 4)), 0.5, 1)
    draft.polar(
        "A", "O", "OA", angle, {"angle": f"90*deg {'-' if angle < 90 else '+'} phi" if draft.upright else "phi"}
    )
    draft.marks.append({"name": "phi", "at": "O", "from": "+y" if draft.upright else "+x", "to": "A"})
    draft.bar(CRANK, "driver", "O", "A", () if only_slid_on else ("A",))
    return draft


def _next(draft: Draft, place: int, structure: Structure, uses: dict[int, str]) -> Draft:
    """The draft with the next dyad."""
    problem, too_many = "", 0
    for _ in range(_TRIES):
        trial = draft.copy()
        try:
            place_dyad(trial, place, structure[place], uses)
        except LayoutError as error:
            problem = str(error)
            continue
        if len(trial.data) > MOST_DATA:
            problem, too_many = "too many data", too_many + 1
            if too_many > _TOO_MANY:  # it will hardly do with less
                break
            continue
        problem = crowded(trial)
        if not problem:
            return trial
    raise LayoutError(problem)
