"""Compiles one set of scenes into a folder, and reports on it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..diagnostics import Diagnostic, DiagnosticError
from ..ir.result_columns import OF_RUNS, value_columns
from . import exit_codes
from .console import echo, holding, note, report, shown, violations

if TYPE_CHECKING:
    from ..ir.manifest import Manifest
    from ..search.worker_pool import Workers
    from ..session.loading import LoadedScenario
    from ..session.scene_set import SceneSet
    from .pass_output import PassPrinter


class Compilation:
    """What was found and written so far."""

    def __init__(self, loaded: LoadedScenario, folder: Path) -> None:
        self.loaded = loaded
        self.folder = folder
        self.found: list[Diagnostic] = []
        self.scenes: SceneSet | None = None
        self.manifest: Manifest | None = None

    def check(self) -> bool:
        """Whether the scenario has no errors."""
        self.found += self.loaded.check()
        return not any(diagnostic.is_error for diagnostic in self.found)

    def compile(
        self, count: int | None, seed: int, workers: Workers, print_after: str | None = None
    ) -> None:
        """Sample scenes and write them; what is wrong is kept for the report."""
        try:
            self._compile(count, seed, workers, print_after)
        except DiagnosticError as error:
            self.found += error.diagnostics

    def _compile(
        self, count: int | None, seed: int, workers: Workers, print_after: str | None
    ) -> None:
        from ..search.worker_pool import Workers
        from ..session.compiling import compiled
        from ..session.scene_set import NoSceneError
        from .progress import ProgressBar

        printer = None if print_after is None else self._printer(print_after)
        try:
            with ProgressBar("scenes") as progress:
                who = Workers(workers.jobs, workers.executor, progress)
                self.scenes, self.manifest = compiled(
                    self.loaded, self.folder, count, seed, who, printer
                )
        except NoSceneError as error:
            self.scenes = error.result
            raise
        self.found += self.scenes.diagnostics

    def _printer(self, name: str) -> PassPrinter:
        from .pass_output import PassPrinter

        return PassPrinter(self.loaded.scenario, name)

    @property
    def exit_code(self) -> int:
        """That of the errors, or 4 where a road violates an `expect`."""
        code = exit_codes.exit_code_of(self.found)
        if code == exit_codes.DONE and self.scenes is not None and not self.scenes.satisfied:
            return exit_codes.EXPECTATION_VIOLATED
        return code

    def report(self) -> None:
        """A summary to stdout; diagnostics and the table of requirements to stderr."""
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
            echo(f"{scenes} of {tried}, {files} in {shown(self.folder)}{self._held()}")

    def _held(self) -> str:
        """In how many scenes the expectations hold, where they do not in all."""
        assert self.scenes is not None
        violating = {i for found in self.scenes.expectations for i in found.violated}
        total = len(self.scenes)
        return f"; {holding(total - len(violating), total)}" if violating else ""

    def row(self) -> dict[str, Any]:
        """The line of a table of runs."""
        scenes = self.scenes
        expectations = () if scenes is None else scenes.expectations
        return {
            **value_columns(self.loaded.params, OF_RUNS),
            "scenes": 0 if scenes is None else len(scenes),
            "candidates": 0 if scenes is None else scenes.candidates,
            "violated": " ".join(found.name for found in expectations if found.violated),
            "exit code": self.exit_code,
        }

    def record(self) -> dict[str, Any]:
        """Everything as JSON."""
        import dataclasses

        from ..diagnostics.render import to_record

        scenes = self.scenes
        table = [] if scenes is None else [dataclasses.asdict(row) for row in scenes.rejections]
        expectations = () if scenes is None else scenes.expectations
        return {
            "manifest": None if self.manifest is None else dataclasses.asdict(self.manifest),
            "diagnostics": [to_record(diagnostic) for diagnostic in dict.fromkeys(self.found)],
            "requirements": table,
            "expectations": [dataclasses.asdict(found) for found in expectations],
            "remarks": [] if scenes is None else list(scenes.remarks),
        }


def _count(number: int, noun: str) -> str:
    return f"{number:,} {noun}{'' if number == 1 else 's'}"
