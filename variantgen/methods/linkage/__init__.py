"""The problem that a solution answers, and the mechanism as a solution reads it: what is given and asked, which points
and bodies are needed for it, which rest or only translate, and the solved motion in printed units.
"""
