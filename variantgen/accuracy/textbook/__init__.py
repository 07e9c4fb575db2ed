"""Mechanisms whose closed form stands in textbooks, as scenes and as formulas in real coordinates."""
