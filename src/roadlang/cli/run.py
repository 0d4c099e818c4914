"""`roadlang run FILE`: scenes are driven, and every `expect` is judged on what happened."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..diagnostics import DiagnosticError
from ..ir.result_files import is_scene_file_name, run_name
from ..session.outputs import parse_outputs
from ..session.params import parse_overrides
from . import exit_codes, shared_options
from .console import echo, note, report, shown

if TYPE_CHECKING:
    from ..diagnostics import Diagnostic, Source
    from ..drive.batches import DriveTask
    from ..drive.written_places import WrittenPlaces
    from ..search.worker_pool import Workers
    from ..session.finished_drives import DriveFinishing
    from ..session.loading import LoadedScenario
    from ..session.scene import Scene
    from ..session.scene_set import SceneSet


@click.command("run")
@click.argument("file")
@shared_options.engine
@shared_options.output("out/drives")
@shared_options.count
@shared_options.seed
@shared_options.jobs
@shared_options.cluster
@click.option("--resume", is_flag=True, help="Keep the drives that an earlier run finished in DIR.")
@shared_options.settings
@shared_options.params
@shared_options.duration
@shared_options.emit_of_drives
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
    emit: str | None,
    window: bool,
    jobs: int,
    cluster: str | None,
    resume: bool,
    as_json: bool,
) -> None:
    """Sample scenes of FILE, drive them, evaluate the expectations, and write traces to DIR.

    FILE is a scene file, or one scene that `emit json` or `roadlang falsify` wrote (scene.json),
    which is driven as it is. DIR has a trace and a figure of each drive, the files that the `emit`s
    of FILE write for drives (such as `emit openscenario`), and results.csv with a row per scene.
    Finished drives are kept: `--resume` continues after an interruption. If --params has a list of
    maps, each is a run in its own folder, DIR/run-000, ... The exit code is 4 if an expectation is
    violated, and 5 if the simulator fails.
    """
    from ..session.cluster import cluster as workers_of

    target = Path(folder).absolute()  # before a plugin can change the current folder
    options: dict[str, Any] = {} if duration is None else {"duration": duration}
    if window:
        options["headless"] = False
    with workers_of(cluster, jobs) as workers:
        outputs = None if emit is None else parse_outputs(emit)
        batch = RunBatch(target, engine, options, workers, resume, as_json, outputs)
        if is_scene_file_name(file):
            _refuse_sampling({"-n": count, "--seed": seed, "--set": settings, "--params": params})
            batch.add_scene(file)
        else:
            batch.add_variants(file, params, parse_overrides(settings), count, seed)
    batch.write_table()
    if as_json:
        click.echo(json.dumps(batch.records, indent=2))
    else:
        echo(f"{batch.summary()}traces and verdicts in {shown(target)}")
    click.get_current_context().exit(exit_codes.severest(batch.codes))


def _refuse_sampling(options: dict[str, Any]) -> None:
    """Usage errors of options that choose scenes of a scene file: a scene is driven as it is."""
    for name, value in options.items():
        if value:
            raise click.UsageError(
                f"{name} applies to scene files (.rl); a finished scene is driven as it is"
            )


class RunBatch:
    """The drives of one or several runs. `records` holds their verdicts, `codes` their exit
    codes."""

    def __init__(
        self,
        target: Path,
        engine: str | None,
        options: dict[str, Any],
        workers: Workers,
        resume: bool,
        as_json: bool,
        outputs: Sequence[str] | None = None,
    ) -> None:
        self._outputs = outputs
        self._target = target
        self._engine = engine
        self._options = options
        self._workers = workers
        self._resume = resume
        self._as_json = as_json
        self._rows: list[dict[str, Any]] = []
        self._contacts = 0
        self.records: list[dict[str, Any]] = []
        self.codes: list[int] = []

    def add_scene(self, file: str) -> None:
        """Drive the scene in a file as it is."""
        from hashlib import sha256

        from ..drive.written_places import UNKNOWN
        from ..session.drive_outputs import named_backends
        from ..session.finished_drives import DriveFinishing
        from ..session.result_folders import refuse_results_of_others
        from ..session.results_record import record_of_scene
        from ..session.scene import Scene
        from ..session.scene_files import read_scene_file

        refuse_results_of_others(self._target, "run")
        text = read_scene_file(file)
        scene, digest = Scene.from_json(text, file), sha256(text.encode()).hexdigest()
        outputs, registry = self._outputs, scene.registry
        backends = [] if outputs is None else named_backends(outputs, registry)
        origin = record_of_scene(scene, file, digest, self._engine, self._options, outputs)
        finishing = DriveFinishing(self._task(registry, UNKNOWN), None, backends)
        self._drive([scene], finishing, (text, origin), {})

    def add_variants(
        self,
        file: str,
        params: str | None,
        overrides: dict[str, Source],
        count: int | None,
        seed: int,
    ) -> None:
        """Sample and drive scenes, for each map of params in a folder of its own."""
        from ..session.loading import load
        from ..session.result_folders import refuse_results_of_others
        from ..session.run_files import remove_run
        from ..session.runs import remove_later_runs, variants

        each, is_list = variants(load(file), params)
        if self._outputs is not None:
            each = [variant.with_outputs(self._outputs) for variant in each]
        each = [variant.with_params(overrides) for variant in each]
        _check_all(each)
        refuse_results_of_others(self._target, "run", is_list)
        for number, loaded in enumerate(each):
            self._add(loaded, {"run": run_name(number)} if is_list else {}, count, seed)
        if is_list and not self._resume:
            remove_later_runs(self._target, len(each), remove_run)

    def _add(
        self, loaded: LoadedScenario, run: dict[str, str], count: int | None, seed: int
    ) -> None:
        """One run; that there is no scene ends only this one."""
        from ..session.drive_outputs import drive_backends
        from ..session.finished_drives import DriveFinishing
        from ..session.results_record import record_of_run
        from ..session.scene_set import NoSceneError
        from .progress import ProgressBar

        backends = drive_backends(loaded)
        jobs, executor = self._workers.jobs, self._workers.executor
        try:
            with ProgressBar("scenes") as progress:
                scenes = loaded.sample(
                    count, seed=seed, jobs=jobs, executor=executor, progress=progress
                )
        except NoSceneError as error:
            if not run:
                raise
            report(error.diagnostics)
            note(f"\n{error.details}")
            self.codes.append(exit_codes.exit_code_of(error.diagnostics))
            return
        report(scenes.diagnostics)
        origin = record_of_run(scenes, count, self._engine, self._options)
        task = self._task(loaded.registry, loaded.places)
        finishing = DriveFinishing(task, loaded, backends)
        self._drive(scenes, finishing, (_key(scenes), origin), run)

    def _task(self, registry: Any, places: WrittenPlaces) -> DriveTask:
        from ..drive.batches import DriveTask

        return DriveTask(registry, self._engine, self._options, True, places)

    def _drive(
        self,
        scenes: Sequence[Scene],
        finishing: DriveFinishing,
        origin: tuple[str, str],
        run: dict[str, str],
    ) -> None:
        """Drive what is not finished, write and print it as it comes, and count all. `origin`: what
        stands for all that the drives depend on, and the text of `provenance.json`."""
        from ..session.drives_in_parts import drive_in_parts
        from ..session.run_files import RunFolder
        from .drive_lines import print_drive
        from .progress import ProgressBar

        outputs = [] if self._outputs is None else self._outputs
        key = _digest([origin[0], *outputs], finishing.task)
        target = self._folder(run)
        folder = RunFolder(target, key, origin[1], self._resume)
        report(folder.diagnostics)
        open_ = [scene for scene in scenes if scene.index not in folder.finished]
        found: dict[Diagnostic, None] = {}
        with (
            ProgressBar("drives") as progress,
            folder.removed_if_nothing_is_driven(),
            folder.staging(self._workers) as stage,
        ):
            for drives in drive_in_parts(open_, replace(finishing, stage=stage), self._workers):
                folder.add(drives)
                for drive in drives:
                    found |= dict.fromkeys(drive.diagnostics)
                    if not self._as_json:
                        print_drive(drive.line, run.get("run", ""), in_full=len(scenes) == 1)
                progress(len(folder.finished), len(scenes))
        report(tuple(found))
        numbers = [scene.index for scene in scenes]
        records = folder.records(numbers)
        self._contacts += folder.contacts(numbers)
        self._rows += [{**run, **row} for row in folder.rows(numbers)]
        self.records += [{**run, **record} for record in records]
        satisfied = all(map(_holds, records))
        code = exit_codes.DONE if satisfied else exit_codes.EXPECTATION_VIOLATED
        self.codes.append(exit_codes.severest([exit_codes.exit_code_of(found), code]))

    def _folder(self, run: dict[str, str]) -> Path:
        return self._target / run["run"] if run else self._target

    def write_table(self) -> None:
        """A line for each scene, in results.csv."""
        from ..files.writing import write_file
        from ..session.tables import columns_of, to_csv

        write_file(self._target / "results.csv", to_csv(columns_of(self._rows)))

    def summary(self) -> str:
        """In how many scenes all expectations hold, and the worst; nothing where nothing is
        expected."""
        from .drive_lines import summary

        if not any(record["expectations"] for record in self.records):
            some = f"contacts in {self._contacts} of {len(self.records)} scenes; "
            return some if self._contacts else ""
        satisfied = [_holds(record) for record in self.records]
        return summary(self._rows, satisfied, self._contacts)


def _check_all(variants: Sequence[LoadedScenario]) -> None:
    """Raises `DiagnosticError` with what is wrong in any of them, before the first is driven."""
    found = [diagnostic for variant in variants for diagnostic in variant.check()]
    if any(diagnostic.is_error for diagnostic in found):
        raise DiagnosticError(*found)


def _holds(record: dict[str, Any]) -> bool:
    return all(found["satisfied"] for found in record["expectations"])


def _key(scenes: SceneSet) -> str:
    from ..falsification.search_key import digest

    settings = {"seed": scenes.seed, "params": dict(scenes.loaded.params)}
    return digest(scenes.loaded.scenario, settings)


def _digest(key: Sequence[str], task: DriveTask) -> str:
    import hashlib

    settings = json.dumps([*key, task.engine, dict(task.options)], sort_keys=True, default=str)
    return hashlib.sha256(settings.encode()).hexdigest()
