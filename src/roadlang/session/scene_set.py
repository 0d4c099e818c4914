"""The scenes that a scenario was sampled for, and how often each requirement refused one."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from ..diagnostics import Code, Diagnostic, DiagnosticError, arguments, diagnose
from ..ir.result_columns import OF_SCENES, robustness_column, value_columns
from ..scenes.sampling import SamplingResult, SceneObserver, sample_scenes
from ..search.worker_pool import ALONE
from .expectations import Expectation, expectations_of
from .scene import Scene
from .tables import columns_of, frame_of

if TYPE_CHECKING:
    import pandas

    from ..ir.manifest import Manifest
    from ..scenes.emitted import Emission
    from ..search.rejection_report import RejectionRow
    from ..search.worker_pool import Workers
    from .drives import DriveSet
    from .loading import LoadedScenario

Progress = Callable[[int, int], None]


class NoSceneError(DiagnosticError):
    """No candidate satisfied the requirements; `result` tells which of them refused how many."""

    def __init__(self, result: SceneSet) -> None:
        super().__init__(*result.diagnostics)
        self.result = result

    @property
    def details(self) -> str:
        """The table of what rejected how many candidates."""
        return self.result.rejection_table


def sampled(
    loaded: LoadedScenario,
    n: int | None,
    seed: int,
    workers: Workers,
    after_pass: SceneObserver | None = None,
    emission: Emission | None = None,
) -> SceneSet:
    """The scenes of a scenario; `LoadedScenario.sample` tells what is raised."""
    source, registry, params = loaded.scenario, loaded.registry, loaded.params
    result = sample_scenes(source, registry, n, seed, params, after_pass, workers, emission)
    scenes = SceneSet(loaded, seed, result)
    if not scenes:
        raise NoSceneError(scenes)
    return scenes


def refuse_impossible(loaded: LoadedScenario, seed: int) -> None:
    """Raises `NoSceneError` RL600, as `sampled` does, without warnings of the check, of a scenario
    with a requirement that no draw can satisfy."""
    try:
        sampled(loaded, 1, seed, ALONE)
    except NoSceneError as error:
        told = loaded.check()
        error.diagnostics = tuple(each for each in error.diagnostics if each not in told)
        raise


class SceneSet(Sequence[Scene]):
    """Scenes in order of their index, with the statistics of the search for them.

    `loaded` is the scenario, `seed` what it was sampled with. Notebooks show the contact sheet.
    """

    def __init__(self, loaded: LoadedScenario, seed: int, result: SamplingResult) -> None:
        self.loaded = loaded
        self.seed = seed
        self.result = result
        self._scenes = tuple(Scene(record, loaded) for record in result.scenes)

    def __repr__(self) -> str:
        scenes = f"{len(self)} {'scene' if len(self) == 1 else 'scenes'}"
        candidates = f"{self.candidates:,} {'candidate' if self.candidates == 1 else 'candidates'}"
        return f"<{scenes} of {candidates}>"

    def __len__(self) -> int:
        return len(self._scenes)

    @overload
    def __getitem__(self, index: int) -> Scene: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Scene]: ...
    def __getitem__(self, index: int | slice) -> Scene | Sequence[Scene]:
        return self._scenes[index]

    def __iter__(self) -> Iterator[Scene]:
        return iter(self._scenes)

    @property
    def candidates(self) -> int:
        """How many were tried."""
        return self.result.candidates

    @property
    def rejections(self) -> tuple[RejectionRow, ...]:
        """How many candidates each requirement was tried on and rejected, most rejecting first."""
        return self.result.table

    @property
    def rejection_table(self) -> str:
        """`rejections` for people."""
        return self.result.table_text

    @property
    def remarks(self) -> tuple[str, ...]:
        """Remarks of extractors on the pictures."""
        return self.result.remarks

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Warnings of the check, what could not be built as drawn, and why there are fewer scenes
        than requested, or why they are alike (RL600 to RL603)."""
        return (
            *self.loaded.check(),
            *self.result.warnings,
            *_shortfall(self.result, str(self.loaded.path)),
        )

    @property
    def expectations(self) -> tuple[Expectation, ...]:
        """How each `expect` came out over the scenes; those over the drive are not judged yet."""
        return expectations_of(
            (scene.index, verdict) for scene in self for verdict in scene.expectations.values()
        )

    @property
    def satisfied(self) -> bool:
        """Whether no scene violates an expectation that is judged."""
        return not any(found.violated for found in self.expectations)

    def to_dict(self) -> dict[str, list[Any]]:
        """Columns for `pandas.DataFrame`, one row a scene: `scene`, params and `let`s, draws by
        place, and the robustness of each constraint that is known before the drive."""
        return columns_of(_row(scene) for scene in self)

    def to_frame(self) -> pandas.DataFrame:
        """`to_dict` as a data frame with the scenes as index. Raises `ImportError` without
        pandas."""
        return frame_of(self.to_dict(), "scene")

    def emit(
        self,
        folder: str | Path,
        outputs: str | Sequence[str] | None = None,
        *,
        progress: Progress | None = None,
    ) -> Manifest:
        """Write the files of the scenario's `emit`s, and `manifest.json`.

        `outputs` come instead of them: `["json", "svg { size: 800px }"]`, or one, `"json"`. JSON
        and SVG where there is neither. Files are written whole, all of them or none, and those of
        an earlier run are removed. Raises `DiagnosticError` (RL460 where the folder cannot be
        written).
        """
        from .emitting import emit

        arguments.function("progress", progress)
        resolved = arguments.path(
            "folder", folder
        ).absolute()  # a plugin can change the current one
        loaded = self.loaded if outputs is None else self.loaded.with_outputs(outputs)
        return emit(loaded, self.result, self.seed, resolved, progress)

    def run(self, engine: str | None = None, **options: Any) -> DriveSet:
        """Drive every scene in a simulator, all with one engine; see `Scene.run`."""
        from .drives import drive

        return drive(self, self.loaded.registry, engine, options, self.loaded.places)

    def _repr_svg_(self) -> str:
        from ..plugins.configured import configured
        from ..plugins.guard import plugin_guard
        from .scene import FIGURE

        entry, kind = configured(self.loaded.registry, "emit", FIGURE, {})
        with plugin_guard(entry, None):
            sheets = kind.collection([scene.record for scene in self])
            return next((str(sheet) for sheet in sheets.values()), "") or self[0].svg()


def _row(scene: Scene) -> dict[str, Any]:
    verdicts = {**scene.requirements, **scene.expectations}
    return {
        "scene": scene.index,
        **value_columns({**scene.values, **scene.draws}, OF_SCENES),
        **{
            robustness_column(name, OF_SCENES): verdict.robustness
            for name, verdict in verdicts.items()
            if verdict.robustness is not None
        },
    }


_FEW, _COLLAPSED = 10, 0.3


def _collapse(result: SamplingResult, file: str) -> list[Diagnostic]:
    """Whether scenes are far more like each other than even draws would be."""
    found, expected = result.diversity, result.expected_diversity
    if found is None or expected is None or result.accepted < _FEW:
        return []
    if found >= _COLLAPSED * expected:
        return []
    return [
        diagnose(Code.DRAWS_COLLAPSED, path=file, found=f"{found:.3g}", expected=f"{expected:.3g}")
    ]


def _shortfall(result: SamplingResult, file: str) -> list[Diagnostic]:
    """Why there are fewer scenes than requested."""
    hint = "the table shows what rejects most"
    if result.scenes and result.missing:
        found = f"{result.accepted} of {result.wanted}"
        return [diagnose(Code.TOO_FEW_SCENES, path=file, made=found, help=hint)]
    if result.scenes:
        return _collapse(result, file)
    if result.impossible:
        which = "; ".join(result.impossible)
        help_, span = list(result.causes), result.impossible_at
        return [diagnose(Code.IMPOSSIBLE_REQUIREMENTS, span, path=file, which=which, help=help_)]
    tried, causes = f"{result.candidates:,}", [hint, *result.causes]
    return [diagnose(Code.NO_SCENE_FOUND, path=file, tried=tried, help=causes)]
