"""Source text and the places in it."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Source:
    """A text with a name; `path` is what the user wrote or a label such as `--set reach`.

    Where `text` is a part of a file, with blanks in the place of all else, `shown` is the file.
    `included_at`: the path in the `include` by which the text came in, if there is one.
    """

    path: str
    text: str = field(repr=False)
    shown: str = field(default="", repr=False)
    # Not compared: a fault in a file that is included twice is one fault.
    included_at: Span | None = field(default=None, repr=False, compare=False)
    _line_starts: tuple[int, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        starts = [0]
        starts.extend(i + 1 for i, char in enumerate(self.text) if char == "\n")
        object.__setattr__(self, "_line_starts", tuple(starts))

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column of a character offset, both counted from 1."""
        line = bisect_right(self._line_starts, offset)
        return line, offset - self._line_starts[line - 1] + 1

    def line(self, number: int) -> str:
        """The text of one line (counted from 1), without its line end."""
        text = self.shown or self.text
        start = self._line_starts[number - 1]
        end = text.find("\n", start)
        return text[start : len(text) if end < 0 else end].rstrip("\r")

    def part(self, start: int, end: int) -> Source:
        """The text from `start` up to and without `end`, at its place."""
        blank = "".join("\n" if char == "\n" else " " for char in self.text[:start])
        return Source(self.path, blank + self.text[start:end], self.text, self.included_at)

    @property
    def line_count(self) -> int:
        """Number of lines; the last may be empty."""
        return len(self._line_starts)

    def span(self, start: int, end: int) -> Span:
        """The characters from offset `start` up to and without `end`."""
        return Span(self, start, end)

    @property
    def end(self) -> Span:
        """The empty span after the last character that is not white space."""
        offset = len(self.text.rstrip())
        return Span(self, offset, offset)


@dataclass(frozen=True, slots=True)
class Span:
    """The characters `start` to `end` (exclusive) of a source."""

    source: Source = field(repr=False)
    start: int
    end: int

    @property
    def line(self) -> int:
        """Line of the first character, from 1."""
        return self.source.position(self.start)[0]

    @property
    def column(self) -> int:
        """Column of the first character, from 1."""
        return self.source.position(self.start)[1]

    @property
    def end_line(self) -> int:
        """Line of the position after the last character, from 1."""
        return self.source.position(self.end)[0]

    @property
    def end_column(self) -> int:
        """Column after the last character, on `end_line`."""
        return self.source.position(self.end)[1]

    @property
    def text(self) -> str:
        """The characters themselves."""
        return self.source.text[self.start : self.end]

    def to(self, other: Span) -> Span:
        """The span from the start of this one to the end of the other."""
        return Span(self.source, min(self.start, other.start), max(self.end, other.end))

    def __str__(self) -> str:
        return f"{self.source.path}:{self.line}:{self.column}"
