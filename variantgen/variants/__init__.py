"""From a seed to screened, distinct variants of a family."""
