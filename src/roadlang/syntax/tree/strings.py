"""What a string or a triple-quoted text stands for, and how a value is written as one."""

from __future__ import annotations

import re
import textwrap

ESCAPES = {'"': '"', "\\": "\\", "n": "\n", "t": "\t"}
ESCAPE = re.compile(r"\\(.)")


def unescaped(written: str) -> str:
    """The value of `"..."`. An unknown escape (the lexer has reported it) stays as written."""
    inner = written[1:-1]
    if "\\" not in inner:
        return inner
    return ESCAPE.sub(lambda match: ESCAPES.get(match[1], match[0]), inner)


def quoted(value: str) -> str:
    """A value as `"..."`."""
    signs = {meaning: f"\\{sign}" for sign, meaning in ESCAPES.items()}
    return '"' + "".join(signs.get(char, char) for char in value) + '"'


def dedented(written: str) -> str:
    r'''The value of `"""..."""`: lines without their common indentation, first and last line
    left out when blank.'''
    lines = written[3:-3].replace("\r\n", "\n").split("\n")
    if len(lines) > 1 and not lines[0].strip():
        lines = lines[1:]
    if len(lines) > 1 and not lines[-1].strip():
        lines = lines[:-1]
    return textwrap.dedent("\n".join(lines))
