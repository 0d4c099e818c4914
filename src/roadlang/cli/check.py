"""`roadlang check FILE...`: every fault of scene files, at its place."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import click

from ..diagnostics import Diagnostic, DiagnosticError, Source
from ..ir.scenario import Scenario
from ..session.params import parse_overrides
from ..session.scene_files import STANDARD_INPUT
from . import exit_codes
from .console import report

if TYPE_CHECKING:
    from ..session.loading import LoadedScenario

_MOST_ROUNDS = 20


@click.command("check")
@click.argument("files", nargs=-1, required=True, metavar="FILE...", type=click.Path())
@click.option(
    "--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set the value of a param."
)
@click.option("--json", "as_json", is_flag=True, help="Print the diagnostics as JSON.")
@click.option("--fix", is_flag=True, help="Apply all unambiguous fixes to the FILEs.")
@click.option("--scenario", is_flag=True, help="Print the checked scenario as JSON.")
def command(
    files: tuple[str, ...], settings: tuple[str, ...], as_json: bool, fix: bool, scenario: bool
) -> None:
    """Check the scene FILEs and report all errors. `-` reads standard input.

    Nothing is written unless --fix is given: then every fix with a single possible replacement is
    applied, the file is checked again, and the remaining errors are reported.

    A JSON diagnostic has code, severity, message, file, line, column, end_line, end_column
    (counted from 1; the end is exclusive), included_at, help and fixes.
    """
    overrides = parse_overrides(settings)
    found: list[Diagnostic] = []
    for name in files:
        checked, diagnostics = _check(name, overrides, fix)
        found += diagnostics
        if scenario and checked is not None:
            _print_scenario(checked)
    if as_json:
        from ..diagnostics.render import render_json

        click.echo(render_json(found))
    else:
        report(found)
    click.get_current_context().exit(exit_codes.exit_code_of(found))


def _check(
    name: str, overrides: dict[str, Source], fix: bool
) -> tuple[Scenario | None, list[Diagnostic]]:
    from ..session.loading import load

    try:
        loaded = load(name).with_params(overrides)
        if fix:
            loaded = _fixed(loaded, name)
        found = list(loaded.check())
    except DiagnosticError as error:
        return None, list(error.diagnostics)
    has_errors = any(diagnostic.is_error for diagnostic in found)
    return None if has_errors else loaded.scenario, found


def _fixed(loaded: LoadedScenario, name: str) -> LoadedScenario:
    """The scenario after all certain fixes, which are written into its file."""
    from ..diagnostics.fixing import apply_fixes
    from ..files.writing import write_file

    if name == STANDARD_INPUT:
        raise click.UsageError("--fix changes files and cannot be used with standard input")
    before, count = loaded.text, 0
    for _ in range(_MOST_ROUNDS):
        text, fixes = apply_fixes(Source(str(loaded.path), loaded.text), loaded.check())
        if not fixes:
            break
        loaded, count = loaded.with_text(text), count + fixes
    if loaded.text != before:
        write_file(loaded.path, loaded.text)
        click.echo(f"{name}: {count} {'fix' if count == 1 else 'fixes'}", err=True)
    return loaded


def _print_scenario(scenario: Scenario) -> None:
    from ..ir.scenario_json import scenario_to_json

    click.echo(json.dumps(scenario_to_json(scenario), indent=2))
