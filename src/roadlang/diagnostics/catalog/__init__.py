"""The catalog of messages: one Markdown page per code, beside this file."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal, cast

_FOLDER = Path(__file__).parent


@dataclass(frozen=True, slots=True)
class Page:
    """What one code means; `name` is what the code is called, `body` Markdown with examples."""

    code: str
    name: str
    title: str
    severity: Literal["error", "warning", "note"]
    message: str
    body: str


class UnknownCode(KeyError):
    """There is no catalog page of this code."""


@cache
def page(code: str) -> Page:
    """Read the page of `code`. Raises `UnknownCode`."""
    path = _FOLDER / f"{code}.md"
    if not path.is_file():
        raise UnknownCode(code)
    heading, severity, message, body = path.read_text(encoding="utf-8").split("\n", 3)
    name, _, title = heading.removeprefix(f"# {code} ").partition(":")
    return Page(
        code=code,
        name=name,
        title=title.strip(),
        severity=cast(
            Literal["error", "warning", "note"], severity.removeprefix("severity:").strip()
        ),
        message=message.removeprefix("message:").strip(),
        body=body.strip(),
    )


def codes() -> tuple[str, ...]:
    """All codes, in order."""
    return tuple(sorted(path.stem for path in _FOLDER.glob("RL*.md")))
