"""How many variants of a class were handed out before: the exam of next year against the builds of this one."""

from __future__ import annotations

from collections.abc import Iterable

from variantgen.finished.restore import Finished
from variantgen.variants.variant import Variant


def overlap(variants: Iterable[Variant], builds: Iterable[Finished]) -> int:
    """The number of variants that a student of one of the builds had, by family, form and all printed data.

    The mirrored or turned figure of the same data is the same variant. Raises InputError where the variants of a build
    cannot be restored.
    """
    known = {variant.identity for build in builds for own in build.variants(build.record.sheets) for variant in own}
    return sum(variant.identity in known for variant in variants)
