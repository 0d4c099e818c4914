"""roadlang: a plugin-based compiler for driving scenarios."""

__version__ = "0.2.0"
