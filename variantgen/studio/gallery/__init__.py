"""The gallery of families: a card and a figure for each form, made when asked for, or shipped with the package."""
