"""`roadlang compile FILE`: scenes of a scene file, written whole or not at all."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose, did_you_mean
from . import exit_codes
from .console import report, say
from .scene_files import parse_overrides, read_scene_file

if TYPE_CHECKING:
    from ..ir.manifest import Manifest
    from ..ir.scenario import Scenario
    from ..plugins.registry import Registry
    from ..scenes.sampling import SamplingResult


@click.command("compile")
@click.argument("file", type=click.Path())
@click.option(
    "-o", "--output", "folder", default="out", show_default=True, metavar="DIR", type=click.Path()
)
@click.option(
    "-n",
    "count",
    type=click.IntRange(min=1, max=1_000_000),
    help="How many scenes; by default one, or all of a grid.",
)
@click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True)
@click.option(
    "--jobs",
    type=click.IntRange(min=1, max=256),
    default=1,
    show_default=True,
    help="Processes that search for scenes; the scenes are the same.",
)
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set a param.")
@click.option("--emit", metavar="KIND,...", help="Instead of the file's `emit`s: `json,svg`.")
@click.option("--json", "as_json", is_flag=True, help="Print manifest and diagnostics as JSON.")
def command(
    file: str,
    folder: str,
    count: int | None,
    seed: int,
    jobs: int,
    settings: tuple[str, ...],
    emit: str | None,
    as_json: bool,
) -> None:
    """Check FILE, draw scenes that satisfy its requirements, and write them to DIR.

    DIR gets scene-0000.json, scene-0000.svg, ... as the file's `emit`s say (JSON and SVG if it has
    none), and manifest.json with the digests of all of them. The same file, inputs and seed give
    the same bytes.
    """
    run = _Run(file, parse_overrides(settings), as_json)
    try:
        names = None if emit is None else [name.strip() for name in emit.split(",") if name.strip()]
        run.compile(Path(folder), count, seed, jobs, names)
    except DiagnosticError as error:
        run.found += error.diagnostics
    run.report()
    click.get_current_context().exit(exit_codes.exit_code_of(run.found))


_USUAL_EMITS = ("json", "svg")
"""What a file without an `emit` is taken to mean."""


class _Run:
    """One compilation: what was found and written so far."""

    def __init__(self, file: str, overrides: dict[str, str], as_json: bool) -> None:
        self.file = file
        self.overrides = overrides
        self.as_json = as_json
        self.found: list[Diagnostic] = []
        self.result: SamplingResult | None = None
        self.manifest: Manifest | None = None
        self.folder = Path()

    def compile(
        self, folder: Path, count: int | None, seed: int, jobs: int, names: Sequence[str] | None
    ) -> None:
        from ..plugins.discovery import load_registry

        self.folder = folder
        registry = load_registry()
        scenario = self._checked(registry)
        if scenario is None:
            return
        if names is None and not scenario.emits:
            names = _USUAL_EMITS
        _check_emits(scenario, registry, names)
        self._sample(scenario, registry, count, seed, jobs)
        if self.result is not None and self.result.scenes:
            self._write(scenario, registry, seed, names)

    def _checked(self, registry: Registry) -> Scenario | None:
        from ..semantics import check_text

        text = read_scene_file(self.file)
        scenario, found = check_text(text, Path(self.file), self.overrides, registry)
        self.found += found
        return scenario

    def _sample(
        self, scenario: Scenario, registry: Registry, count: int | None, seed: int, jobs: int
    ) -> None:
        from ..scenes.sampling import sample_scenes
        from .progress import ProgressBar

        with ProgressBar("scenes") as progress:
            self.result = sample_scenes(
                scenario, registry, count, seed, jobs, progress, self.overrides
            )
        self.found += _shortfall(self.result, self.file)

    def _write(
        self, scenario: Scenario, registry: Registry, seed: int, names: Sequence[str] | None
    ) -> None:
        from ..ir.encoding import to_json
        from ..scenes.emitting import backends_of, outputs, send
        from ..scenes.writing import write_all
        from .progress import ProgressBar
        from .provenance import manifest_of

        assert self.result is not None
        backends = backends_of(scenario, registry, names)
        with ProgressBar("files") as progress:
            written = outputs(backends, self.result.scenes, progress)
        manifest = manifest_of(
            scenario, self.result, written, self.file, seed, self.overrides, backends
        )
        contents = {output.path: output.content for output in written}
        write_all(self.folder, {**contents, "manifest.json": to_json(manifest).encode()})
        self.manifest = manifest
        send(backends, self.result.scenes)

    def report(self) -> None:
        """The manifest or a summary to stdout; diagnostics and the table to stderr."""
        if self.as_json:
            click.echo(_as_json(self.manifest, self.found, self.result))
            return
        report(self.found)
        result = self.result
        if result is not None and result.missing:
            click.echo(f"\n{result.table_text}", err=True)
        for remark in result.remarks if result is not None else ():
            click.echo(f"note: {remark}", err=True)
        if self.manifest is not None and result is not None:
            scenes = _count(result.accepted, "scene")
            tried = _count(result.candidates, "candidate")
            say(f"{scenes} of {tried}, {_count(len(self.manifest.files), 'file')} in {self.folder}")


def _count(number: int, noun: str) -> str:
    return f"{number:,} {noun}{'' if number == 1 else 's'}"


def _check_emits(scenario: Scenario, registry: Registry, names: Sequence[str] | None) -> None:
    faults = []
    for name in names or ():
        if not registry.has("emit", name):
            known = registry.names("emit")
            hints = did_you_mean(name, known) or (f"there are {', '.join(known)}",)
            faults.append(diagnose(Code.UNKNOWN_CHOICE, what="backend", name=name, help=hints))
    if not (scenario.emits if names is None else names):
        faults.append(diagnose(Code.NOTHING_TO_EMIT, help="for instance `--emit json,svg`"))
    if faults:
        raise DiagnosticError(*faults)


def _shortfall(result: SamplingResult, file: str) -> list[Diagnostic]:
    """Why there are fewer scenes than asked for."""
    if result.scenes and result.missing:
        made = f"{result.accepted} of {result.wanted}"
        return [
            diagnose(
                Code.TOO_FEW_SCENES, path=file, made=made, help="the table shows what rejects most"
            )
        ]
    if result.scenes:
        return []
    if result.impossible:
        which = "; ".join(result.impossible)
        return [diagnose(Code.IMPOSSIBLE_REQUIREMENTS, path=file, which=which)]
    tried = f"{result.candidates:,}"
    return [
        diagnose(
            Code.NO_SCENE_FOUND, path=file, tried=tried, help="the table shows what rejects most"
        )
    ]


def _as_json(
    manifest: Manifest | None, found: Sequence[Diagnostic], result: SamplingResult | None
) -> str:
    import dataclasses

    from ..diagnostics.render import to_record

    table = [dataclasses.asdict(row) for row in result.table] if result is not None else []
    record = {
        "manifest": None if manifest is None else dataclasses.asdict(manifest),
        "diagnostics": [to_record(diagnostic) for diagnostic in found],
        "requirements": table,
        "remarks": list(result.remarks) if result is not None else [],
    }
    return json.dumps(record, indent=2, ensure_ascii=False)
