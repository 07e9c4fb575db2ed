"""Builds from the studio: in a process of their own, finished ones with their files, single pages in advance."""
