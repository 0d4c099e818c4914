"""From tree to text: the formatter."""
