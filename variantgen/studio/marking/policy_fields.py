"""The rules of marks as the fields of the page Mark have them: percents and steps."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from msgspec.structs import replace

from variantgen.exam.sections.marking_policy import CAUSES, MarkingPolicy

RULES = ("sign", "power_of_ten", "unit", "rounding", "component", "mistake", "other_answer")  # shares that are shown


def policy_fields(policy: MarkingPolicy) -> dict[str, str]:
    """The rules as the fields of the page have them: percents, steps."""
    fields = {"tolerance": f"{policy.tolerance:f}", "follow_through": f"{(100 * policy.follow_through).normalize():f}"}
    fields |= {cause: f"{(100 * policy.shares.get(cause, Decimal(0))).normalize():f}" for cause in RULES}
    return {**fields, "problem_step": f"{policy.problem_step:f}", "total_step": f"{policy.total_step:f}"}


def with_fields(policy: MarkingPolicy, fields: Mapping[str, Decimal]) -> MarkingPolicy:
    """Rules with what the fields say; what they do not have stays."""
    shares = {**policy.shares, **{cause: fields[cause] / 100 for cause in RULES if cause in fields}}
    return replace(
        policy,
        tolerance=fields.get("tolerance", policy.tolerance),
        follow_through=fields.get("follow_through", 100 * policy.follow_through) / 100,
        shares={cause: shares[cause] for cause in CAUSES if shares.get(cause)},
        problem_step=fields.get("problem_step", policy.problem_step),
        total_step=fields.get("total_step", policy.total_step),
    )
