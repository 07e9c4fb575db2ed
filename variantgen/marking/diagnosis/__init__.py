"""What a wrong number says: how it may have come about, and whether it is right given earlier answers.

``causes`` tells which mistake gives it, with ``plausible_mistakes`` of kinematics and the sheets of ``neighbours``;
``follow_through`` goes the steps of the solution again from the student's earlier numbers, confirmed by
``consequences`` of them, which are ``derived`` by theorems as lists of ``candidates``.
"""
