"""What a figure shows, told in words: the alternative text for those who do not see it.

:mod:`~variantgen.figure.alt_text.description` puts the text together: parts, hinges, joints, positions, marks, arrows.
A joint or driver is told by the module of its stem in :mod:`~variantgen.figure.alt_text.kinds` or, where there is none,
by the phrase of its stem in the table ``[figure]`` of ``templates/words/<language>.toml``, filled with its fields.
"""
