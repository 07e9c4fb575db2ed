"""Exam files as the studio changes them: operations on keys, applied to the lines of the text, with a journal for undo.

``toml_lines`` finds the lines of keys, ``edits`` applies operations, ``journal`` remembers every state, ``document``
puts them together for one file.
"""
