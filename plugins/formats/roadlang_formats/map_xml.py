"""Maps in XML: elements with their places, so that every error is reported at its place."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

from roadlang.api import (
    Code,
    Diagnostic,
    DiagnosticError,
    Source,
    Span,
    diagnose,
    read_input,
)

LARGEST = 200_000_000
"""Largest size of a map, in bytes."""
_MOST_ELEMENTS = 3_000_000
_DEEPEST = 60
_FARTHEST = 1e8
"""Largest absolute value of a number in a map, in any unit."""


@dataclass(slots=True)
class MapElement:
    """An XML element. `offset` is where its text begins in the file."""

    tag: str
    attributes: Mapping[str, str]
    offset: int
    children: list[MapElement] = field(default_factory=list)
    text: str = ""

    def all(self, *path: str) -> Iterator[MapElement]:
        """The elements at the end of a path of tags."""
        for child in self.children:
            if child.tag == path[0]:
                if len(path) == 1:
                    yield child
                else:
                    yield from child.all(*path[1:])

    def first(self, *path: str) -> MapElement | None:
        """The first of them, if there is one."""
        return next(self.all(*path), None)


@dataclass(frozen=True)
class MapFile:
    """A file that was parsed: its name, its text, and its outermost element."""

    path: Path
    text: str
    root: MapElement

    def fault(self, element: MapElement, reason: str, help: str = "") -> DiagnosticError:
        """RL479 at an element."""
        return fault_at(self.path, self.text, element.offset, reason, help)

    def left_out(self, element: MapElement, what: str, reason: str) -> Diagnostic:
        """RL481 at an element."""
        return left_out_at(self.path, self.text, element.offset, what, reason)

    def line(self, element: MapElement) -> int:
        """The line in which an element begins."""
        return self.text.count("\n", 0, element.offset) + 1

    def attribute(self, element: MapElement, name: str, default: str | None = None) -> str:
        """An attribute. Raises RL479 if it is missing and there is no `default`."""
        found = element.attributes.get(name, default)
        if found is None:
            raise self.fault(element, f"`{element.tag}` has no `{name}`")
        return found

    def number(self, element: MapElement, name: str, default: float | None = None) -> float:
        """An attribute as a finite number. Raises RL479."""
        written = element.attributes.get(name)
        if written is None and default is not None:
            return default
        try:
            found = float(self.attribute(element, name))
        except ValueError:
            found = math.nan
        if not abs(found) <= _FARTHEST:
            shown = self.attribute(element, name)[:40]
            raise self.fault(element, f"`{name}` of `{element.tag}` is not a number: `{shown}`")
        return found

    def integer(self, element: MapElement, name: str) -> int:
        """An attribute as a whole number. Raises RL479."""
        found = self.number(element, name)
        if found != int(found):
            reason = f"`{name}` of `{element.tag}` is not a whole number: {found:g}"
            raise self.fault(element, reason)
        return int(found)


def read_map_xml(path: Path, *roots: str, limit: int = LARGEST) -> MapFile:
    """The elements of a file whose outermost one is one of `roots`.

    Nothing outside the file is read. Raises RL400 and RL401 for a file that cannot be read, and
    RL479 for a file that is not valid XML, declares entities, or is nested too deeply.
    """
    content = read_input(path, limit)
    text = content.decode("utf-8-sig", errors="replace")
    builder = _Builder(path, text)
    found = builder.parsed(content)
    if found.tag not in roots:
        wanted = " or ".join(f"`{root}`" for root in roots)
        raise fault_at(path, text, found.offset, f"it begins with `{found.tag}`, not {wanted}")
    return MapFile(path, text, found)


def fault_at(path: Path, text: str, offset: int, reason: str, help: str = "") -> DiagnosticError:
    """RL479 at a place in a map: the rest of the tag there, or of its line."""
    span = _span_at(path, text, offset)
    diagnostic = diagnose(Code.DAMAGED_MAP, span, file=path.name, reason=reason, help=help or ())
    return DiagnosticError(diagnostic)


def left_out_at(path: Path, text: str, offset: int, what: str, reason: str) -> Diagnostic:
    """RL481, a warning at a place in a map."""
    span = _span_at(path, text, offset)
    return diagnose(Code.LEFT_OUT_OF_MAP, span, file=path.name, what=what, reason=reason)


def _span_at(path: Path, text: str, offset: int) -> Span:
    offset = max(0, min(offset, len(text)))
    line = text.find("\n", offset)
    stops = [stop for stop in (text.find(">", offset) + 1, line) if stop > offset]
    return Span(Source(path.name, text), offset, min(stops, default=len(text)))


class _Builder:
    """Makes elements of what expat finds."""

    def __init__(self, path: Path, text: str) -> None:
        self._path, self._text = path, text
        self._open: list[MapElement] = []
        self._root: MapElement | None = None
        self._count = 0
        self._starts = [0]
        at = text.find("\n")
        while at >= 0:
            self._starts.append(at + 1)
            at = text.find("\n", at + 1)
        self._parser = expat.ParserCreate()
        self._parser.buffer_text = True
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = self._characters
        # Maps do not need entities, and nested ones could expand without bounds.
        self._parser.EntityDeclHandler = self._entity

    def parsed(self, content: bytes) -> MapElement:
        try:
            self._parser.Parse(content, True)
        except expat.ExpatError as error:
            offset = self._offset(error.lineno, error.offset)
            reason = f"invalid XML: {expat.ErrorString(error.code)}"
            raise fault_at(self._path, self._text, offset, reason) from None
        except (LookupError, ValueError) as error:  # an encoding that Python does not know
            raise fault_at(self._path, self._text, 0, f"invalid XML: {error}") from None
        assert self._root is not None
        return self._root

    def _offset(self, line: int, column: int) -> int:
        start = self._starts[min(line, len(self._starts)) - 1]
        return min(start + column, len(self._text))

    def _here(self) -> int:
        return self._offset(self._parser.CurrentLineNumber, self._parser.CurrentColumnNumber)

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._count += 1
        element = MapElement(tag.rpartition(":")[2], attributes, self._here())
        if len(self._open) >= _DEEPEST or self._count > _MOST_ELEMENTS:
            deep = len(self._open) >= _DEEPEST
            reason = "its elements are nested too deeply" if deep else "it has too many elements"
            raise fault_at(self._path, self._text, element.offset, reason)
        if self._open:
            self._open[-1].children.append(element)
        else:
            self._root = element
        self._open.append(element)

    def _end(self, tag: str) -> None:
        self._open.pop()

    def _characters(self, text: str) -> None:
        if self._open and not text.isspace():
            self._open[-1].text += text

    def _entity(self, name: str, *rest: object) -> None:
        reason = f"it declares the entity `{name}`, which maps do not need"
        raise fault_at(self._path, self._text, self._here(), reason)
