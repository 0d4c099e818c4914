"""`roadlang fmt FILE...`: scene files in the one layout, comments kept."""

from __future__ import annotations

import difflib
import re
import sys
from pathlib import Path

import click

from ..diagnostics import Diagnostic, DiagnosticError, Source
from ..files.writing import replace_file
from ..session.scene_files import STANDARD_INPUT, read_scene_file
from . import exit_codes
from .console import echo, report

_FIRST_LINE_OF_WINDOWS = re.compile(r"[^\r\n]*\r\n")


@click.command("fmt")
@click.argument("files", nargs=-1, required=True, metavar="FILE...", type=click.Path())
@click.option(
    "--check", "only_check", is_flag=True, help="Do not write; exit with 1 if a file would change."
)
@click.option("--diff", is_flag=True, help="Do not write; print the changes as a diff.")
def command(files: tuple[str, ...], only_check: bool, diff: bool) -> None:
    """Format the scene FILEs in place. `-` formats standard input to standard output.

    A file with syntax errors is left as it is and its errors are reported. Line ends stay as they
    are.
    """
    found: list[Diagnostic] = []
    changed = 0
    for name in files:
        try:
            text = read_scene_file(name)
            formatted = _formatted(name, text)
        except DiagnosticError as error:
            found += error.diagnostics
            continue
        changed += formatted != text
        if diff:
            _print_diff(name, text, formatted)
        elif name == STANDARD_INPUT and not only_check:
            sys.stdout.write(formatted)
        elif formatted != text and only_check:
            echo(f"{name} would change")
        elif formatted != text:
            replace_file(Path(name), formatted)
    report(found)
    would_change = bool(changed and (only_check or diff))
    code = exit_codes.exit_code_of(found) or int(would_change)
    click.get_current_context().exit(code)


def _formatted(name: str, text: str) -> str:
    from ..syntax import format_source

    formatted, found = format_source(Source(name, text))
    if formatted is None:
        raise DiagnosticError(*found)
    # Where git checks files out with the line ends of Windows, they are not to be changed.
    return formatted.replace("\n", "\r\n") if _FIRST_LINE_OF_WINDOWS.match(text) else formatted


def _print_diff(name: str, before: str, after: str) -> None:
    lines = difflib.unified_diff(
        before.splitlines(keepends=True), after.splitlines(keepends=True), name, name
    )
    # On a terminal the diff is looked at; elsewhere it must apply to the file as it is.
    write = echo if sys.stdout.isatty() else sys.stdout.write
    write("".join(lines))
