"""What is wrong with a finished figure: its labels, points and bodies, its arrows."""
