"""`roadlang init FILE`: a starter scene that compiles."""

from __future__ import annotations

import os
import shlex
from importlib.resources import files
from pathlib import Path

import click

from ..diagnostics import Code, DiagnosticError, diagnose
from ..files.writing import replace_file
from .console import echo

TEMPLATES = {
    "bend": "a drawn road, perturbed at random, and a car",
    "picture": "a road extracted from your image",
    "sweep": "a parameter sweep",
    "town": "a town written as text, with trees and buildings",
}


@click.command("init")
@click.argument("file", default="scene.rl", metavar="[FILE]")
@click.option(
    "--template",
    type=click.Choice(sorted(TEMPLATES)),
    default="bend",
    show_default=True,
    help="; ".join(f"{name}: {text}" for name, text in TEMPLATES.items()) + ".",
)
def command(file: str, template: str) -> None:
    """Write a starter scene to FILE (scene.rl)."""
    path = Path(file)
    line = shlex.join(["roadlang", "compile", file, "-o", "out"])
    text = (files(__package__) / "templates" / f"{template}.rl").read_text(encoding="utf-8")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch(exist_ok=False)
    except (OSError, ValueError) as error:
        if os.path.lexists(path):
            help = "choose another name: `roadlang init other.rl`"
            raise DiagnosticError(diagnose(Code.FILE_EXISTS, path=file, help=help)) from None
        reason = getattr(error, "strerror", None) or str(error)
        raise DiagnosticError(
            diagnose(Code.UNWRITABLE_OUTPUT, path=file, reason=reason.lower())
        ) from None
    try:
        replace_file(path, text.replace("roadlang compile THIS_FILE -o out", line))
    except BaseException:  # a full disk: nothing is left that a second try would stumble over
        path.unlink(missing_ok=True)
        raise
    echo(f"wrote {file}; now: {line} -n 4")
