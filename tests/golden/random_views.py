"""What random scene files come to, in lines."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import Any

from roadlang import DiagnosticError, NoSceneError, testing
from tests.golden.random_scenes import RandomScene
from tests.golden.random_towns import RandomTown
from tests.golden.summaries import array, of_json, of_svg, plain
from tests.golden.traffic_views import agent_lines


def town_lines(seeds: range) -> Iterator[str]:
    """Random towns: as `random_lines` has them, with routes, junctions and who goes first there."""
    yield from _lines((seed, RandomTown(seed).text()) for seed in seeds)


def random_lines(seeds: range) -> Iterator[str]:
    """Each scene that is found: its roads, things and verdicts; some of them driven or drawn."""
    yield from _lines((seed, RandomScene(seed).text()) for seed in seeds)


def _lines(texts: Iterable[tuple[int, str]]) -> Iterator[str]:
    for seed, text in texts:
        yield f"--- {seed}"
        try:
            scenes = testing.sample(text, 1, seed=seed)
        except NoSceneError as error:
            yield from (f"  {line}" for line in str(error).splitlines())
            continue
        except DiagnosticError as error:
            yield from (f"  {found.code} {found.message}" for found in error.diagnostics)
            continue
        yield from (f"  {found.code} {found.message}" for found in scenes.diagnostics)
        record = json.loads(scenes[0].to_json())
        yield from _scene_lines(record)
        if seed % 3 == 0 and record["agents"]:
            yield from agent_lines(scenes[0].run(duration=3.0))
        if seed % 6 == 1:
            yield from of_svg(scenes[0].svg())


def _scene_lines(record: dict[str, Any]) -> Iterator[str]:
    yield f"  world {plain(json.dumps(record['world']))[:300]}"
    for road in record["roads"]:
        columns = [v for key in ("x", "y", "width", "curvature") for v in road[key]]
        lanes = [(lane["id"], lane["kind"], lane["marking"]) for lane in road["lane_list"]]
        yield f"  road {road['name']}: {array(columns)} {lanes} {road['speed_limit']}"
    for thing in (*record["agents"], *record["objects"]):
        numbers = [thing[key] for key in ("x", "y", "heading", "length", "width")]
        more = [
            thing.get(key) for key in ("kind", "road", "lane", "start", "start_speed", "facing")
        ]
        yield f"  {thing['name']}: {array(numbers)} {more}"
        if thing.get("route"):
            yield from of_json(thing["route"], "    route")
    for network in record["networks"]:
        for junction in network["junctions"]:
            yield f"  junction {junction['id']} {plain(json.dumps(junction['control']))[:300]}"
    for kind in ("requirements", "expectations"):
        for one in record[kind]:
            profiles = [v for profile in one["profiles"] for v in profile["values"]]
            said = array([v for v in profiles if v is not None]) if profiles else ""
            yield f"  {one['name']}: {one['robustness']} {one['satisfied']} {said}"
    values = {key: value for key, value in record["values"].items() if isinstance(value, float)}
    yield f"  values {sorted(values)} {array(list(values.values())) if values else ''}"
    yield f"  draws {sorted(record['draws'])}"
