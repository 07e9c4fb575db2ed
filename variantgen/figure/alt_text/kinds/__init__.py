"""How joints and drivers are told, one module per kind, of the same stem as the kind's own module.

A module has ``tell(teller, items)``, which gives the clauses for all joints (or drivers) of its kind in a scene. That
of a driver also has ``arrows(teller, driver)``, the arrows of its given rates. A kind without a module is told by the
phrase of its stem, filled with the names of its points and bodies.
"""
