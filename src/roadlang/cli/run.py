"""`roadlang run FILE`: scenes are driven, and every `expect` is judged on what happened."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..session.params import parse_overrides
from . import exit_codes
from .console import echo, holding, report, shown, style

if TYPE_CHECKING:
    from ..session.drives import Drive, DriveSet
    from ..session.loading import LoadedScenario


@click.command("run")
@click.argument("file")
@click.option("--engine", help="Simulator, in place of the file's `simulate with`.")
@click.option(
    "-o",
    "--output",
    "folder",
    default="out",
    show_default=True,
    metavar="DIR",
    help="Output folder.",
)
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
    "--params",
    metavar="FILE.yaml",
    help="YAML file with values of params; a list of maps gives several runs.",
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
    params: str | None,
    duration: float | None,
    window: bool,
    as_json: bool,
) -> None:
    """Sample scenes of FILE, drive them, evaluate the expectations, and write traces to DIR.

    DIR/results.csv has one row per scene: its params and draws, and the robustness of each
    expectation. If --params has a list of maps, each is a run with a folder of its own,
    DIR/run-000, ... The exit code is 4 if an expectation is violated, and 5 if the simulator fails.
    """
    from ..session.loading import load
    from ..session.runs import variants

    target = Path(folder).absolute()  # before a plugin can change the current folder
    each, is_list = variants(load(file), params)
    options: dict[str, Any] = {} if duration is None else {"duration": duration}
    if window:
        options["headless"] = False
    batch = Batch(target, is_list, as_json)
    overrides = parse_overrides(settings)
    for loaded in [variant.with_params(overrides) for variant in each]:
        batch.add(loaded, count, seed, engine, options)
    batch.write_table()
    if as_json:
        click.echo(json.dumps(batch.records, indent=2))
    else:
        echo(f"{batch.summary()}traces and verdicts in {shown(target)}")
    click.get_current_context().exit(exit_codes.severest(batch.codes))


class Batch:
    """The drives of one or several runs."""

    def __init__(self, target: Path, is_list: bool, as_json: bool) -> None:
        self._as_json = as_json
        self._target = target
        self._is_list = is_list
        self._rows: list[dict[str, Any]] = []
        self._satisfied: list[bool] = []
        self._expects = False
        self.records: list[dict[str, Any]] = []
        self.codes: list[int] = []

    def add(
        self,
        loaded: LoadedScenario,
        count: int | None,
        seed: int,
        engine: str | None,
        options: dict[str, Any],
    ) -> None:
        """Sample, drive, judge and write one run; that there is no scene ends only this run."""
        from ..session.scene_set import NoSceneError

        number = len(self.codes)
        run = {"run": f"run-{number:03d}"} if self._is_list else {}
        try:
            scenes = loaded.sample(count, seed=seed)
        except NoSceneError as error:
            if not self._is_list:
                raise
            report(error.diagnostics)
            self.codes.append(exit_codes.exit_code_of(error.diagnostics))
            return
        report(scenes.diagnostics)
        drives = scenes.run(engine, **options)
        _write(self._target / run["run"] if run else self._target, drives)
        self._rows += [{**run, **row} for row in drives.rows()]
        self._satisfied += [drive.satisfied for drive in drives]
        self._expects |= any(drive.verdicts for drive in drives)
        self.records += [{**run, **_record(drive)} for drive in drives]
        for drive in () if self._as_json else drives:
            _print(drive, run.get("run", ""))
        report(drives.diagnostics)
        code = exit_codes.DONE if drives.satisfied else exit_codes.EXPECTATION_VIOLATED
        self.codes.append(exit_codes.severest([exit_codes.exit_code_of(drives.diagnostics), code]))

    def write_table(self) -> None:
        """A line for each scene, in results.csv."""
        from ..files.writing import write_file
        from ..session.tables import columns_of, to_csv

        write_file(self._target / "results.csv", to_csv(columns_of(self._rows)))

    def summary(self) -> str:
        """In how many scenes all expectations hold; nothing where nothing is expected."""
        return f"{holding(sum(self._satisfied), len(self._satisfied))}; " if self._expects else ""


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


def _print(drive: Drive, run: str) -> None:
    took = f"{drive.duration:.1f} s" if len(drive.trace.time) else "no time"
    echo(f"{run}{': ' if run else ''}scene {drive.scene.index}: {took} driven in {drive.engine}")
    for verdict in drive.verdicts.values():
        word = style("holds   ", fg="green") if verdict.satisfied else style("violated", fg="red")
        if verdict.satisfied is None:
            word = "not judged"
        rho = "" if verdict.robustness is None else f"  robustness {verdict.robustness:.3g}"
        echo(f"  {word}  {verdict.name}: {verdict.text}{rho}")
