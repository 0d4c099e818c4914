"""`roadlang run FILE`: scenes are driven, and every `expect` is judged on what happened."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..session.scene_files import parse_overrides
from . import exit_codes
from .console import echo, holding, report, style

if TYPE_CHECKING:
    from ..session.drives import Drive, DriveSet


@click.command("run")
@click.argument("file")
@click.option("--engine", help="Simulator, in place of the file's `simulate with`.")
@click.option("-o", "--output", "folder", default="out", show_default=True, metavar="DIR")
@click.option(
    "-n",
    "count",
    type=click.IntRange(min=1),
    help="Number of scenes; by default 1, or all of a grid.",
)
@click.option(
    "--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Random seed."
)
@click.option(
    "--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set the value of a param."
)
@click.option(
    "--duration", type=click.FloatRange(min=0.1), help="Maximum duration of a drive in seconds."
)
@click.option("--window", is_flag=True, help="Show the drive in a window, in real time.")
@click.option("--json", "as_json", is_flag=True, help="Print the verdicts as JSON.")
def command(  # noqa: PLR0913 - one parameter per option
    file: str,
    engine: str | None,
    folder: str,
    count: int | None,
    seed: int,
    settings: tuple[str, ...],
    duration: float | None,
    window: bool,
    as_json: bool,
) -> None:
    """Sample scenes of FILE, drive them, evaluate the expectations, and write traces to DIR.

    The exit code is 4 if an expectation is violated, and 5 if the simulator fails.
    """
    from ..session.loading import load

    target = Path(folder).absolute()
    scenes = load(file).with_params(parse_overrides(settings)).sample(count, seed=seed)
    report(scenes.diagnostics)
    options: dict[str, Any] = {}
    if duration is not None:
        options["duration"] = duration
    if window:
        options["headless"] = False
    drives = scenes.run(engine, **options)
    _write(target, drives)
    if as_json:
        click.echo(json.dumps([_record(drive) for drive in drives], indent=2))
    else:
        for drive in drives:
            _print(drive)
        echo(f"{_summary(drives)}traces and verdicts in {folder}")
    report(drives.diagnostics)
    code = exit_codes.DONE if drives.satisfied else exit_codes.EXPECTATION_VIOLATED
    code = exit_codes.exit_code_of(drives.diagnostics) or code
    click.get_current_context().exit(code)


def _write(folder: Path, drives: DriveSet) -> None:
    from ..files.writing import write_all

    files: dict[str, str] = {}
    for drive in drives:
        stem = f"scene-{drive.scene.index:04d}"
        files[f"{stem}.trace.csv"] = drive.to_csv()
        files[f"{stem}.trace.json"] = drive.to_json()
        files[f"{stem}.verdicts.json"] = json.dumps(_record(drive), indent=2) + "\n"
    write_all(folder, files)


def _record(drive: Drive) -> dict[str, Any]:
    return {
        "scene": drive.scene.index,
        "name": drive.scene.name,
        "expectations": [
            {"name": v.name, "text": v.text, "robustness": v.robustness, "satisfied": v.satisfied}
            for v in drive.verdicts.values()
        ],
    }


def _print(drive: Drive) -> None:
    took = f"{drive.duration:.1f} s" if len(drive.trace.time) else "no time"
    echo(f"scene {drive.scene.index}: {took} driven in {drive.engine}")
    for verdict in drive.verdicts.values():
        word = style("holds   ", fg="green") if verdict.satisfied else style("violated", fg="red")
        if verdict.satisfied is None:
            word = "not judged"
        rho = "" if verdict.robustness is None else f"  robustness {verdict.robustness:.3g}"
        echo(f"  {word}  {verdict.name}: {verdict.text}{rho}")


def _summary(drives: DriveSet) -> str:
    """In how many scenes all expectations hold; nothing where nothing is expected."""
    if not any(drive.verdicts for drive in drives):
        return ""
    return f"{holding(sum(drive.satisfied for drive in drives), len(drives))}; "
