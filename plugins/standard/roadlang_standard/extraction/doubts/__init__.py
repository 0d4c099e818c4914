"""How sure it is that the lines of a drawing are roads."""
