"""How joints and drivers look, one module per kind with the same stem as in :mod:`variantgen.mechanism`.

Each module has one function ``draw(board, item)``: it adds the symbol of ``item`` to the board.
"""
