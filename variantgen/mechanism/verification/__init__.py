"""The independent computation: residuals of closure, theorems that hold for each motion, the second solution."""
