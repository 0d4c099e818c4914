"""Words of the language that had another name in earlier versions.

Scene files with an old word get the new one as a fix; JSON scenes of earlier schema versions are
read with them.
"""

from __future__ import annotations

from collections.abc import Container

OPTIONS = {"colour": "color"}
"""Options of kinds."""

OPERANDS = {"one": "first", "other": "second"}
"""Arguments of `distance` and `gap`."""

KINDS = {"cross_track": "cross_track_error"}
"""Kinds, and so the members and functions in formulas."""


def new_name(word: str, known: Container[str]) -> str | None:
    """The present name of a word, where it was renamed to one of `known`."""
    new = {**OPTIONS, **OPERANDS, **KINDS}.get(word)
    return new if new is not None and new in known else None
