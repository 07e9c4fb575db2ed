"""How joints without a path of a point are used in a solution: one module per kind of joint, of the same stem.

A module defines ``touch(task, number)``: the contact or thread that the joint is, as a
:class:`variantgen.methods.groups.contact.NoSlipContact`, or None where its law does not apply. There is no list to
edit.
"""
