"""The template engine for pages of HTML: what is missing is an error, what comes from outside is escaped."""

from __future__ import annotations

import jinja2

from variantgen.resources import templates_dir


def environment(folder: str) -> jinja2.Environment:
    """Templates of a folder of ``templates``."""
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(templates_dir() / folder),
        undefined=jinja2.StrictUndefined,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
