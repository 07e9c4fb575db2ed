"""The self-check of families: schema, worked cases, draws, texts, figures."""

from variantgen.check.family import check_family
from variantgen.check.report import Report

__all__ = ["Report", "check_family"]
