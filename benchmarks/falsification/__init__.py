"""How many distinct failures a search finds."""
