"""The pages of the studio, one module each: its name is that of its address, template, words, style and script.

A module has ``ROUTES``, addresses with the functions that answer them; ``studio_of(request)`` and
``document_of(request)`` give these the studio and the exam, and requests that do not fit raise InputError. A new page
is a module here, ``<name>.html.j2`` in ``assets/pages`` that extends ``frame.html.j2``, a table ``[<name>]`` in every
file of ``assets/words``, and ``<name>.css``, ``<name>.js`` in ``assets/static``; the head of all pages shows it as soon
as its template is there.
"""

from __future__ import annotations

from types import ModuleType

from variantgen.studio.pages import (
    archive,
    author,
    build,
    choose,
    compose,
    exams,
    mark,
    mark_changes,
    play,
    previews,
    roster,
)

PAGES: tuple[ModuleType, ...] = (
    exams,
    choose,
    compose,
    previews,
    roster,
    build,
    archive,
    mark,
    mark_changes,
    play,
    author,
)
