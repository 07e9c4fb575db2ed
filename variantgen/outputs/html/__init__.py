"""Statements, solutions and keys as HTML: fragments for learning platforms, articles and pages."""
