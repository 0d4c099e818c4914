"""A failure on disk as a `Failure` again: the same candidate of the same search, evaluated anew."""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.draw_record import DrawRecord
from ..falsification.evaluator import AFTER_VIOLATION, Evaluator, Proposal, Task
from ..falsification.outcome import Outcome
from ..falsification.search_loop import SearchResult
from ..falsification.settings import plan_of
from ..ir.result_files import FAILURES, INDEX, SCENARIO, SCENE, SHRUNK
from ..ir.results_record import RESULTS_FILE, ResultsRecord
from ..ir.scene import Scene as SceneRecord
from ..report.reading import read_record, read_typed
from ..scenes.instantiate import driven_scene
from ..world.index import index_scenario
from .falsification import Failure, Falsification
from .loading import LoadedScenario, load
from .scene import Scene
from .scene_files import read_scene_file

_OTHER = {
    "roads": "its roads differ", "agents": "its agents differ", "objects": "its objects differ",
    "world": "its world differs",
}  # fmt: skip
"""Parts of a scene, in the order in which they are compared."""


def failure_in(file: str | Path, scene_file: str | Path | None = None) -> Failure:
    """The failure in a scene that `roadlang falsify` or `roadlang run` wrote.

    `scene_file` is where the scene file is now, if not where it was. Raises `DiagnosticError` RL722
    for a scene that is no failure of results on disk, RL723 where the scene file makes another
    scene now, and what `load` raises.
    """
    path = Path(file)
    if path.suffix.lower() == SCENARIO and path.is_file():
        command = f"roadlang falsify {shlex.quote(str(path))} -o DIR"
        help = f"`{command}` searches for failures and writes them to DIR/{FAILURES}"
        raise _no_failure(path, "it is a scene file", help)
    scene = Scene.from_json(read_scene_file(str(path)), str(path)).record
    record = _record(path)
    loaded = load(record.source if scene_file is None else scene_file).with_params(record.params)
    indexed = index_scenario(loaded.scenario, loaded.registry)
    rank, axes, proposal = _place(path, record, scene, loaded)
    plan, expects = plan_of(indexed, record.seed or 0, None, {"expects": record.expects or None})
    task = Task(
        loaded.scenario, loaded.registry, record.seed or 0, axes, expects, record.engine,
        dict(record.options), loaded.params, _after_violation(scene),
    )  # fmt: skip
    evaluator = Evaluator(task)
    outcome = _evaluated(evaluator, proposal, scene, path, str(loaded.path))
    result = SearchResult((outcome,), (outcome,))
    found = Falsification(loaded, plan, evaluator, result).failures[0]
    found.rank = rank
    return found


def _after_violation(scene: SceneRecord) -> float | None:
    """How long the drive that failed went on: the plan in the scene file may have changed since."""
    call = scene.simulate
    return None if call is None else call.options.get(AFTER_VIOLATION)


@dataclass(frozen=True)
class _Item:
    scene: str
    evaluation: int
    point: tuple[float, ...]


@dataclass(frozen=True)
class _Index:
    axes: tuple[str, ...]
    failures: tuple[_Item, ...]


def _record(path: Path) -> ResultsRecord:
    """What the results are made from that hold the scene."""
    for folder in (path.parent, path.parent.parent):
        if (folder / RESULTS_FILE).is_file():
            record = read_record(folder)
            if record.seed is None:
                break
            return record
    reason = f"there is no {RESULTS_FILE} of a run or a search next to it"
    raise _no_failure(path, reason, "name the scene in the folder in which it was written")


def _place(
    path: Path, record: ResultsRecord, scene: SceneRecord, loaded: LoadedScenario
) -> tuple[int, tuple[str, ...], Proposal]:
    """The rank of the failure, the axes of its search and its place among them."""
    if record.command == "falsify":
        if path.parent.name != FAILURES:
            help_ = f"the failures of a search are in its folder `{FAILURES}`"
            raise _no_failure(path, f"it is not in the folder `{FAILURES}`", help_)
        index = read_typed(path.parent / INDEX, _Index)
        for rank, item in enumerate(index.failures, 1):
            if item.scene == path.name:
                return rank, index.axes, Proposal(item.evaluation, item.point)
        if path.name.endswith(SHRUNK):
            failure = path.name.removesuffix(SHRUNK) + SCENE
            raise _no_failure(path, f"it was made by `roadlang shrink` from {failure}")
        raise _no_failure(path, f"{INDEX} next to it does not list it")
    if not record.is_random_sample:
        reason = f"its scenes were chosen by `{record.sampler}`, not at random"
        raise _no_failure(path, reason)
    coordinates = _coordinates(loaded, scene)
    point = tuple(coordinates.values())
    return 1, tuple(coordinates), Proposal(scene.provenance.attempt, point)


def _coordinates(loaded: LoadedScenario, scene: SceneRecord) -> dict[str, float]:
    """The numbers in [0, 1) that a scene of a random sample was made from, by name."""
    origin, drawn = scene.provenance, DrawRecord()
    indexed = index_scenario(loaded.scenario, loaded.registry)
    number, attempt = np.array([origin.scene]), np.array([origin.attempt])
    driven_scene(CandidateBatch(indexed, origin.seed, number, attempt, None, drawn), 0, {})
    return {name: float(values[0]) for name, values in drawn.named_coordinates().items()}


def _evaluated(
    evaluator: Evaluator, proposal: Proposal, scene: SceneRecord, path: Path, source: str
) -> Outcome:
    """The outcome, where it is the scene that the file holds and fails."""
    axes = len(evaluator.task.axes)
    reason = "it has other random values"
    if len(proposal.point) == axes:
        again = evaluator.full_scene(proposal)
        other = [name for name in _OTHER if getattr(again, name) != getattr(scene, name)]
        if not other:
            outcome = evaluator.evaluate([proposal])[0]
            if outcome.is_failure:
                return outcome
            raise _no_failure(path, "its drive violates no expectation")
        reason = _OTHER[other[0]]
    raise DiagnosticError(
        diagnose(Code.OTHER_SCENE, path=str(path), file=str(path), source=source, reason=reason)
    )


def _no_failure(path: Path, reason: str, help: str = "") -> DiagnosticError:
    return DiagnosticError(
        diagnose(Code.NOT_A_FAILURE, path=str(path), file=str(path), reason=reason, help=help)
    )
