"""Sheets, keys and solutions as data for templates: one content for all engines, which differ in how they write it.

:class:`~variantgen.outputs.documents.writing.Writing` says what an engine has to write; the rooms ``typst``, ``latex``
and ``html`` fulfil it.
"""
