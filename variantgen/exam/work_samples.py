"""The work of a fixed sample of the variants of a form, from which its band is found.

To draw a sample and to work out its solutions takes half a second, so those of the catalogue's forms are kept in
``work_samples.json``: for what a form asks by itself and for its velocities alone. A kept sample is used where all that
it depends on is as it was: the file of the family, the ranges, the examined quantities, the screens of the exam.
Everything else is sampled, once for a form in a process.

``python -m variantgen.exam.work_samples`` makes the file; a test recomputes some of it.
"""

from __future__ import annotations

import hashlib
import json
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from variantgen.errors import InputError
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.families.asking import read_ask
from variantgen.families.family import Family, Form
from variantgen.families.files import FAMILY
from variantgen.families.load import family_names, load_family
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.methods.hand.work import Work, work_of
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.variants.attempts import FormSampler, VerificationError
from variantgen.variants.batch import RejectionCounts
from variantgen.variants.examined import examined
from variantgen.variants.seeding import Stream
from variantgen.variants.variant import Variant, solve_variants

KEPT = Path(__file__).with_name("work_samples.json")
_SAMPLE = 48  # variants of a form

Sizes = tuple[int, int, int]  # calculations, negative numbers, obtuse angles


@dataclass(frozen=True)
class WorkSample:
    """How many variants of a sample take so much work, and the number of draws ``of`` which they are the valid ones.

    ``works`` is empty where a form has no valid variant, and where no method leads to what is asked.
    """

    works: Counter[Sizes]
    of: int

    @property
    def valid(self) -> float:
        """The part of the draws that is valid."""
        return _SAMPLE / self.of if self.of else 0.0


def work_sample(family: Family, form: Form, asked: Sequence[Quantity], screening: AnswerTolerances) -> WorkSample:
    """The sample of a form for what its draws are examined on: the kept one, or a new one."""
    kept = _kept().get(_key(family, form, asked, screening))
    return kept or drawn_sample(family, form, asked, screening)


def is_kept(family: Family, form: Form, asked: Sequence[Quantity]) -> bool:
    """Whether the sample of a form needs no drawing."""
    return _key(family, form, asked, AnswerTolerances()) in _kept()


def drawn_sample(family: Family, form: Form, asked: Sequence[Quantity], screening: AnswerTolerances) -> WorkSample:
    """A sample that is drawn and worked out."""
    sampler = FormSampler(family, form, asked, RejectionCounts(), family.name, screening)
    try:
        attempts = sampler.many(Stream("work", family.name, form.name), _SAMPLE, by_hand=True)
    except InputError:  # the draw of the students' variants says it, with their keys
        return WorkSample(Counter(), 0)
    variants = [sampler.variant(attempts, place) for place in range(attempts.number.size)]
    motion = solve_variants(variants, sampler.order)
    works = (variant_work(variant, motion, i, asked) for i, variant in enumerate(variants))
    return WorkSample(Counter(work.sizes for work in works if work is not None), int(attempts.number[-1]))


def variant_work(variant: Variant, motion: Motion, place: int, asked: Sequence[Quantity]) -> Work | None:
    """The work of a variant by its natural solution; ``place`` is its index in the batch ``motion``.

    None where no method leads to what is asked.
    """
    from variantgen.methods.compose import natural_answers  # loaded when a solution is worked out

    try:
        return work_of(natural_answers(task_of(variant, motion, place, asked)).values())
    except NOT_APPLICABLE:
        return None
    except VerificationError:  # that is said of a variant when it is handed out
        return None


@cache
def _kept() -> dict[str, WorkSample]:
    """The kept samples by their keys."""
    return {
        item["key"]: WorkSample(
            Counter({(size, negatives, obtuse): n for n, size, negatives, obtuse in item["works"]}), item["of"]
        )
        for item in json.loads(KEPT.read_text("utf-8"))
    }


def _key(family: Family, form: Form, asked: Sequence[Quantity], screening: AnswerTolerances) -> str:
    """A hash of what a sample depends on; nothing for a scene without a folder."""
    if family.folder is None:
        return ""
    try:
        text = (family.folder / FAMILY).read_bytes()
    except OSError:
        return ""
    grids = [(name, parameter.printed) for name, parameter in form.parameters.items()]
    names = [quantity.name for quantity in asked]
    parts = (family.name, form.name, family.length_unit, grids, form.ties, form.friendly, names)
    return hashlib.sha256(text + repr((*parts, screening.tolerance.mistakes)).encode()).hexdigest()[:16]


def catalogue_forms() -> Iterator[tuple[Family, Form, list[Quantity]]]:
    """The forms of the catalogue, each with what it asks by itself and again with its velocities, if it asks more."""
    for name in family_names():
        family = load_family(name)
        for form in family.forms.values():
            own = read_ask(form)
            velocities = [quantity for quantity in own if quantity.order == 1]
            for asked in [own, velocities] if velocities and velocities != own else [own]:
                yield family, form, examined(form, asked)


def kept_line(family: Family, form: Form, asked: Sequence[Quantity]) -> str:
    """A line of the file, with a new sample."""
    screening = AnswerTolerances()
    sample = drawn_sample(family, form, asked, screening)
    described = f"{family.name} {form.name}".strip() + ": " + ", ".join(quantity.name for quantity in asked)
    works = [[count, *sizes] for sizes, count in sorted(sample.works.items())]
    return json.dumps({"form": described, "key": _key(family, form, asked, screening), "of": sample.of, "works": works})


def main() -> None:
    """Write the file."""
    lines = [kept_line(*found) for found in catalogue_forms()]
    KEPT.write_text("[\n" + ",\n".join(lines) + "\n]\n", "utf-8")
    sys.stderr.write(f"{len(lines)} samples in {KEPT}\n")


if __name__ == "__main__":
    main()
