"""From the answers that students hand in to marks.

``typed_number`` reads what somebody wrote as a number, ``answer_tables`` the tables that hold such texts; ``key`` has
what is right, ``matching`` brings both together. ``causes`` tells how a wrong number may have come about, with
``plausible_mistakes`` and ``neighbours``; ``follow_through`` what is right given earlier answers, confirmed by
``consequences``. ``marks`` puts them together for a class, ``records`` and ``pages`` write them, with
``class_statistics``. What an answer is worth says :mod:`variantgen.exam.marking_policy`.
"""
