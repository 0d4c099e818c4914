"""The syntax tree and how it is walked."""
