"""The work of a fixed sample of the variants of a form, from which its band is found.

To draw a sample and to work out its solutions takes half a second, so those of the catalogue's forms are kept in
``work_samples.json``: for what a form asks by itself and for its velocities alone. A kept sample is used where all that
it depends on is as it was: the file of the family, the ranges, the examined quantities, the screens of the exam.
Everything else is sampled, once for a form in a process.

``python -m variantgen.exam.work.work_samples`` makes the file; a test recomputes some of it.
"""

from __future__ import annotations

import hashlib
import json
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

from variantgen.algebra.expression import Value
from variantgen.errors import InputError, VariantgenError
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.exam_file import read_exam
from variantgen.exam.work.kept_work import KEPT, SAMPLE, WorkSample, kept_samples
from variantgen.exam.work.wanted_work import level_of
from variantgen.families.asking import read_ask
from variantgen.families.family import Family, Form
from variantgen.families.quantities import Quantity
from variantgen.families.reading.files import FAMILY
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.mechanism.motion import Motion
from variantgen.methods.hand.work import Work, work_of
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.resources import catalog_dir
from variantgen.variants.attempts import FormSampler, VerificationError
from variantgen.variants.batch import RejectionCounts
from variantgen.variants.examined import examined
from variantgen.variants.seeding import Stream
from variantgen.variants.variant import Variant, solve_variants


def work_sample(family: Family, form: Form, asked: Sequence[Quantity], screening: AnswerTolerances) -> WorkSample:
    """The sample of a form for what its draws are examined on: the kept one, or a new one."""
    kept = kept_samples().get(_key(family, form, asked, screening))
    return kept or drawn_sample(family, form, asked, screening)


def usual_work(family: Family, form: Form) -> dict[str, Any] | None:
    """The calculations of a usual variant of a form for what it asks by itself, and its level, as plain data.

    None where there are no variants, and where no solution leads to what is asked.
    """
    try:
        found = work_sample(family, form, examined(form, read_ask(form)), AnswerTolerances()).median
    except VariantgenError:  # said where variants are drawn
        return None
    return {"calculations": found, "level": level_of(found)} if found else None


def drawn_sample(family: Family, form: Form, asked: Sequence[Quantity], screening: AnswerTolerances) -> WorkSample:
    """A sample that is drawn and worked out."""
    sampler = FormSampler(family, form, asked, RejectionCounts(), family.name, screening)
    try:
        attempts = sampler.many(Stream("work", family.name, form.name), SAMPLE, by_hand=True)
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
    found = variant_answers(variant, motion, place, asked)
    return None if found is None else work_of(found.values())


def variant_answers(variant: Variant, motion: Motion, place: int, asked: Sequence[Quantity]) -> dict[str, Value] | None:
    """The answers to which the natural solution of a variant leads, in the order of what is asked; None without one."""
    from variantgen.methods.natural_answers import natural_answers  # loaded when a solution is worked out

    try:
        return natural_answers(task_of(variant, motion, place, asked))
    except NOT_APPLICABLE:
        return None
    except VerificationError:  # that is said of a variant when it is handed out
        return None


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


def exam_forms() -> Iterator[tuple[Family, Form, list[Quantity]]]:
    """The forms of the exams of the catalogue with their ranges and questions."""
    for path in sorted((catalog_dir() / "exams").glob("*.toml")):
        for task in read_exam(path).tasks:
            for family in task.families:
                for form in family.forms.values():
                    yield family, form, examined(form, read_ask(form, task.ask))


def kept_forms() -> list[tuple[Family, Form, list[Quantity]]]:
    """All forms of which a sample is kept, each once: those of the catalogue, then those of its exams."""
    return list({_key(*form, AnswerTolerances()): form for form in (*catalogue_forms(), *exam_forms())}.values())


def kept_line(family: Family, form: Form, asked: Sequence[Quantity]) -> str:
    """A line of the file, with a new sample."""
    screening = AnswerTolerances()
    sample = drawn_sample(family, form, asked, screening)
    line = {
        "family": family.name,
        "form": form.name,
        "asked": ", ".join(quantity.name for quantity in asked),
        "key": _key(family, form, asked, screening),
        "of": sample.of,
        "works": [[count, *sizes] for sizes, count in sorted(sample.works.items())],
    }
    return json.dumps(line)


def main() -> None:
    """Write the file."""
    lines = [kept_line(*found) for found in kept_forms()]
    KEPT.write_text("[\n" + ",\n".join(lines) + "\n]\n", "utf-8")
    sys.stderr.write(f"{len(lines)} samples in {KEPT}\n")


if __name__ == "__main__":
    main()
