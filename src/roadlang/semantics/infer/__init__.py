"""The type of every expression, option and formula."""
