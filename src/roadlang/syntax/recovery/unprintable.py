"""Sources that are no text of ours, and characters that no file in UTF-8 can hold."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...diagnostics import Code, Diagnostic, Source, diagnose

_CONTROL = re.compile(r"[\x00-\x08\x0e-\x1a\x7f\ufffd\ud800-\udfff]")
_SURROGATES = re.compile(r"[\ud800-\udfff]+")
_MARKUP = re.compile(r"\s*<(?=[?!A-Za-z])")
_FEW = 8
_HEAD = 2000
_OPENSCENARIO = (
    "this is OpenSCENARIO, which roadlang writes (`emit openscenario`) but does not read: read its "
    'map (`network town from "FILE.xodr"`) and write its entities as agents, its events as '
    "`drive with KIND { when: ... }`"
)


def binary(source: Source) -> Diagnostic | None:
    """A source with so many control characters that it is not text, such as an image."""
    first = _CONTROL.search(source.text)
    if first is None:
        return None
    many = len(_CONTROL.findall(source.text))
    if many < _FEW or many * 20 < len(source.text):
        return None
    return diagnose(Code.BINARY_FILE, source.span(first.start(), first.end()), path=source.path)


def markup(source: Source) -> Diagnostic | None:
    """A source in XML, such as a map of another tool."""
    first = _MARKUP.match(source.text)
    if first is None:
        return None
    if "<OpenSCENARIO" in source.text[:_HEAD]:
        help = _OPENSCENARIO
    else:
        name = source.path.replace("\\", "/").rpartition("/")[2]
        help = (
            f'this is XML: a scene file reads a map by `network town from "{name}"`, and '
            "`roadlang convert` writes it in another format"
        )
    return diagnose(
        Code.UNEXPECTED_TOKEN,
        source.span(first.end() - 1, first.end()),
        expected="a statement",
        found="`<`",
        help=help,
    )


def surrogates(source: Source, reported: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Bytes that are not UTF-8 inside strings and comments, where they damage no token."""
    reported_at = {found.span.start for found in reported if found.span is not None}
    return [
        diagnose(
            Code.UNEXPECTED_CHARACTER, source.span(*match.span()), what=f"U+{ord(match[0][0]):04X}"
        )
        for match in _SURROGATES.finditer(source.text)
        if match.start() not in reported_at
    ]
