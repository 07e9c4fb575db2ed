"""The command line."""

from variantgen.cli.app import main

__all__ = ["main"]
