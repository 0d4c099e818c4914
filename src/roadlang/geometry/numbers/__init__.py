"""Arrays of numbers: rows in blocks, equations, derivatives, compiled loops."""
