"""Contacts without slip and threads: from the known side to a rate or a centre, also of a body with two of them."""
