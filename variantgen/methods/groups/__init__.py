"""The mechanism in textbook order: Assur groups, contacts and threads one after the other, each of which is solvable
once those before it are known. The law of each kind of contact is in ``laws``.
"""
