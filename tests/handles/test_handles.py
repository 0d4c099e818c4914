"""What can be dragged of scenes of every origin: a dragged handle is where it was dropped, in the
scene that the changed text compiles to."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import pytest

import roadlang
from roadlang.handles.handle import Handle
from roadlang.handles.handles import _place_between, dragged, handles_of, inserted, removed

CURVE = "0,0\n40,0\n80,6\n120,20\n160,20\n"
PICTURE = """image plan from \"\"\"
.............
.###########.
.............
\"\"\" { scale: 10m/px, legend: { "#": road } }
network town from plan
"""
THINGS = """agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s } }
object van is parked_van at (20m, 40m)
object tree is tree on main at 30m { side: left, offset: 3m }
"""
ORIGINS = {
    "waypoints": "road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (120m, 9m)] } }",
    "polyline": "road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (120m, 30m)],"
    " curve: polyline } }",
    "segments": "road main { draw with segments { pieces: [straight(60m), arc(80m, 40deg),"
    " straight(40m)] } }",
    "file": 'road main from "curve.csv"',
    "picture": PICTURE + "road main from town { select: longest, width: 7m }",
    "perturbed": PICTURE + "road base from town { select: longest }\nroad main from base {\n"
    "  perturb with sine { amplitude: 3m, wavelength: 60m }  # sways\n}",
    "perturbed waypoints": "road main { draw with waypoints { points: [(0m, 0m), (120m, 9m)] }\n"
    "  perturb with sine { amplitude: 0m..3m, wavelength: 60m } }",
    "closed": "road main { draw with segments { pieces: [straight(60m), arc(30m, 180deg),"
    " straight(60m), arc(30m, 180deg)] }, closed: true }",
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "curve.csv").write_text(CURVE)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def scene_of(text: str) -> roadlang.Scene:
    return roadlang.loads(text).sample(1, seed=0)[0]


def handles(text: str) -> list[Handle]:
    return list(handles_of(text, scene_of(text).record))


@pytest.mark.parametrize("origin", ORIGINS)
def test_every_handle_of_a_road_is_where_it_was_dropped(folder: Path, origin: str) -> None:
    text = f"# mine\n{ORIGINS[origin]}\n{THINGS}"
    scene = scene_of(text).record
    found = list(handles_of(text, scene))
    of_road = [handle for handle in found if handle.name == "main"]
    assert len(of_road) >= 3 or "waypoints" in origin
    now = found
    for number in range(len(of_road)):
        before = now[number]
        to = (before.x + 1.25, before.y - 2.5)
        moved = dragged(text, scene, before, to, "nudges")
        assert moved is not None
        text, scene = moved, scene_of(moved).record
        now = list(handles_of(text, scene))
        assert len(now) == len(found)
        assert math.hypot(now[number].x - to[0], now[number].y - to[1]) < 0.01
    assert text.startswith("# mine\n")
    assert ("# sways" in text) is (origin == "perturbed")
    assert text.endswith(THINGS)


@pytest.mark.parametrize(
    ("at", "is_closed", "number"),
    [
        ((-1.0, 2.0), False, 0), ((0.0, 2.0), False, 1), ((30.0, 2.0), False, 1),
        ((62.0, 10.0), False, 2), ((60.0, 40.0), False, 2), ((60.0, 41.0), False, 3),
        ((-1.0, -2.0), True, 1), ((30.0, 24.0), True, 3), ((61.0, 45.0), True, 2),
    ],
)  # fmt: skip
def test_a_new_waypoint_is_between_the_two_that_it_is_beside_or_beyond_an_end(
    at: tuple[float, float], is_closed: bool, number: int
) -> None:
    assert _place_between([(0.0, 0.0), (60.0, 0.0), (60.0, 40.0)], at, is_closed) == number


def test_handles_of_long_roads_keep_sensible_distances() -> None:
    text = "road main { draw with segments { pieces: [straight(300m), arc(200m, 90deg)] } }\n"
    places = [(handle.x, handle.y) for handle in handles(text)]
    steps = [math.dist(a, b) for a, b in pairwise(places)]
    assert 20.0 < min(steps) <= max(steps) < 40.0


def test_things_are_where_they_were_dropped() -> None:
    text = f"{ORIGINS['waypoints']}\n{THINGS}"
    scene = scene_of(text).record
    by_name = {handle.name: handle for handle in handles(text)}
    sorts = {name: by_name[name].sort for name in ("van", "tree", "ego")}
    assert sorts == {"van": "object", "tree": "object", "ego": "agent"}
    for name, to in (("van", (33.0, 21.5)), ("tree", (70.0, 12.0)), ("ego", (40.0, 9.0))):
        moved = dragged(text, scene, by_name[name], to, "nudges")
        assert moved is not None
        placed = {
            a.name: a for a in (*scene_of(moved).record.agents, *scene_of(moved).record.objects)
        }
        if name == "ego":  # it stays in its lane
            assert placed[name].start == pytest.approx(40.0, abs=0.5)
            assert placed[name].offset == scene.agents[0].offset
        else:
            assert math.hypot(placed[name].x - to[0], placed[name].y - to[1]) < 0.02


def test_copies_and_things_of_other_files_have_no_handles(folder: Path) -> None:
    (folder / "street.rl").write_text(f"{ORIGINS['waypoints']}\nobject oak is tree at (9m, 20m)\n")
    text = (
        'include "street.rl" as left\n'
        "object row is tree on left.main at 10m { count: 3, spacing: 9m, side: left }\n"
        "object elm is tree at (50m, 30m)\n"
    )
    (folder / "scene.rl").write_text(text)
    scene = roadlang.load(folder / "scene.rl").sample(1)[0].record
    assert [handle.name for handle in handles_of(text, scene)] == ["elm"]


def test_a_place_of_a_road_can_be_held_anywhere_and_let_go_again() -> None:
    text = f"{ORIGINS['segments']}\n"
    scene = scene_of(text).record
    more = inserted(text, scene, handles(text)[0], (20.0, 4.0), "nudges")
    assert more is not None
    assert "nudges { at: [20m], by: [(0m, 4m)]" in more
    (near,) = [handle for handle in handles(more) if handle.station == 20.0]
    assert (near.x, near.y) == pytest.approx((20.0, 4.0), abs=0.01)
    assert removed(more, near) == text
    assert removed(text, handles(text)[0]) is None


@pytest.mark.parametrize(
    ("at", "number"), [((-9.0, 1.0), 0), ((30.0, 1.0), 1), ((90.0, 5.0), 2), ((140.0, 12.0), 3)]
)
def test_a_new_waypoint_comes_where_the_road_passes(at: tuple[float, float], number: int) -> None:
    text = f"{ORIGINS['waypoints']}\n"
    more = inserted(text, scene_of(text).record, handles(text)[0], at, "nudges")
    assert more is not None
    new = handles(more)[number]
    assert (new.x, new.y) == at
    assert removed(more, new) == text


FIRST = "road first { draw with waypoints { points: [(0m, 0m), (60m, 0m)] } }\n"
THIRD = "road third { draw with waypoints { points: [(0m, 30m), (60m, 30m)] } }\n"
BUMP = "road second from first { perturb with bump { at: 30m, height: 1m, length: 20m } }\n"
DRIVEN = "agent ego is car on third at 5m\n"


@pytest.mark.parametrize(
    ("text", "held"),
    [
        (FIRST + THIRD, {"first", "third"}),
        (FIRST + BUMP + THIRD, {"second", "third"}),
        (FIRST + BUMP + THIRD + DRIVEN, {"second", "third", "ego"}),
        (FIRST + BUMP + DRIVEN.replace("third", "first"), {"first", "second", "ego"}),
    ],
    ids=["drawn", "perturbed", "driven", "driven as drawn"],
)
def test_the_last_road_of_each_chain_has_handles_and_one_that_is_driven(
    text: str, held: set[str]
) -> None:
    (scene,) = roadlang.loads(text).sample(1)
    assert {handle.name for handle in handles_of(text, scene.record)} == held
