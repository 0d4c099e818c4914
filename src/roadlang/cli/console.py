"""Where a command's words go: results to stdout, diagnostics to stderr, color on terminals."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, TextIO

import click

from ..plugins.redirection import standard_output

if TYPE_CHECKING:
    from pathlib import Path

    from ..diagnostics import Diagnostic
    from ..session.expectations import Expectation

_COLOR_SEQUENCE = re.compile(r"(\x1b\[[0-9;]*m)")


def wants_color(stream: TextIO) -> bool:
    """`--color` decides; then NO_COLOR and FORCE_COLOR; then whether a person is watching."""
    choice = _color_option()
    if choice != "auto":
        return choice == "always"
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return stream.isatty() and os.environ.get("TERM") != "dumb"


def _color_option() -> str:
    context = click.get_current_context(silent=True)
    return str(context.find_root().meta.get("roadlang.color", "auto")) if context else "auto"


def report(diagnostics: Iterable[Diagnostic]) -> None:
    """Print diagnostics to stderr, sorted by place, with a count of errors and warnings."""
    from ..diagnostics.diagnostic import in_order
    from ..diagnostics.render import render_all

    ordered = in_order(diagnostics)
    if not ordered:
        return
    click.echo(render_all(ordered, color=wants_color(sys.stderr)), err=True, color=True)
    errors = sum(diagnostic.is_error for diagnostic in ordered)
    warnings = sum(diagnostic.severity == "warning" for diagnostic in ordered)
    counts = [_count(errors, "error"), _count(warnings, "warning")]
    summary = " and ".join(count for count in counts if count)
    if len(ordered) > 1 and summary:
        click.echo(f"\n{summary}", err=True)
    codes = sorted({diagnostic.code for diagnostic in ordered if diagnostic.is_error})
    if codes and sys.stderr.isatty():
        click.echo(f"`roadlang explain {codes[0]}` explains it", err=True)


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}" if number else ""


def echo(text: str) -> None:
    """A result, to stdout, without control characters."""
    output = standard_output()
    click.echo(_safe(text), file=output, color=wants_color(output))


def note(text: str) -> None:
    """A remark, to stderr, without control characters."""
    click.echo(_safe(text), err=True, color=wants_color(sys.stderr))


def _safe(text: str) -> str:
    """Lines as they may be shown: of control characters only colors and line breaks stay."""
    from ..diagnostics.printable import printable

    parts = _COLOR_SEQUENCE.split(text)
    return "".join(
        part if index % 2 else printable(part, keep="\n\t") for index, part in enumerate(parts)
    )


def style(text: str, *, fg: str | None = None, bold: bool | None = None) -> str:
    """`text` in a color or bold, as `click.style` has them, where stdout shows colors."""
    return click.style(text, fg=fg, bold=bold) if wants_color(standard_output()) else text


def violations(expectations: Iterable[Expectation]) -> Iterator[str]:
    """A line for each expectation that a scene violates."""
    for found in expectations:
        if found.violated:
            shown = ", ".join(map(str, found.violated[:8]))
            more = ", ..." if len(found.violated) > 8 else ""
            worst = "" if found.worst is None else f"; least robustness {found.worst:.3g}"
            scenes = f"{len(found.violated)} of {len(found.judged)} scenes ({shown}{more})"
            word = style("violated", fg="red")
            yield f"  {word}  {found.name}: {found.text}, in {scenes}{worst}"


def holding(satisfied: int, scenes: int) -> str:
    """In how many scenes all expectations hold."""
    return f"all expectations hold in {satisfied:,} of {counted(scenes, 'scene')}"


def counted(number: int, noun: str) -> str:
    """`1 scene`, `2,000 scenes`."""
    return f"{number:,} {noun}{'' if number == 1 else 's'}"


def shown(path: Path) -> str:
    """A path as people write it: relative if it is below the folder that the command began in."""
    from pathlib import Path

    context = click.get_current_context(silent=True)
    folder = Path(context.meta.get("roadlang.folder", "/") if context else "/")
    below = len(folder.parts) > 1 and path.is_relative_to(folder)
    return str(path.relative_to(folder) if below else path)
