"""`roadlang explain CODE`: the catalog page of a diagnostic; `explain FAILURE.json`: a failure."""

from __future__ import annotations

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
from .console import echo, style
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
@click.argument("code", required=False, shell_complete=_complete, metavar="[CODE|FAILURE.json]")
@click.option(
    "--file", "scene_file", metavar="FILE", help="Scene file of a failure, if it was moved."
)
def command(code: str | None, scene_file: str | None) -> None:
    """Explain a diagnostic, a statement of the language and its options, or a failure.

    CODE is a code or the name of a diagnostic (RL206, 206, wrong-type), or a statement (world,
    road). Without CODE, list all diagnostics. FAILURE.json is a scene that `roadlang falsify` wrote
    (failures/0001.json), or one of `roadlang run` that violates an expectation: which random values
    matter for that, one at a time and in pairs, and the moment at which it goes wrong.
    """
    if code is not None and code.endswith(".json"):
        from .explain_failure import explain_failure

        explain_failure(code, scene_file)
        return
    if code is None:
        for known in codes():
            echo(f"{style(known, bold=True)} {page(known).name}: {page(known).title}")
        return
    from ..semantics.statement_reference import BY_WORD

    if code in BY_WORD:
        echo("\n".join(statement_lines(BY_WORD[code])))
        return
    echo(_shown(_find(code)))


def _find(code: str) -> Page:
    folded = code.upper()
    if folded.isdigit():
        folded = f"RL{folded.zfill(3)}"
    try:
        return page(folded)
    except UnknownCode:
        named = {page(known).name: known for known in codes()}
        if code.lower() in named:
            return page(named[code.lower()])
        hints = did_you_mean(folded, codes()) or did_you_mean(code.lower(), named)
        raise DiagnosticError(
            diagnose(
                Code.UNKNOWN_CODE, wanted=code, help=(*hints, "`roadlang explain` lists all codes")
            )
        ) from None


def _shown(found: Page) -> str:
    title = style(f"{found.code} {found.name}: {found.title}", bold=True)
    return f"{title} ({found.severity})\n\n{found.body}"
