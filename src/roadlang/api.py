"""All that a plugin author imports."""

__all__ = [name for name in dir() if not name.startswith("_")]
