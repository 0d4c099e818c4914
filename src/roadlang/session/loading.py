"""Scene files, loaded and checked, ready to be sampled: `roadlang.load`.

A facade: a scenario samples a set of scenes, which knows the scenario.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..diagnostics import Diagnostic, DiagnosticError, Source, arguments
from ..diagnostics.diagnostic import in_order
from ..ir.seeds import LARGEST_SEED
from .meant_arguments import refuse_sampling, refuse_searching
from .outputs import check_outputs, parse_outputs
from .params import ParamValue, param_sources
from .scene_files import read_scene_file

if TYPE_CHECKING:
    from ..drive.written_places import WrittenPlaces
    from ..ir.scenario import Scenario
    from ..plugins.registry import Registry
    from ..scenes.sampling import SceneObserver
    from ..search.worker_pool import Executor, Workers
    from .falsification import Falsification
    from .param_files import ParamFile
    from .scene_set import SceneSet

Progress = Callable[[int, int], None]
_PARTS = ("text", "path", "registry", "outputs", "inputs")


def load(file: str | Path, /, **params: ParamValue) -> LoadedScenario:
    """The scenario of a scene file, with values for its `param`s.

    A value is a number for a param without unit, or text as in the language: `reach="12m"`.
    Nothing heavy happens before `check` or `sample`. Raises `DiagnosticError` (RL920 to RL923)
    where the file cannot be read.
    """
    path = arguments.path("file", file)
    return LoadedScenario(read_scene_file(str(file)), path, param_sources(params))


def loads(text: str, /, *, folder: str | Path = ".", **params: ParamValue) -> LoadedScenario:
    """The scenario of a text; the files that it names are relative to `folder`."""
    path = arguments.path("folder", folder) / "scene.rl"
    return LoadedScenario(arguments.text("text", text), path, param_sources(params))


class LoadedScenario:
    """A scene file with values for its params. It does not change; `with_params` gives another.

    `path` is where the file is, or for a text would be; `params` holds the values from outside
    as texts of the language, `outputs` what is emitted instead of the file's `emit`s, `inputs` the
    sha256 of files that params were read from.
    """

    def __init__(
        self,
        text: str,
        path: Path,
        params: Mapping[str, str | Source] | None = None,
        registry: Registry | None = None,
        outputs: Sequence[str] | None = None,
        inputs: Mapping[str, str] | None = None,
    ) -> None:
        self.text = text
        self.path = path
        self.inputs: dict[str, str] = dict(inputs or {})
        self._settings: dict[str, str | Source] = dict(params or {})
        self.outputs = None if outputs is None else tuple(outputs)
        self._registry = registry
        self._by_outputs: dict[tuple[str, ...], LoadedScenario] = {}

    def __repr__(self) -> str:
        params = "".join(f", {name}={value!r}" for name, value in self.params.items())
        return f"roadlang.load({str(self.path)!r}{params})"

    @property
    def params(self) -> dict[str, str]:
        """The values from outside, as texts of the language."""
        return {
            name: value.text.strip() if isinstance(value, Source) else value
            for name, value in self._settings.items()
        }

    @cached_property
    def registry(self) -> Registry:
        """The kinds that the scenario may use: those of all installed plugins."""
        from ..plugins.discovery import load_registry

        return load_registry() if self._registry is None else self._registry

    def with_params(
        self, params: Mapping[str, ParamValue] | None = None, /, **more: ParamValue
    ) -> LoadedScenario:
        """The same file with other values for some params."""
        given = param_sources({**arguments.mapping("params", params or {}), **more})
        if not given:
            return self
        return self._changed(params={**self._settings, **given})

    def with_param_file(self, file: str | Path | ParamFile) -> tuple[LoadedScenario, ...]:
        """The same file with the params of a YAML file: one of a map, several of a list of maps.

        Raises `DiagnosticError` (RL920, RL936, RL937) where the file cannot be read.
        """
        from .param_files import ParamFile, read_params

        if not isinstance(file, ParamFile):
            file = read_params(str(arguments.path("file", file)))
        found = file
        inputs = {**self.inputs, found.path: found.sha256}
        return tuple(
            self._changed(params={**self._settings, **values}, inputs=inputs)
            for values in found.sets
        )

    def with_text(self, text: str) -> LoadedScenario:
        """Another text in the place of the file, with the same params."""
        return self._changed(text=arguments.text("text", text))

    def with_outputs(self, outputs: str | Sequence[str]) -> LoadedScenario:
        """The same file with other outputs than its `emit`s: `["json", "svg { size: 800px }"]`,
        or `"json, svg"`.

        One without options that the file has an `emit` for means that `emit`. Raises
        `DiagnosticError` RL930 for a kind that is not there, RL928 for none at all.
        """
        given = arguments.texts("outputs", outputs)
        key = tuple(output for text in given for output in parse_outputs(text))
        if key not in self._by_outputs:  # checking a file takes longer than to write a scene
            check_outputs(key, self.registry)
            self._by_outputs[key] = self._changed(outputs=key)
        return self._by_outputs[key]

    def _changed(self, **parts: Any) -> LoadedScenario:
        same = {name: getattr(self, name) for name in _PARTS}
        return LoadedScenario(**{**same, "params": self._settings, **parts})

    def check(self) -> tuple[Diagnostic, ...]:
        """Everything that is wrong or doubtful in the file, in the order of the places."""
        return self._checked[1]

    @property
    def scenario(self) -> Scenario:
        """The checked scenario, with random values not drawn yet.

        Raises `DiagnosticError` with all errors and warnings of the file where it has errors.
        """
        scenario, found = self._checked
        if scenario is None:
            raise DiagnosticError(*found)
        return scenario

    @cached_property
    def places(self) -> WrittenPlaces:
        """Where the file has what a drive may find faults with. Raises as `scenario`."""
        from ..drive.written_places import WrittenPlaces

        return WrittenPlaces.of(self.scenario)

    def sample(
        self,
        n: int | None = None,
        *,
        seed: int = 0,
        jobs: int = 1,
        progress: Progress | None = None,
        after_pass: SceneObserver | None = None,
        executor: Executor | None = None,
        **params: ParamValue,
    ) -> SceneSet:
        """`n` scenes that satisfy the requirements; one, or all of a grid, where `n` is None.

        The same file, inputs, params and seed give the same scenes: neither `n` nor the number
        of processes (`jobs`) changes one, nor does an `executor` (anything with `submit`, of `jobs`
        workers). `progress` is called with the scenes done and wanted, `after_pass` with the number
        of a scene, each pass and what it made (in one process).
        Raises `ValueError` where `n` is below 1 or `seed` below 0, `DiagnosticError` for what is
        wrong with the file, its inputs or a plugin, and `NoSceneError` (RL600,
        RL601) where no candidate satisfies the requirements.
        """
        if params:
            changed = self.with_params(params)
            refuse_sampling(params, self._declared)
            return changed.sample(
                n,
                seed=seed,
                jobs=jobs,
                progress=progress,
                after_pass=after_pass,
                executor=executor,
            )
        from .scene_set import sampled

        n = None if n is None else arguments.whole_number("n", n, least=1)
        seed = arguments.whole_number("seed", seed, least=0, most=LARGEST_SEED)
        workers = _workers(jobs, executor, progress)
        return sampled(self, n, seed, workers, arguments.function("after_pass", after_pass))

    def falsify(  # noqa: PLR0913 - one parameter for each option
        self,
        expects: str | Sequence[str] | None = None,
        *,
        searcher: str | None = None,
        engine: str | None = None,
        options: Mapping[str, Any] | None = None,
        seed: int = 0,
        jobs: int = 1,
        executor: Executor | None = None,
        folder: str | Path | None = None,
        resume: bool = False,
        progress: Progress | None = None,
        **settings: Any,
    ) -> Falsification:
        """Search the scenes that satisfy every `require` for some that violate an `expect`.

        What is not given is as the file's `falsify` says: `expects`, the most important first,
        `searcher`, and the settings `evaluations`, `failures`, `seconds`, `batch`, `islands`,
        `random`. `engine` with its `options` (SI units) is as in `SceneSet.run`. The same scenario,
        seed and settings give the same outcomes, whatever `jobs` and `executor` (anything with
        `submit`, of `jobs` workers) are. `folder` keeps a journal, which `resume` goes on with.
        Raises `NoSceneError` RL600 where no draw can satisfy a requirement, `DiagnosticError`
        (RL702 for the journal of another search, RL703, RL705 where there is nothing to violate or
        to search; for settings RL220 where there is none of that name, RL206 and RL208 for its
        value), `TypeError` and `ValueError` for the other arguments.
        """
        from ..falsification.settings import SETTINGS
        from .falsification import Drives, falsified

        refuse_searching(settings, SETTINGS, self._declared)
        if resume and folder is None:
            raise ValueError("`resume` needs the `folder` with the journal of the search")
        if expects is not None:
            expects = arguments.texts("expects", expects)
        return falsified(
            self,
            arguments.whole_number("seed", seed, least=0, most=LARGEST_SEED),
            arguments.text_or_none("searcher", searcher),
            {"expects": expects, **settings},
            Drives(engine, dict(arguments.mapping("options", options or {}))),
            _workers(jobs, executor, progress),
            None if folder is None else arguments.path("folder", folder).absolute(),
            resume,
        )

    def _declared(self) -> frozenset[str]:
        """The names of params and `let`s. Raises `DiagnosticError` where the file has errors."""
        return frozenset(value.name for value in self.scenario.values)

    @cached_property
    def _checked(self) -> tuple[Scenario | None, tuple[Diagnostic, ...]]:
        from ..semantics import check_text

        scenario, found = check_text(
            self.text, self.path, self._settings, self.registry, self.outputs
        )
        if scenario is not None:
            from .empty_files import empty_file
            from .fixed_faults import fixed_faults

            empty = empty_file(scenario, self.path)
            faults = fixed_faults(scenario, self.registry) if empty is None else [empty]
            if faults:
                return None, tuple(in_order([*found, *faults]))
        return scenario, tuple(found)


def _workers(jobs: int, executor: Executor | None, progress: Progress | None) -> Workers:
    """Who does the work of a function with these arguments."""
    from ..search.worker_pool import Workers

    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise arguments.wrong_type("executor", "something with a method `submit`", executor)
    jobs = arguments.whole_number("jobs", jobs, least=1)
    return Workers(jobs, executor, arguments.function("progress", progress))
