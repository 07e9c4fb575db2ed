"""What a solution ends with: a relation that it has not used, with numbers, or a bound of magnitudes."""
