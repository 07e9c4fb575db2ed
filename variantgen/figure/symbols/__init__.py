"""How joints and drivers look, one module per kind with the same stem as in :mod:`variantgen.mechanism`.

Each module has one function ``draw(board, item)``: it adds the symbol of ``item`` to the board. A module whose symbol
may choose its side says ``SEEKS_ROOM = True``; it is drawn after the symbols that have no choice.
"""
