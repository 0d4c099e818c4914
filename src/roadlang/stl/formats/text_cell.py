"""A cell of a trace that holds text where a number could be: formulas that read it are refused."""

from __future__ import annotations


class TextCell(str):
    """The text; `place` says where in its file it is, as in "in line 3"."""

    __slots__ = ("place",)
    place: str

    @classmethod
    def at(cls, text: str, place: str) -> TextCell:
        """A text and its place."""
        cell = cls(text)
        cell.place = place
        return cell
