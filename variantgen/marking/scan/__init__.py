"""Pages for answers read from scans and photos.

``pictures`` opens the files, ``registration`` finds the code and the corner marks of a page, ``darkness`` measures its
bubbles, ``columns`` says what is filled in, ``numbers`` what number that is. ``collecting`` puts the pages of a class
together, ``confirming`` lets readings that the key agrees with confirm themselves, ``review`` writes what a person has
to look at. Where everything stands on the page says :mod:`variantgen.exam.answer_page`.
"""
