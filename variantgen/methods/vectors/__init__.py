"""Vector equations and the groups that are solved by them: points of a body, sliding pairs, floating links, contacts.
Equations are projected on axes across an unknown vector, or drawn where a solution is graphical.
"""
