"""Ways to write a solution: the solved motion as language-free steps of the textbook, with all their arithmetic.

The rooms stand on each other (the import contract has their order): ``algebra``, ``linkage``, ``steps``, ``geometry``,
``solution``, ``groups``, ``vectors``, ``centres``, ``by_groups``, then ``coordinates`` and ``graphical`` beside each
other. ``choice`` says which methods a problem uses, ``compose`` puts a solution together, ``hand`` asks what a careful
hand calculation makes of it.
"""
