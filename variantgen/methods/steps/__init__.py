"""What a solution is written in: sentences by key with their facts, derived values, vector equations, systems, tables;
and the number of digits with which its values are printed; what a method raises where it leads nowhere. Nothing here
knows a language.
"""
