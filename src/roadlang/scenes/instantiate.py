"""Candidates made into scenes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import PurePath
from typing import Any

import numpy as np

from ..diagnostics import Diagnostic, DiagnosticError
from ..evaluate.candidates import CandidateBatch, fixed_candidate
from ..evaluate.concrete import call_of
from ..evaluate.draw_names import draw_place
from ..evaluate.evaluation import named
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.read_only import FrozenDict
from ..ir.recorded_names import recorded_name
from ..ir.scenario import Input, ScenarioConstraint
from ..ir.scene import Call, Provenance, Scene, SceneSignal, Verdict
from ..ir.values import Condition, PassCall, Value
from ..judging.profiles import scene_signals, with_profiles
from ..judging.verdicts import verdict, verdicts
from ..judging.window_warnings import road_window_warnings
from ..version import __version__
from ..world.networks.networks import network_root
from ..world.placement.copies import is_group
from ..world.roads.aliasing import aliasing_remarks, has_silent_passes
from ..world.roads.roads import road_root
from .actors import legend_objects, objects_and_markings, scene_actors
from .bend_warnings import bend_warnings
from .network_warnings import joined_road_warnings, network_warnings
from .roads import scene_networks, scene_roads
from .scene_rows import SceneRows
from .start_gaps import slowed_behind
from .start_meetings import slowed_before_meetings
from .start_speeds import headways_kept
from .worlds import world_columns


@dataclass(frozen=True)
class ConcreteScene:
    """A scene, and what is to be said of how it was made: by extractors, of perturbations."""

    scene: Scene
    remarks: tuple[str, ...]
    warnings: tuple[Diagnostic, ...] = ()


def concrete_scenes(
    candidates: CandidateBatch, numbers: Sequence[int], overrides: Mapping[str, str]
) -> list[ConcreteScene]:
    """The scenes of candidates, which have a record; `numbers` are those of the scenes.

    A scene has the same bytes whatever it is made with. Raises DiagnosticError where one of them
    cannot be made, alone or with the others.
    """
    rows = SceneRows(candidates)
    source = rows.scenario.source
    members = _driven(rows, numbers, overrides)
    members |= {
        "signals": _signals(rows),
        "requirements": _judged(source.requirements, rows),
        "expectations": _judged(source.expectations, rows),
    }
    roots = [network_root(network, candidates) for network in source.networks]
    remarks = [[remark for root in roots for remark in root.remarks]] * rows.count
    if has_silent_passes(rows.scenario):
        # Without the record of draws: what is run again is not drawn again.
        singles = (candidates.take(np.array([row])) for row in range(rows.count))
        aliased = [aliasing_remarks(single) for single in singles]
        remarks = [[*found, *more] for found, more in zip(remarks, aliased, strict=True)]
    warned = network_warnings(source.networks, candidates)
    warned += joined_road_warnings(source.roads, candidates) + road_window_warnings(candidates)
    scenes = _finished(members, rows)
    bends = bend_warnings(source.agents, scenes)
    return [
        ConcreteScene(scene, tuple(found), warned + tight)
        for scene, found, tight in zip(scenes, remarks, bends, strict=True)
    ]


def all_concrete_scenes(
    candidates: CandidateBatch, numbers: Sequence[int], overrides: Mapping[str, str]
) -> list[ConcreteScene]:
    """As `concrete_scenes`, of any candidates: many at a time where they can be made together."""
    if candidates.count > 1 and candidates.scenario.has_fixed_roots:
        with suppress(DiagnosticError):
            return concrete_scenes(candidates, numbers, overrides)
    singles = map(candidates.single, range(candidates.count))
    return [instantiate(*each, overrides) for each in zip(singles, numbers, strict=True)]


def driven_scenes(
    candidates: CandidateBatch, numbers: Sequence[int], overrides: Mapping[str, str]
) -> list[Scene]:
    """The scenes without what only people and figures want: requirements, signals, profiles.

    They are driven as those of `concrete_scenes` are, and made in a fraction of the time.
    """
    rows = SceneRows(candidates)
    expected = [_expected(item, rows) for item in rows.scenario.source.expectations]
    members = _driven(rows, numbers, overrides)
    members["expectations"] = list(zip(*expected, strict=True)) if expected else rows.same(())
    return _finished(members, rows)


def driven_scenes_or_faults(
    candidates: CandidateBatch, numbers: Sequence[int], overrides: Mapping[str, str]
) -> list[Scene | DiagnosticError]:
    """As `driven_scenes`; in place of a scene that cannot be made, why."""
    if candidates.count > 1 and candidates.scenario.has_fixed_roots:
        with suppress(DiagnosticError):
            return [*driven_scenes(candidates, numbers, overrides)]
    found: list[Scene | DiagnosticError] = []
    for row, number in enumerate(numbers):
        try:
            found.append(driven_scene(candidates.single(row), number, overrides))
        except DiagnosticError as error:
            found.append(error)
    return found


def instantiate(
    candidates: CandidateBatch, index: int, overrides: Mapping[str, str]
) -> ConcreteScene:
    """The scene of a single candidate, which has a record."""
    return concrete_scenes(candidates, [index], overrides)[0]


def driven_scene(candidates: CandidateBatch, index: int, overrides: Mapping[str, str]) -> Scene:
    """As `driven_scenes`, of a single candidate."""
    return driven_scenes(candidates, [index], overrides)[0]


def _driven(
    rows: SceneRows, numbers: Sequence[int], overrides: Mapping[str, str]
) -> dict[str, Sequence[Any]]:
    """Members of the scenes by name, without what was drawn; a list (V,) of each."""
    source, candidates = rows.scenario.source, rows.candidates
    values = {item.name: rows.plain(named(item.name, candidates)) for item in source.values}
    placed, legend = scene_actors(source.objects, rows), legend_objects(candidates)
    if legend:
        placed = [(*found, *legend) for found in placed]
    objects, markings = objects_and_markings(placed)
    networks = scene_networks(rows)
    agents = scene_actors(source.agents, rows)
    roads = scene_roads(rows)
    headways = [headways_kept(source.agents, placed, rows.scenario) for placed in agents]
    agents = [*map(slowed_before_meetings, agents, headways, roads)]
    simulate = source.simulate
    return {
        "index": numbers,
        "provenance": _provenances(rows, numbers, overrides),
        "values": _maps(values, rows),
        "networks": networks,
        "roads": roads,
        "agents": [*map(slowed_behind, agents, objects, headways, networks, roads)],
        "objects": objects,
        "markings": markings,
        "world": _maps(world_columns(rows), rows),
        "simulate": rows.same(None) if simulate is None else _calls(simulate, rows),
    }


def _calls(call: PassCall, rows: SceneRows) -> list[Call]:
    if rows.differ(call):
        return rows.each(lambda candidate: call_of(call, candidate))
    key = ("simulate", call.kind)
    return rows.same(rows.scenario.once(key, lambda: call_of(call, rows.candidates)))


def _maps(columns: Mapping[str, list[Any]], rows: SceneRows) -> list[FrozenDict[str, Any]]:
    """A map for each scene; the same one where nothing in it differs."""
    if not columns:
        return rows.same(FrozenDict({}))
    names = tuple(columns)
    return [FrozenDict(zip(names, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def _expected(constraint: ScenarioConstraint, rows: SceneRows) -> list[Verdict]:
    """What is expected of a drive is made once where it is the same in every scene."""
    test = constraint.test
    is_of_drive = isinstance(test, Condition) and test.domain == "drive"
    if not is_of_drive:
        return _verdicts(constraint, rows)
    if rows.differ(test):
        return rows.each(partial(verdict, constraint))
    make = partial(verdict, constraint)
    key = ("expected", constraint.name)
    return rows.same(rows.candidates.root(key, is_drawn=False, make=make))


def _verdicts(constraint: ScenarioConstraint, rows: SceneRows) -> list[Verdict]:
    test = constraint.test
    of_drive = not isinstance(test, Condition) and rows.scenario.kind(test)[1].domain == "drive"
    if of_drive or _names_group(test, rows.scenario):
        return rows.each(partial(verdict, constraint))
    return verdicts(constraint, rows.candidates)


def _names_group(value: Value, scenario: IndexedScenario) -> bool:
    """Whether a value speaks of copies that some scenes may lack."""
    entities = scenario.dependencies.entities(value)
    actors = [scenario.actors[each.name] for each in entities if each.role in ("agent", "object")]
    return any(map(is_group, actors))


def _signals(rows: SceneRows) -> list[tuple[SceneSignal, ...]]:
    if any(_names_group(each.condition, rows.scenario) for each in rows.scenario.source.signals):
        return rows.each(lambda candidate: scene_signals(candidate)[0])
    return scene_signals(rows.candidates)


def _judged(
    constraints: Sequence[ScenarioConstraint], rows: SceneRows
) -> list[tuple[Verdict, ...]]:
    columns = [_with_profiles(constraint, rows) for constraint in constraints]
    return list(zip(*columns, strict=True)) if columns else rows.same(())


def _with_profiles(constraint: ScenarioConstraint, rows: SceneRows) -> list[Verdict]:
    test, found = constraint.test, _expected(constraint, rows)
    if not isinstance(test, Condition):
        return found
    if _names_group(test, rows.scenario):
        return [with_profiles(test, [each], rows.alone(row))[0] for row, each in enumerate(found)]
    return with_profiles(test, found, rows.candidates)


def _finished(members: Mapping[str, Sequence[Any]], rows: SceneRows) -> list[Scene]:
    """The scenes, with all that was drawn so far."""
    header, names = rows.scenario.source.header, tuple(members)
    draws = rows.draws()
    units: dict[tuple[str, ...], FrozenDict[str, str]] = {}
    scenes = []
    for drawn, values in zip(draws, zip(*members.values(), strict=True), strict=True):
        places = tuple(drawn)
        if places not in units:
            units[places] = FrozenDict(_units(rows.scenario, drawn))
        shown = dict(zip(names, values, strict=True))
        scenes.append(Scene(header.name, header.title, draws=drawn, units=units[places], **shown))
    return scenes


def fixed_remarks(scenario: IndexedScenario) -> tuple[str, ...]:
    """Remarks of extractors on the networks that are the same in every scene."""
    fixed = [item for item in scenario.networks.values() if not scenario.is_varying(item.name)]
    roots = [network_root(network, fixed_candidate(scenario)) for network in fixed]
    return tuple(remark for root in roots for remark in root.remarks)


def _provenances(
    rows: SceneRows, numbers: Sequence[int], overrides: Mapping[str, str]
) -> list[Provenance]:
    """What scenes were made from and by."""
    scenario, seed = rows.scenario, rows.candidates.seed
    inputs = FrozenDict({item.path: item.sha256 for item in _inputs(rows.candidates)})
    plugins, source = FrozenDict(scenario.origins()), _scene_file(scenario)
    stated, roadlang = FrozenDict(overrides), __version__
    return [
        Provenance(roadlang, seed, number, attempt, inputs, plugins, source, stated)
        for number, attempt in zip(numbers, rows.candidates.attempts.tolist(), strict=True)
    ]


def _scene_file(scenario: IndexedScenario) -> str:
    """The name of the scene file, wherever it lies; empty for a scenario that is of no file."""
    inputs = scenario.source.inputs
    return recorded_name(PurePath(inputs[0].path).name) if inputs else ""


def _inputs(candidates: CandidateBatch) -> list[Input]:
    """The files that all networks and roads come from, by path."""
    scenario = candidates.scenario
    networks = [network_root(network, candidates) for network in scenario.networks.values()]
    roads = [road_root(name, candidates) for name in scenario.roads]
    inputs = [root.inputs for root in networks] + [root.inputs for root in roads]
    return sorted({item for items in inputs for item in items}, key=lambda item: item.path)


def _units(scenario: IndexedScenario, draws: Mapping[str, Any]) -> dict[str, str]:
    """The SI units of values and draws that are quantities; other values have none."""
    named = {
        item.name: item.dimension.unit
        for item in scenario.source.values
        if item.dimension is not None
    }
    drawn = scenario.once(
        "units of draws", lambda: {draw.place: draw.dimension.unit for draw in scenario.draws()}
    )
    named |= {name: drawn.get(draw_place(name), "") for name in draws}
    return {name: unit for name, unit in sorted(named.items()) if unit}
