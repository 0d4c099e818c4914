"""The catalog of messages: one Markdown page per code, next to this file."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal, cast

_FOLDER = Path(__file__).parent


@dataclass(frozen=True, slots=True)
class Page:
    """What one code means; `name` is what the code is called, `body` Markdown with examples.

    `exit` is the exit code of a command that ends with this error.
    """

    code: str
    name: str
    title: str
    severity: Literal["error", "warning", "note"]
    message: str
    body: str
    exit: int = 1


class UnknownCode(KeyError):
    """There is no catalog page of this code."""


@cache
def page(code: str) -> Page:
    """Read the page of `code`. Raises `UnknownCode`."""
    path = _FOLDER / f"{code}.md"
    if not os.path.isfile(path):
        raise UnknownCode(code)
    head, _, body = path.read_text(encoding="utf-8").partition("\n\n")
    heading, *lines = head.split("\n")
    name, _, title = heading.removeprefix(f"# {code} ").partition(":")
    fields = dict(line.split(": ", 1) for line in lines)
    return Page(
        code=code,
        name=name,
        title=title.strip(),
        severity=cast(Literal["error", "warning", "note"], fields["severity"]),
        message=fields["message"],
        body=body.strip(),
        exit=int(fields.get("exit", "1")),
    )


def codes() -> tuple[str, ...]:
    """All codes, in order."""
    return tuple(sorted(path.stem for path in _FOLDER.glob("RL*.md")))
