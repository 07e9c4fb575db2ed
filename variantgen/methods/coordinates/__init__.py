"""The coordinate and the analytical method for the whole mechanism: equations of its joints and drivers, their time
derivatives, unknowns in blocks, answers. What each joint and driver says of coordinates is in ``equations``.
"""
