"""Ways to write a solution: the solved motion as language-free steps of the textbook, with all their arithmetic.

The rooms stand on each other (the import contract has their order): ``algebra``, ``linkage``, ``steps``, ``geometry``,
``solution``, ``groups``, ``vectors``, ``centres``, ``by_groups``, then ``coordinates`` and ``graphical`` beside each
other. ``choice`` says which methods a problem uses, ``compose`` puts a solution together, ``hand`` asks what a careful
hand calculation makes of it.

Formulas name their source: "guide" is the course text «Методические указания и примеры решения задач по кинематике»,
part 3 (sections 3.1.1 to 3.2.3, formulas 54 to 72); Kirsanov is cited by section 2.5 (formulas 2.9, 2.10, 2.23 to
2.28).
"""
