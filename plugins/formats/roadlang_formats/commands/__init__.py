"""Commands for people who have a map and no scene file."""
