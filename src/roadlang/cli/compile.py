"""`roadlang compile FILE`: scenes of a scene file, written whole or not at all."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..diagnostics import Diagnostic, DiagnosticError
from ..session.outputs import parse_outputs
from ..session.scene_files import parse_overrides
from . import exit_codes
from .console import echo, holding, note, report, violations

if TYPE_CHECKING:
    from ..ir.manifest import Manifest
    from ..session.scene_set import SceneSet


@click.command("compile")
@click.argument("file", type=click.Path())
@click.option(
    "-o", "--output", "folder", default="out", show_default=True, metavar="DIR", type=click.Path()
)
@click.option(
    "-n",
    "count",
    type=click.IntRange(min=1, max=1_000_000),
    help="Number of scenes; by default 1, or all of a grid.",
)
@click.option(
    "--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Random seed."
)
@click.option(
    "--jobs",
    type=click.IntRange(min=1, max=256),
    default=1,
    show_default=True,
    help="Number of worker processes; does not change the result.",
)
@click.option(
    "--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set the value of a param."
)
@click.option(
    "--emit",
    metavar="KIND,...",
    help="Outputs, in place of the file's `emit`s: `json,svg{size: 800px}`.",
)
@click.option(
    "--json", "as_json", is_flag=True, help="Print the manifest and the diagnostics as JSON."
)
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
    """Check FILE, sample scenes that satisfy its requirements, and write them to DIR.

    DIR gets scene-0000.json, scene-0000.svg, ... as the `emit`s of FILE say (JSON and SVG if there
    are none), and manifest.json with the digests of all of them. The same file, inputs and seed
    give the same bytes. The exit code is 4 if a road violates an `expect`; expectations of drives
    are evaluated by `roadlang run`.
    """
    run = _Compilation(as_json)
    target = Path(folder).absolute()  # a plugin may change the current folder
    try:
        outputs = None if emit is None else parse_outputs(emit)
        run.compile(file, parse_overrides(settings), target, count, seed, jobs, outputs)
    except DiagnosticError as error:
        run.found += error.diagnostics
    run.report(folder)
    click.get_current_context().exit(run.exit_code)


class _Compilation:
    """What was found and written so far."""

    def __init__(self, as_json: bool) -> None:
        self.as_json = as_json
        self.found: list[Diagnostic] = []
        self.scenes: SceneSet | None = None
        self.manifest: Manifest | None = None

    def compile(
        self,
        file: str,
        overrides: dict[str, str],
        folder: Path,
        count: int | None,
        seed: int,
        jobs: int,
        outputs: Sequence[str] | None,
    ) -> None:
        from ..session.loading import load
        from .progress import ProgressBar

        loaded = load(file).with_params(overrides)
        if outputs is not None:
            loaded = loaded.with_outputs(outputs)
        self.found += loaded.check()
        if any(diagnostic.is_error for diagnostic in self.found):
            return
        from ..session.scene_set import NoSceneError

        try:
            with ProgressBar("scenes") as progress:
                self.scenes = loaded.sample(count, seed=seed, jobs=jobs, progress=progress)
        except NoSceneError as error:
            self.scenes = error.result
            raise
        self.found += self.scenes.diagnostics
        with ProgressBar("files") as progress:
            self.manifest = self.scenes.emit(folder, progress=progress)

    @property
    def exit_code(self) -> int:
        """That of the errors, or 4 where a road violates an `expect`."""
        code = exit_codes.exit_code_of(self.found)
        if code == exit_codes.DONE and self.scenes is not None and not self.scenes.satisfied:
            return exit_codes.EXPECTATION_VIOLATED
        return code

    def report(self, folder: str) -> None:
        """The manifest or a summary to stdout; diagnostics and the table to stderr."""
        self.found = list(dict.fromkeys(self.found))
        if self.as_json:
            click.echo(self._as_json())
            return
        report(self.found)
        if self.scenes is None:
            return
        if self.scenes.result.missing:
            note(f"\n{self.scenes.rejection_table}")
        for remark in self.scenes.remarks:
            note(f"note: {remark}")
        if self.manifest is not None:
            for line in violations(self.scenes.expectations):
                echo(line)
            scenes = _count(len(self.scenes), "scene")
            tried = _count(self.scenes.candidates, "candidate")
            files = _count(len(self.manifest.files), "file")
            echo(f"{scenes} of {tried}, {files} in {folder}{self._held()}")

    def _held(self) -> str:
        """In how many scenes the expectations hold, where they do not in all."""
        assert self.scenes is not None
        violating = {i for found in self.scenes.expectations for i in found.violated}
        total = len(self.scenes)
        return f"; {holding(total - len(violating), total)}" if violating else ""

    def _as_json(self) -> str:
        import dataclasses

        from ..diagnostics.render import to_record

        scenes = self.scenes
        table = [] if scenes is None else [dataclasses.asdict(row) for row in scenes.rejections]
        record = {
            "manifest": None if self.manifest is None else dataclasses.asdict(self.manifest),
            "diagnostics": [to_record(diagnostic) for diagnostic in self.found],
            "requirements": table,
            "expectations": (
                [] if scenes is None else [dataclasses.asdict(e) for e in scenes.expectations]
            ),
            "remarks": [] if scenes is None else list(scenes.remarks),
        }
        return json.dumps(record, indent=2)


def _count(number: int, noun: str) -> str:
    return f"{number:,} {noun}{'' if number == 1 else 's'}"
