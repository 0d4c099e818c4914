"""Texts of tables: how they are encoded, and what a number in them looks like."""

from __future__ import annotations


def decoded(data: bytes) -> str:
    """Text in UTF-8, in UTF-16 with its mark, or in Latin-1. Raises UnicodeDecodeError."""
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return data.decode("utf-16")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        if b"\0" in data:
            raise
        return data.decode("latin-1")


def number_in(text: str) -> float:
    """The number in a cell of a table, as C and spreadsheets write it: also `nan`, `inf` and
    `-Infinity`. Raises ValueError, also for Python's `1_000` and for digits of other scripts."""
    if "_" in text or not text.isascii():
        raise ValueError(f"not a number: {text!r}")
    return float(text)
