"""The alternative text of a figure: what it shows in words, for those who do not see it.

:mod:`~variantgen.figure.alt_text.description` puts the text together: parts, hinges, joints, positions, marks, arrows.
A joint or driver is described by the module of its stem in :mod:`~variantgen.figure.alt_text.kinds` or, where there is
none, by the phrase of its stem in the table ``[figure]`` of ``templates/words/<language>.toml``, filled with its
fields.
"""
