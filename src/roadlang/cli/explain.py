"""`roadlang explain`: the catalog page of a diagnostic, a statement, a kind, or a failure."""

from __future__ import annotations

import os
from pathlib import Path

import click
from click.shell_completion import CompletionItem

from ..diagnostics import (
    Code,
    DiagnosticError,
    Page,
    UnknownCode,
    codes,
    diagnose,
    did_you_mean,
    page,
)
from ..ir.result_files import FAILURES, SCENARIO, is_scene_file_name, numbered_scenes
from .commands import COMMANDS
from .console import echo, style
from .named_kinds import kinds_text, named_kinds, other_names
from .option_listing import statement_lines


def _complete(
    context: click.Context, parameter: click.Parameter, typed: str
) -> list[CompletionItem]:
    return [
        CompletionItem(code, help=page(code).title)
        for code in codes()
        if code.startswith(typed.upper())
    ]


@click.command("explain")
@click.argument(
    "words", nargs=-1, shell_complete=_complete, metavar="[CODE|STATEMENT|[VERB] KIND|FAILURE.json]"
)
@click.option(
    "--file", "scene_file", metavar="FILE", help="Scene file of a failure, if it was moved."
)
def command(words: tuple[str, ...], scene_file: str | None) -> None:
    """Explain a diagnostic, a statement, a kind or a failure.

    CODE is a code or the name of a diagnostic (RL206, 206, wrong-type); a STATEMENT is one of the
    language (world, road), a KIND one of a plugin (sine, emit svg). Without anything, list all
    diagnostics. FAILURE.json is a scene that `roadlang falsify` wrote (failures/0001.json), or one
    of `roadlang run` that violates an expectation; its explanation says when the drive goes wrong,
    and which random values matter, one at a time and in pairs.
    """
    wanted = " ".join(words)
    if is_scene_file_name(wanted) or Path(wanted).suffix.lower() == SCENARIO:
        from .explain_failure import explain_failure

        explain_failure(wanted, scene_file)
        return
    if not words:
        for known in codes():
            echo(f"{style(known, bold=True)} {page(known).name}: {page(known).title}")
        return
    from ..semantics.statement_reference import BY_WORD

    if wanted in BY_WORD:
        echo("\n".join(statement_lines(BY_WORD[wanted])))
        return
    echo(_shown(found) if (found := _page(wanted)) else _kinds(wanted))


def _page(wanted: str) -> Page | None:
    """Of a code or the name of a diagnostic, if it is one."""
    folded = wanted.upper()
    if folded.isdigit():
        folded = f"RL{folded.zfill(3)}"
    named = {page(known).name: known for known in codes()}
    try:
        return page(named.get(wanted.lower(), folded))
    except UnknownCode:
        return None


def _kinds(wanted: str) -> str:
    """Options of kinds. Raises `DiagnosticError` RL925 where there is nothing of this name."""
    from ..plugins.discovery import load_registry

    registry = load_registry()
    entries = named_kinds(registry, wanted.split())
    if entries:
        return kinds_text(entries)
    from ..semantics.statement_reference import BY_WORD

    names = {page(known).name for known in codes()} | {entry.name for entry in registry.entries}
    hints = did_you_mean(wanted.upper(), codes()) or other_names(registry, wanted.split())
    hints = hints or did_you_mean(wanted.lower(), names | set(BY_WORD))
    raise DiagnosticError(
        diagnose(Code.UNKNOWN_CODE, wanted=wanted, help=(*hints, *_where_else(wanted)))
    )


def _where_else(wanted: str) -> tuple[str, ...]:
    """What to write instead: of a folder its failures, otherwise the lists of names."""
    if wanted in COMMANDS:
        return (f"`roadlang {wanted} --help` explains the command",)
    folder = Path(wanted)
    if not os.path.isdir(folder):
        return ("`roadlang explain` lists all codes, `roadlang plugins` all kinds",)
    scenes = numbered_scenes(folder / FAILURES) or sorted(folder.glob("scene-*[0-9].json"))
    if not scenes:
        return ("`explain` takes a scene, not a folder: name one that violates an expectation",)
    shown = f"`roadlang explain {scenes[0].as_posix()}`"
    return (f"name a scene in it that violates an expectation, as in {shown}",)


def _shown(found: Page) -> str:
    title = style(f"{found.code} {found.name}: {found.title}", bold=True)
    return f"{title} ({found.severity})\n\n{found.body}"
