"""The scenes that episodes are drawn from."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ..diagnostics import Code, DiagnosticError, diagnose, did_you_mean
from ..diagnostics.arguments import wrong_type
from ..drive.controllers import sensor_arrays
from ..drive.sensor_offers import refuse_sensors
from ..drive.simulators import embedded_engine
from ..drive.written_places import UNKNOWN, WrittenPlaces
from ..ir.scene import Scene as SceneRecord
from ..plugins.kinds import ReadingArray
from ..plugins.registry import Registry
from ..session.loading import LoadedScenario, load
from ..session.scene import Scene, installed
from ..simulation.simulating import AN_AGENT
from .margins import margin_formula
from .observed import Arrays
from .settings import EnvSettings

Source = str | Path | LoadedScenario | Scene | Sequence[Scene] | Sequence[SceneRecord]
FORMULA = "reward"
"""The name of the expectation that is made of a formula."""


@dataclass(frozen=True)
class ScenePool:
    """Scenes in which `driven` (a place in the list of agents of each) waits for actions."""

    scenes: tuple[SceneRecord, ...]
    driven: tuple[int, ...]
    registry: Registry
    margins: tuple[str, ...]
    """the expectations that have a margin at each step"""
    reward: tuple[str, ...]
    """those of them whose least margin is the reward; none: the meters made"""
    sensors: Arrays
    """what the sensors of the driven agents read; the same in all scenes"""
    places: WrittenPlaces = UNKNOWN
    """where the scene file, if there is one, has what drives the other agents"""


def pool_of(source: Source, settings: EnvSettings) -> ScenePool:
    """The scenes of a file, of a loaded scenario, or scenes as they are.

    Raises DiagnosticError: what loading and sampling raise, RL700 where a scene has no agent, RL731
    for an unknown agent, RL730 for a reward that cannot be evaluated step by step.
    """
    records, registry, places_in_file, reward = _records(source, settings)
    if not records:
        raise ValueError("an environment needs at least one scene")
    places = tuple(_place(scene, settings.agent) for scene in records)
    scenes = tuple(_waiting(scene, place) for scene, place in zip(records, places, strict=True))
    verdicts = {verdict.name: verdict for verdict in scenes[0].expectations}
    margins = tuple(
        name for name, verdict in verdicts.items() if margin_formula(verdict, registry) is not None
    )
    if reward is not None and reward not in margins:
        raise _no_reward(reward, verdicts)
    chosen = margins if reward is None else (reward,)
    sensors = _sensors(scenes, places, registry)
    return ScenePool(scenes, places, registry, margins, chosen, sensors, places_in_file)


def _sensors(scenes: Sequence[SceneRecord], places: Sequence[int], registry: Registry) -> Arrays:
    """Raises DiagnosticError RL257 for a sensor that the embedded engine does not offer, ValueError
    where the scenes do not have the same."""
    driven = [scene.agents[place] for scene, place in zip(scenes, places, strict=True)]
    if not any(agent.sensors for scene in scenes for agent in scene.agents):
        return {}
    refuse_sensors(scenes, embedded_engine(registry), registry)
    each = [sensor_arrays(agent, registry) for agent in driven]
    if any(_layout(arrays) != _layout(each[0]) for arrays in each):
        raise ValueError("the scenes of an environment need the same sensors in the driven agent")
    return {
        sensor: {name: _widest([arrays[sensor][name] for arrays in each]) for name in of_sensor}
        for sensor, of_sensor in each[0].items()
    }


def _layout(sensors: Arrays) -> dict[str, Any]:
    """What makes readings fit into one space."""
    return {
        sensor: {name: (array.shape, array.dtype) for name, array in arrays.items()}
        for sensor, arrays in sensors.items()
    }


def _widest(arrays: Sequence[ReadingArray]) -> ReadingArray:
    """An array with the bounds of all of some: options such as a range may be drawn."""
    low, high = min(array.low for array in arrays), max(array.high for array in arrays)
    return replace(arrays[0], low=low, high=high)


def _records(
    source: Source, settings: EnvSettings
) -> tuple[tuple[SceneRecord, ...], Registry, WrittenPlaces, str | None]:
    """The scenes as sampled; the kinds; where the file has what; the name of the expectation that
    is the reward."""
    text = settings.reward if isinstance(settings.reward, str) else None
    if isinstance(source, str | Path):
        source = load(source)
    if isinstance(source, LoadedScenario):
        loaded = source
        known = {expectation.name for expectation in loaded.scenario.expectations}
        if text is not None and text not in known and not text.strip().isidentifier():
            loaded = loaded.with_text(f"{loaded.text}\nexpect {FORMULA}: {text}\n")
            text = FORMULA
        found = loaded.sample(settings.scenes, seed=settings.scene_seed)
        return tuple(scene.record for scene in found), loaded.registry, loaded.places, text
    every: list[Any] = [source] if isinstance(source, Scene) else list(_iterated(source))
    records: list[SceneRecord] = []
    registry: Registry | None = None
    places: list[WrittenPlaces] = []
    for scene in every:
        is_facade = isinstance(scene, Scene)
        records.append(scene.record if is_facade else scene)
        registry = scene.registry if is_facade and registry is None else registry
        places.append(scene.places if is_facade else UNKNOWN)
    is_one_file = all(found is places[0] for found in places)
    written = places[0] if places and is_one_file else UNKNOWN
    return tuple(records), registry or installed(), written, text


def _iterated(source: Any) -> Iterable[Any]:
    """Raises TypeError for what holds no scenes."""
    expected = "a scene file, what `roadlang.load` gives, a scene or several scenes"
    if not isinstance(source, Iterable):
        raise wrong_type("source", expected, source)
    scenes = list(source)
    for scene in scenes:
        if not isinstance(scene, Scene | SceneRecord):
            raise wrong_type("source", expected, scene)
    return scenes


def _place(scene: SceneRecord, name: str | None) -> int:
    names = [actor.name for actor in scene.agents]
    if not names:
        raise DiagnosticError(diagnose(Code.NO_AGENTS, scene=scene.name, help=AN_AGENT))
    if name is None:
        return 0
    if name not in names:
        help_ = did_you_mean(name, names) or f"its agents are {', '.join(names)}"
        raise DiagnosticError(diagnose(Code.NO_SUCH_AGENT, name=name, scene=scene.name, help=help_))
    return names.index(name)


def _waiting(scene: SceneRecord, place: int) -> SceneRecord:
    """A scene whose agent at a place has no controllers of its own."""
    agents = list(scene.agents)
    agents[place] = replace(agents[place], drive=())
    return replace(scene, agents=tuple(agents))


def _no_reward(name: str, verdicts: dict[str, Any]) -> DiagnosticError:
    if name in verdicts:
        reason = (
            "its value is not known step by step: inside `always` or `eventually` there may be no"
            " further temporal operator, no `time`, no monitor, and its `robustness` may be no"
            " shift in time (`time`, `time_left`)"
        )
        return DiagnosticError(diagnose(Code.NOT_A_REWARD, name=name, reason=reason))
    known = list(verdicts)
    reason = "the scenes have no `expect` of this name"
    help_ = did_you_mean(name, known) or f"their expectations are {', '.join(known) or 'none'}"
    return DiagnosticError(diagnose(Code.NOT_A_REWARD, name=name, reason=reason, help=help_))
