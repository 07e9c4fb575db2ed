"""Packages in the formats of 1EdTech (IMS) QTI: items, tests, manifests, and the quizzes of Canvas."""
