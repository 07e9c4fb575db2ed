"""From the answers that students hand in to marks.

``typed_number`` reads what somebody wrote as a number, ``answer_tables`` the tables that hold such texts, ``scan`` what
is on paper; ``key`` has what is right, ``matching`` brings both together. What a wrong number says, its likely cause or
that it follows from earlier answers, is found in ``diagnosis``. ``marks`` puts all together for a class, ``records``
and ``pages`` write it, with ``class_statistics``. What an answer is worth says
:mod:`variantgen.exam.sections.marking_policy`.
"""
