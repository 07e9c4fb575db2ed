"""How joints and drivers are described in words, one module per kind, of the same stem as the kind's own module.

A module has ``tell(alt_text, items)``, which gives the clauses for all joints (or drivers) of its kind in a scene. That
of a driver also has ``arrows(alt_text, driver)``, the arrows of its given rates. A kind without a module is described
by the phrase of its stem, filled with the names of its points and bodies.
"""
