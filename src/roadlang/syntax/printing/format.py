"""`roadlang fmt`: a tree printed in the one canonical way, with all its comments."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence

from ...diagnostics import Diagnostic, Source
from ..parsing.parser import parse
from ..tree import nodes as ast
from .layout import WIDTH, Doc, render
from .nodes import Braced, Part, braces, part


def format_source(source: Source) -> tuple[str | None, list[Diagnostic]]:
    """The text of a scene file in canonical form; None, and why, where it cannot be read."""
    tree, found = parse(source)
    if any(diagnostic.is_error for diagnostic in found):
        return None, found
    return format_file(tree), found


def format_file(tree: ast.File) -> str:
    """The canonical text of a tree read without errors; formatting it again changes nothing."""
    printer = _Printer(tree)
    printer.sequence(tree.statements, 0, 0, len(tree.span.source.text) + 1)
    return "".join(f"{line}\n" for line in printer.lines)


class _Printer:
    """Writes lines; comments are written as their places are passed."""

    def __init__(self, tree: ast.File) -> None:
        self.lines: list[str] = []
        self.comments = tree.comments
        self.places = [comment.span.start for comment in tree.comments]
        self.next = 0
        self.text = tree.span.source.text

    def sequence(self, nodes: Sequence[ast.SyntaxNode], indent: int, start: int, end: int) -> None:
        """Nodes and comments between two offsets, blank lines kept, one at a time."""
        self._first, self._behind = True, start
        for node in nodes:
            self._comments(indent, node.span.start)
            self._blank(node.span.start)
            self._node(node, indent)
            self._first, self._behind = False, node.span.end
        self._comments(indent, end)

    def _blank(self, offset: int) -> None:
        if not self._first and self.text.count("\n", self._behind, offset) > 1:
            self.lines.append("")

    def _comments(self, indent: int, end: int) -> None:
        """The comments before `end`: on their own line, or after the last line written."""
        while self.next < len(self.comments) and self.places[self.next] < end:
            comment = self.comments[self.next]
            self.next += 1
            if comment.own_line or not self.lines:
                self._blank(comment.span.start)
                self.lines.append(" " * indent + comment.text)
            else:
                self.lines[-1] += " " * self._gap(comment) + comment.text
            self._first, self._behind = False, comment.span.end

    def _gap(self, comment: ast.Comment) -> int:
        """The spaces before a comment that follows the last line: its column, if that still means
        something. The line that ends a block has others above it than the author's line had."""
        written = self.lines[-1]
        if written.strip() == "}" or comment.span.column > WIDTH:
            return 2
        return max(2, comment.span.column - 1 - len(written))

    def _node(self, node: ast.SyntaxNode, indent: int) -> None:
        content = part(node)
        if not self._commented(node.span.start, node.span.end):
            flat = _flat(content) if _on_one_line(content.braced) else None
            if flat is not None and indent + len(flat) <= WIDTH:
                self._write(flat, indent)
                return
        elif not self._in_braces(node, content):
            # A comment inside an expression has its place only in the lines as they are.
            self._write(node.span.text, indent)
            self.next = bisect_left(self.places, node.span.end)
            return
        self._broken(content, indent)

    def _broken(self, content: Part, indent: int) -> None:
        """Head on a line (or several), each item of the braces on lines of its own."""
        if content.braced is None:
            self._write(render(content.head, column=indent, indent=indent), indent)
            return
        head: Doc = (content.head, " {")
        self._write(render(head, column=indent, indent=indent), indent)
        inner = content.braced.span
        self.sequence(_items(content.braced), indent + 2, inner.start, inner.end)
        self.lines.append(" " * indent + "}")

    def _write(self, text: str, indent: int) -> None:
        self.lines.extend((" " * indent + text).split("\n"))

    def _commented(self, start: int, end: int) -> bool:
        return bisect_left(self.places, start) < bisect_left(self.places, end)

    def _in_braces(self, node: ast.SyntaxNode, content: Part) -> bool:
        """Whether all comments of a node stand inside its braces."""
        return content.braced is not None and not self._commented(
            node.span.start, content.braced.span.start
        )


def _items(braced: Braced) -> Sequence[ast.SyntaxNode]:
    return braced.items if isinstance(braced, ast.Block) else braced.entries


def _on_one_line(braced: Braced | None) -> bool:
    return braced is None or "\n" not in braced.span.text


def _flat(content: Part) -> str | None:
    """A statement or item on one line, or None if something in it cannot be."""
    text = render(_flat_doc(content), width=10**9)
    return None if "\n" in text else text


def _flat_doc(content: Part) -> Doc:
    if content.braced is None:
        return content.head
    items = [part(item) for item in _items(content.braced)]
    closed = [item.braced is not None and isinstance(item.braced, ast.Block) for item in items]
    return (
        content.head,
        " ",
        braces([(_flat_doc(i), c) for i, c in zip(items, closed, strict=True)]),
    )
