"""The error that all of geometry raises."""


class GeometryError(ValueError):
    """The numbers given describe no such shape; the message says why, in plain words."""
