"""`roadlang compile FILE`: scenes of a scene file, written whole or not at all."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..diagnostics import DiagnosticError, Source
from ..session.outputs import parse_outputs
from ..session.params import parse_overrides
from . import exit_codes, shared_options
from .console import report

if TYPE_CHECKING:
    from .compilation import Compilation


@click.command("compile")
@click.argument("file", type=click.Path())
@shared_options.output("out")
@shared_options.count
@shared_options.seed
@shared_options.jobs
@shared_options.cluster
@shared_options.settings
@shared_options.params
@shared_options.emit
@click.option(
    "--print-after",
    metavar="PASS",
    help="Print the result of a pass in each scene to stderr: `sine`, `bent/perturb 1` or `all`.",
)
@click.option(
    "--json", "as_json", is_flag=True, help="Print the manifest and the diagnostics as JSON."
)
def command(  # noqa: PLR0913 - one parameter per option
    file: str,
    folder: str,
    count: int | None,
    seed: int,
    jobs: int,
    cluster: str | None,
    settings: tuple[str, ...],
    params: str | None,
    emit: str | None,
    print_after: str | None,
    as_json: bool,
) -> None:
    """Check FILE, sample scenes that satisfy its requirements, and write them to DIR.

    DIR gets scene-0000.json, scene-0000.svg, ... as the `emit`s of FILE say (JSON and SVG if there
    are none), and manifest.json with the digests of all of them. The same file, inputs and seed
    give the same bytes. If --params has a list of maps, each is a run with a folder of its own,
    DIR/run-000, ..., and DIR/runs.csv lists the runs. The exit code is 4 if a road violates an
    `expect`; expectations of drives are evaluated by `roadlang run`.
    """
    from ..session.cluster import cluster as workers_of

    target = Path(folder).absolute()  # before a plugin can change the current folder
    try:
        runs, is_list = _runs(file, parse_overrides(settings), params, emit, target)
        checked = [run.check() for run in runs]
        if all(checked):
            with workers_of(cluster, jobs) as workers:
                for run in runs:
                    run.compile(count, seed, workers, print_after)
            if is_list:
                _write_table(runs, target)
    except DiagnosticError as error:
        _refuse(error, as_json)
        return
    if as_json:
        records = [run.record() for run in runs]
        click.echo(json.dumps(records if is_list else records[0], indent=2))
    elif not all(checked):
        report(found for run in runs for found in run.found)
    else:
        for run in runs:
            run.report()
    click.get_current_context().exit(exit_codes.severest(run.exit_code for run in runs))


def _runs(
    file: str, overrides: dict[str, Source], params: str | None, emit: str | None, target: Path
) -> tuple[list[Compilation], bool]:
    """What is to be compiled, and whether each set has a separate folder."""
    from ..session.loading import load
    from ..session.result_folders import refuse_results_of_others
    from ..session.runs import run_folders, variants
    from .compilation import Compilation

    variant, is_list = variants(load(file), params)
    refuse_results_of_others(target, "compile", is_list)
    outputs = None if emit is None else parse_outputs(emit)
    loaded = [each.with_params(overrides) for each in variant]
    if outputs is not None:
        loaded = [each.with_outputs(outputs) for each in loaded]
    folders = run_folders(target, len(loaded)) if is_list else [target]
    return [Compilation(*pair) for pair in zip(loaded, folders, strict=True)], is_list


def _write_table(runs: Sequence[Compilation], target: Path) -> None:
    from ..session.runs import write_runs

    write_runs(target, [run.row() for run in runs])


def _refuse(error: DiagnosticError, as_json: bool) -> None:
    """Report what keeps everything from beginning, or the table from being written."""
    if as_json:
        from ..diagnostics.render import to_record

        found = [to_record(diagnostic) for diagnostic in error.diagnostics]
        lists: dict[str, list[object]] = {"requirements": [], "expectations": [], "remarks": []}
        click.echo(json.dumps({"manifest": None, "diagnostics": found, **lists}, indent=2))
    else:
        report(error.diagnostics)
    click.get_current_context().exit(exit_codes.exit_code_of(error.diagnostics))
