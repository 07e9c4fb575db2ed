"""The motion of one variant to 50 digits and more, from the joint residuals; nothing of the solver is used."""
