"""`provenance.json` of results: made of a run or a search, written, and read again."""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ..ir.encoding import to_json
from ..ir.recorded_names import recorded_name
from ..ir.results_record import ResultsRecord
from ..version import __version__
from .manifest import scene_file_digests

if TYPE_CHECKING:
    from .falsification import Falsification
    from .scene import Scene
    from .scene_set import SceneSet

Options = Mapping[str, Any]
Outputs = Sequence[str] | None
"""Texts of `--emit`; None where there is none."""


def record_of_run(
    scenes: SceneSet, wanted: int | None, engine: str | None, options: Options
) -> str:
    """Of scenes that were sampled and driven. `wanted`: how many, as the user said."""
    loaded, seed = scenes.loaded, scenes.seed
    scenario = loaded.scenario
    count = [] if wanted is None else ["-n", str(wanted)]
    words = [*count, "--seed", str(seed), *_engine(engine, options), *_params(loaded.params)]
    words += _emit(loaded.outputs)
    sampled = scenes[0].provenance
    return to_json(
        ResultsRecord(
            command="run",
            again=shlex.join(["roadlang", "run", recorded_name(loaded.path), *words]),
            name=scenario.header.name,
            title=scenario.header.title,
            source=recorded_name(loaded.path),
            seed=seed,
            roadlang=__version__,
            engine=engine,
            options=dict(options),
            sampler="random" if scenario.sample is None else scenario.sample.kind,
            params=dict(sorted(loaded.params.items())),
            inputs={**loaded.inputs, **scene_file_digests(scenario), **sampled.inputs},
            plugins=dict(sampled.plugins),
        )
    )


def record_of_scene(
    scene: Scene,
    file: str,
    sha256: str,
    engine: str | None,
    options: Options,
    outputs: Outputs = None,
) -> str:
    """Of one scene that was driven as it was in a file."""
    words = ["roadlang", "run", file, *_engine(engine, options), *_emit(outputs)]
    return to_json(
        ResultsRecord(
            command="run",
            again=shlex.join(words),
            name=scene.name,
            title=scene.title,
            source=file,
            seed=None,
            roadlang=__version__,
            engine=engine,
            options=dict(options),
            inputs={file: sha256, **scene.provenance.inputs},
            plugins=dict(scene.provenance.plugins),
        )
    )


def record_of_search(search: Falsification) -> str:
    """Of a search for failures."""
    loaded, plan, drives = search.loaded, search.plan, search.drives
    scenario = loaded.scenario
    expects = [word for name in search.expects for word in ("--expect", name)]
    settings = {
        "--with": plan.entry.name,
        "--evaluations": plan.evaluations,
        "--failures": plan.failures,
        "--seconds": plan.seconds,
        "--batch": plan.batch,
        "--islands": plan.islands,
        "--random": plan.random,
        "--seed": plan.seed,
    }
    chosen = [str(w) for pair in settings.items() if pair[1] is not None for w in pair]
    words = [*expects, *chosen, *_engine(drives.engine, drives.options), *_params(loaded.params)]
    first = next(iter(search.driven), None)
    inputs = {} if first is None else search.scene(first).provenance.inputs
    return to_json(
        ResultsRecord(
            command="falsify",
            again=shlex.join(["roadlang", "falsify", recorded_name(loaded.path), *words]),
            name=scenario.header.name,
            title=scenario.header.title,
            source=recorded_name(loaded.path),
            seed=plan.seed,
            roadlang=__version__,
            engine=drives.engine,
            options=dict(drives.options),
            sampler=plan.entry.name,
            expects=search.expects,
            params=dict(sorted(loaded.params.items())),
            inputs={**loaded.inputs, **scene_file_digests(scenario), **inputs},
            plugins=search.evaluator.scenario.origins(),
        )
    )


def _engine(engine: str | None, options: Options) -> list[str]:
    words = [] if engine is None else ["--engine", engine]
    if "duration" in options:
        words += ["--duration", repr(options["duration"]).removesuffix(".0")]
    return words


def _emit(outputs: Outputs) -> list[str]:
    return [] if outputs is None else ["--emit", ",".join(outputs)]


def _params(params: Mapping[str, str]) -> list[str]:
    return [word for name, value in params.items() for word in ("--set", f"{name}={value}")]
