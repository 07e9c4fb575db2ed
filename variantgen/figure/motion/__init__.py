"""Figures of motion: the mechanism with vectors, centres and contacts, and plans of vectors."""
