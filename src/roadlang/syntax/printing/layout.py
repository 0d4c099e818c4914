"""A small pretty printer: documents that are written on one line if they fit, else broken."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

WIDTH = 100


@dataclass(frozen=True, slots=True)
class LineBreak:
    """A place where a line may break; `flat` stands there when it does not. A hard one must."""

    flat: str = " "
    hard: bool = False


@dataclass(frozen=True, slots=True)
class Nest:
    """Lines that begin inside are indented by this many more columns."""

    indent: int
    inner: Doc


@dataclass(frozen=True, slots=True)
class LayoutGroup:
    """Stays on one line if it fits there; else all its own breaks are taken."""

    inner: Doc


Doc: TypeAlias = str | LineBreak | Nest | LayoutGroup | tuple["Doc", ...]

LINE = LineBreak()
SOFT = LineBreak("")
HARD = LineBreak(hard=True)


def joined(separator: Doc, docs: Iterable[Doc]) -> Doc:
    """Documents with a separator between each two."""
    parts: list[Doc] = []
    for doc in docs:
        if parts:
            parts.append(separator)
        parts.append(doc)
    return tuple(parts)


def enclosed(opener: str, items: Sequence[Doc], closer: str) -> Doc:
    """`(a, b)`, or each item on a line of its own."""
    if not items:
        return opener + closer
    inner = joined((",", LINE), items)
    return LayoutGroup((opener, Nest(2, (SOFT, inner)), SOFT, closer))


def render(doc: Doc, *, column: int = 0, indent: int = 0, width: int = WIDTH) -> str:
    """The text of a document whose first line begins at `column`."""
    out: list[str] = []
    owed = 0
    stack: list[tuple[int, bool, Doc]] = [(indent, False, doc)]
    while stack:
        indent, flat, top = stack.pop()
        if isinstance(top, str):
            if top:
                out.append(" " * owed + top)
                owed = 0
            column += len(top)
        elif isinstance(top, LineBreak):
            if flat and not top.hard:
                out.append(top.flat)
                column += len(top.flat)
            else:
                out.append("\n")
                column = owed = indent
        elif isinstance(top, Nest):
            stack.append((indent + top.indent, flat, top.inner))
        elif isinstance(top, LayoutGroup):
            stack.append((indent, flat or _fits(top.inner, width - column, stack), top.inner))
        else:
            stack.extend((indent, flat, part) for part in reversed(top))
    return "".join(out)


def _fits(doc: Doc, room: int, behind: Sequence[tuple[int, bool, Doc]]) -> bool:
    """Whether a document and what follows it up to the next break fit into the room."""
    stack: list[tuple[bool, Doc]] = [(flat, rest) for _, flat, rest in behind]
    stack.append((True, doc))
    while stack and room >= 0:
        flat, top = stack.pop()
        if isinstance(top, str):
            room -= len(top)
        elif isinstance(top, LineBreak):
            if top.hard or not flat:
                return not (top.hard and flat)
            room -= len(top.flat)
        elif isinstance(top, tuple):
            stack.extend((flat, part) for part in reversed(top))
        else:
            stack.append((flat, top.inner))
    return room >= 0
