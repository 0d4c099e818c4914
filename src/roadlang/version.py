"""The version of roadlang: git tags and the changelog follow it."""

__version__ = "0.2.0"
