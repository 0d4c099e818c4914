"""What random scene files come to, in lines."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from roadlang import DiagnosticError, NoSceneError, testing
from tests.golden.random_maps import opendrive_map, street_extract
from tests.golden.random_scenes import RandomScene
from tests.golden.random_towns import RandomTown
from tests.golden.summaries import array, of_json, of_svg, plain
from tests.golden.traffic_views import agent_lines


def town_lines(seeds: range) -> Iterator[str]:
    """Random towns: as `random_lines` has them, with routes, junctions and who goes first there."""
    yield from _lines((seed, RandomTown(seed).text()) for seed in seeds)


def mapped_lines(seeds: range) -> Iterator[str]:
    """Random maps of other tools as the networks of scenes, some of them perturbed."""
    with tempfile.TemporaryDirectory() as place:
        for seed in seeds:
            osm = seed % 3 == 2
            path = Path(place) / ("a.osm" if osm else "a.xodr")
            path.write_text(street_extract(seed) if osm else opendrive_map(seed), encoding="utf-8")
            block = ("", " { perturb with sine { amplitude: 0.3m, wavelength: 30m } }")[seed % 2]
            agent = "agent a is car on town at random { route: random, drive with traffic }"
            world = "world { traffic: left }\n" if seed % 4 == 3 and not osm else ""
            text = f'{world}network town from "{path}"{block}\n{agent}\n'
            lines = _lines([(seed, text)])
            yield from (line.replace(str(path), "MAP") for line in lines)


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
            yield from agent_lines(scenes[0].run(duration=3.0).trace)
        if seed % 6 == 1:
            yield from of_svg(scenes[0].svg())


def _scene_lines(record: dict[str, Any]) -> Iterator[str]:
    yield f"  world {plain(json.dumps(record['world']))[:300]}"
    for road in record["roads"]:
        keys = ("x", "y", "width", "curvature", "heading", "stations", "trim")
        columns = [v for key in keys for v in road[key]]
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
        yield from of_json(network, "  network")
    for kind in ("requirements", "expectations"):
        for one in record[kind]:
            profiles = [v for profile in one["profiles"] for v in profile["values"]]
            said = array([v for v in profiles if v is not None]) if profiles else ""
            yield f"  {one['name']}: {one['robustness']} {one['satisfied']} {said}"
    values = {key: value for key, value in record["values"].items() if isinstance(value, float)}
    yield f"  values {sorted(values)} {array(list(values.values())) if values else ''}"
    yield f"  draws {sorted(record['draws'])}"
