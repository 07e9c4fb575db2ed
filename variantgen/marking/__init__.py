"""From the answers that students hand in to marks.

``typed_number`` reads what somebody wrote as a number, ``answer_tables`` the tables that hold such texts; ``key`` has
what is right; ``causes`` tells how a wrong number may have come about; ``policy`` says what an answer is worth;
``marks`` puts them together for a class, and ``records`` writes them.
"""
