"""`check` finds what would stop every scene: tables, rings that do not close, ids of maps, outputs
that are one, and grids that are too large; it says what `compile` says."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import roadlang

WAY = "road main { draw with waypoints { points: [(0m, 0m), (60m, 30m), (100m, 0m)] } }\n"
RING = "road main {{ draw with segments {{ pieces: [{0}] }}, closed: {1} }}\n"
WAYS = ([[10.999, 48], [11, 48], [11.001, 48]], [[11, 47.999], [11, 48]])
STREETS = {
    "type": "FeatureCollection",
    "features": [
        {
            "type": "Feature",
            "properties": {},
            "geometry": {"type": "LineString", "coordinates": way},
        }
        for way in WAYS
    ],
}
PATCHED = (
    "road main {{ draw with segments {{ pieces: [straight(80m)] }}, surface_patches: [{0}] }}\n"
)
PLAN = (
    'image plan from """\n####\n""" {{ scale: 8m/px, legend: {{ "#": road }} }}\n'
    "network town from plan {{ {0} }}\n"
)
FOUND = "agent ego is car on main at 5m\nexpect far: eventually (ego.x > 9m)\n"
GRID = "sample with grid {{ steps: {0} }}\n"
MAP = 'network town from "map.geojson" {{ {0} }}\nroad main from town {{ {1} }}\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "good.csv").write_text("x,y\n0,0\n50,0\n90,10\n")
    (tmp_path / "bad.csv").write_text("x,y\n0,0\n50,zero\n90,10\n")
    (tmp_path / "map.geojson").write_text(json.dumps(STREETS))
    return tmp_path


def _draws(count: int) -> str:
    places = ", ".join(f"({50 * i}m, 0m..1m)" for i in range(count))
    return f"road main {{ draw with waypoints {{ points: [{places}] }} }}\n"


FAULTS = [
    ('road main from "bad.csv"\n', "RL477", 1),
    (RING.format("straight(100m), arc(20m, 90deg)", "true"), "RL472", 1),
    (_draws(6) + GRID.format(100), "RL614", 2),
    (MAP.format("control with stop { junctions: [99] }", ""), "RL429", 1),
    (MAP.format("control with stop { roads: [99] }", ""), "RL411", 1),
    (
        MAP.format("perturb with bump { at: 30m, height: 1m, length: 20m, roads: [99] }", ""),
        "RL411",
        1,
    ),
    (MAP.format("", "select: road(99)"), "RL472", 2),
    (WAY + "emit json\nemit svg\nemit json\n", "RL931", 4),
    (_draws(6) + FOUND + "falsify with grid { steps: 100 }\n", "RL614", 4),
    (PATCHED.format("{ surface: wet, lane: 3 }"), "RL613", 1),
    (PATCHED.format("{ surface: wet, road: 1 }"), "RL411", 1),
    (PATCHED.format("{ surface: wet, over: [200m, 300m] }"), "RL414", 1),
    (PATCHED.format("{ surface: wet, over: [20m, 20m] }"), "RL414", 1),
    (
        PATCHED.format("{ surface: wet, lane: 2 }") + "road bent from main { lanes: 4 }\n",
        "RL613",
        1,
    ),
    (PATCHED.format("{ surface: wet, lane: 2 }") + "road bent from main {}\n", "RL613", 1),
    (PLAN.format("lanes: 2, surface_patches: [{ surface: wet, lane: 7 }]"), "RL613", 4),
    (PLAN.format("surface_patches: [{ surface: wet }, { surface: ice, road: 9 }]"), "RL411", 4),
    (MAP.format("surface_patches: [{ surface: ice, road: 9, lane: 4 }]", ""), "RL411", 1),
    (WAY + "emit svg { size: 300px }\nemit svg { size: 300px }\n", "RL931", 3),
]


@pytest.mark.parametrize(("text", "code", "line"), FAULTS)
def test_check_says_what_would_stop_every_scene(
    text: str, code: str, line: int, folder: Path
) -> None:
    (fault,) = roadlang.loads(text, folder=folder).check()
    assert fault.span is not None
    assert (fault.code, fault.span.line, fault.path) == (code, line, None)


@pytest.mark.parametrize(
    "text",
    [
        'road main from "good.csv"\n',
        RING.format("arc(20m, 360deg)", "true"),
        RING.format("arc(20m, 180deg..360deg)", "true"),  # some scene may close
        _draws(6) + GRID.format(3),
        _draws(6) + "sample with random\n",
        MAP.format("control with stop { junctions: [2] }", ""),
        MAP.format(
            "perturb with bump { at: 30m, height: 1m, length: 20m, roads: [choice(1, 99)] }", ""
        ),
        MAP.format("", "select: road(1)"),
        MAP.format("", "select: road(choice(1, 99))"),
        WAY + "emit svg { size: 300px }\nemit svg { size: 400px }\n",
        WAY + "emit json\nemit svg\n",
        _draws(6) + FOUND + "falsify with grid { steps: 10 }\n",
        _draws(6) + FOUND + "falsify with random\n",
        PATCHED.format("{ surface: wet, lane: choice(-1, 3) }"),
        PATCHED.format("{ surface: wet, lane: 1, over: [70m, 300m] }"),
        PLAN.format("lanes: 2, surface_patches: [{ surface: wet, lane: -1, road: 1 }]"),
    ],
)
def test_what_some_scene_may_have_is_left_to_compile(text: str, folder: Path) -> None:
    assert roadlang.loads(text, folder=folder).check() == ()


@pytest.mark.parametrize("size", [900_000, 1_100_000])
def test_a_table_of_more_than_a_megabyte_is_left_to_compile(size: int, folder: Path) -> None:
    content = (folder / "bad.csv").read_text()
    (folder / "bad.csv").write_text(content + " " * size)
    found = roadlang.loads('road main from "bad.csv"\n', folder=folder).check()
    assert [fault.code for fault in found] == (["RL477"] if size < 1_000_000 else [])
