"""A scene drives alone as it drives beside others: the same bytes, whatever the block it is in."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Scene, Trace
from roadlang.drive.controllers import python_controllers
from roadlang.drive.simulators import simulator_of
from roadlang.drive.trace_files import COLUMNS
from roadlang.plugins.discovery import load_registry
from roadlang.simulation import simulating
from roadlang.simulation.surroundings import corridors
from roadlang.simulation.vehicles import compiled

from .routed_scenes import CONTROL_STEP

LOOP = """
road loop {
  draw with waypoints { points: [(0m, 0m), (60m, -5m), (80m, 50m), (10m, 60m)] }
  closed: true, width: 8m
}
agent ego is car on loop at 0%..90% { drive with lane_follow { speed: (6m/s)..(20m/s) } }
"""
SHORT = """
road main { draw with segments { pieces: [straight(90m)] } }
agent ego is car on main at 5m..60m { drive with lane_follow { speed: 10m/s } }
"""
TRAFFIC = """
road base {
  draw with segments { pieces: [straight(60m), arc(40m, 80deg), straight(60m)] }
  width: 8m, lanes: 2
}
road bent from base { perturb with sine { amplitude: 0m..3m, wavelength: 60m..90m } }
agent ego is car on bent at 25m {
  lane: -1
  drive with pure_pursuit { speed: (8m/s)..(20m/s) }
  drive with brake { when: distance(ego, walker) < 15m }
}
agent chaser is car on bent at 5m { lane: -1, drive with car_follow { speed: 14m/s } }
agent oncoming is choice(car, truck) on bent at 60%..95% {
  lane: 1, count: integer(0, 3)
  drive with stanley { speed: 9m/s }
}
agent walker is pedestrian on bent at 90m {
  side: right, offset: 1m
  drive with crossing { speed: 1m/s..2m/s, when: time > 2s }
}
object van is parked_van on bent at 120m { side: right, offset: -1m..1m }
world { friction: 0.3..0.9 }
"""

LEAVING = """
road main { draw with segments { pieces: [straight(60m), arc(60m, 40deg)] }, lanes: 2 }
agent ego is car on main at 5m..70m {
  lane: -1, start_speed: 8m/s
  drive with lane_follow { speed: 9m/s }
  drive with brake { speed: 3m/s, while: distance(ego, lead) < 25m }
  drive with lane_follow {
    speed: 14m/s, when: gap(ego, lead) > 40m or once[0s, 1s] (lead.speed > 11m/s)
  }
}
agent lead is car on main at ahead_of(ego, 12m) {
  lane: -1, start_speed: 6m/s, drive with lane_follow { speed: 7m/s..14m/s }
}
agent others is van on main at random { count: integer(0, 2), facing: back, drive with traffic }
object crate is box on main at 80m { side: right, offset: 1m }
"""

AROUND = """
road main { draw with segments { pieces: [straight(260m)] }, lanes: 2, width: 7m }
agent cars is car on main at 5m..40m { count: 2, lane: -1, drive with traffic { aggression: 0..1 } }
agent stranded is car on main at 100m { lane: -1, start_speed: 0m/s }
object van is parked_van on main at 160m..190m { lane: -1, offset: -0.6m..0m }
"""

CROSSING = '''
image plan from """
.......#.......
.......#.......
.......#.......
###############
.......#.......
.......#.......
.......#.......
""" { scale: 8m/px }
network town from plan { lanes: 2 }
agent cars is choice(car, bus) on town at random { count: 8, drive with traffic }
'''


def drives(scenes: Sequence[Scene], **options: Any) -> list[Trace]:
    registry = load_registry()
    options = {"duration": 12.0, "control_step": CONTROL_STEP, **options}
    _, simulator = simulator_of(scenes[0], registry, "builtin", options)
    return list(simulator.drive_all(scenes, [python_controllers(s, registry) for s in scenes]))


def bytes_of(trace: Trace) -> dict[str, bytes]:
    agents = {
        f"{name}.{column}": np.asarray(getattr(agent, column)).tobytes()
        for name, agent in trace.agents.items()
        for column in COLUMNS
    }
    return {**agents, "time": trace.time.tobytes(), "events": repr(trace.events).encode()}


def records(text: str, n: int) -> list[Scene]:
    return [scene.record for scene in testing.sample(text, n)]


@pytest.mark.parametrize("text", [LOOP, TRAFFIC], ids=["loop", "traffic"])
def test_a_scene_alone_is_its_row_of_a_block(text: str) -> None:
    scenes = records(text, 3)
    together = drives(scenes, control_step=0.04)
    for scene, trace in list(zip(scenes, together, strict=True))[::2]:
        (alone,) = drives([scene], control_step=0.04)
        assert bytes_of(alone) == bytes_of(trace)


def test_traffic_that_goes_around_what_stands_is_its_row_of_a_block() -> None:
    scenes = records(AROUND, 3)
    together = drives(scenes, duration=45.0)
    for number, (scene, trace) in enumerate(zip(scenes, together, strict=True)):
        if number != 1:  # the first and the last
            (alone,) = drives([scene], duration=45.0)
            assert bytes_of(alone) == bytes_of(trace)
        aside = np.abs(trace.agents["cars[0]"].lane_offset) > 1.5
        assert aside.any(), "somebody went around the one that is stranded, or the van"


def test_scenes_of_different_files_drive_in_one_block() -> None:
    scenes = [*records(LOOP, 2), *records(SHORT, 2), *records(TRAFFIC, 2)]
    together = drives(scenes, duration=25.0)
    assert len({len(trace.time) for trace in together}) > 2, "they end at times of their own"
    for scene, trace in list(zip(scenes, together, strict=True))[::2]:
        (alone,) = drives([scene], duration=25.0)
        assert bytes_of(alone) == bytes_of(trace)


def test_conditions_stay_with_their_scenes_when_others_end() -> None:
    scenes = records(LEAVING, 5)
    together = drives(scenes, duration=20.0)
    assert len({len(trace.time) for trace in together}) > 3, "they end at times of their own"
    for scene, trace in list(zip(scenes, together, strict=True))[::2]:
        (alone,) = drives([scene], duration=20.0)
        assert bytes_of(alone) == bytes_of(trace)


def test_the_size_of_blocks_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    scenes = records(TRAFFIC, 4)
    whole = [bytes_of(trace) for trace in drives(scenes)]
    monkeypatch.setattr(simulating, "BLOCK_AGENTS", 14)
    assert [bytes_of(trace) for trace in drives(scenes)] == whole


CRASH = """
road main { draw with segments { pieces: [straight(120m)] }, lanes: 2 }
agent ego is car on main at 10m..30m { lane: -1, drive with lane_follow { speed: 17m/s } }
agent other is car on main at 50m { lane: -1, drive with brake {} }
object wall is parked_van on main at 100m { offset: 1.8m }
agent late is car on main at 5m {
  lane: 1, facing: forward
  drive with lane_follow { speed: 20m/s }
}
"""


@pytest.mark.parametrize(
    ("text", "control_step"),
    [(TRAFFIC, 0.1), (TRAFFIC, 0.3), (LOOP, 0.3), (CRASH, 0.04), (CRASH, 0.3)],
    ids=["traffic", "traffic_seldom", "loop", "crash_often", "crash"],
)
def test_how_often_it_is_recorded_changes_no_drive(text: str, control_step: float) -> None:
    scenes = records(text, 2)
    often = drives(scenes, step=0.1, control_step=control_step)
    seldom = drives(scenes, step=0.5, control_step=control_step)
    for a, b in zip(often, seldom, strict=True):
        count = min(len(a.time[::5]), len(b.time))
        assert count > 4
        for name in b.agents:
            for column in ("x", "y", "heading", "speed", "station", "progress", "contacts"):
                one = getattr(a.agents[name], column)[::5][:count]
                assert one.tobytes() == getattr(b.agents[name], column)[:count].tobytes(), column
        assert b.events[: len(a.events)] == a.events[: len(b.events)]


def test_an_agent_stands_in_every_sample_after_its_contact() -> None:
    scenes = records(CRASH, 3)
    for trace in drives(scenes, step=0.02, control_step=0.3):
        events = {event["agent"]: event["time"] for event in trace.events}
        assert {"ego", "other", "late"} <= set(events)
        for name, time in events.items():
            after = trace.time > time
            assert after.any()
            assert (trace.agents[name].contacts[after] >= 1.0).all()
            assert (trace.agents[name].contacts[trace.time < time] == 0.0).all()
            assert (trace.agents[name].speed[after] == 0.0).all()
            assert len(np.unique(trace.agents[name].x[after])) == 1


def test_compiled_it_drives_to_the_same_bytes(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("numba")
    scenes = [*records(LOOP, 2), *records(TRAFFIC, 2), *records(AROUND, 1)]
    monkeypatch.setattr(compiled, "is_installed", lambda: False)
    plain = [bytes_of(trace) for trace in drives(scenes)]
    monkeypatch.setattr(compiled, "is_installed", lambda: True)
    monkeypatch.setattr(compiled, "LOADING", 0.0)
    ran = []
    monkeypatch.setattr(
        compiled, "advance", lambda *a, original=compiled.advance: ran.append(original(*a))
    )
    assert [bytes_of(trace) for trace in drives(scenes)] == plain
    assert ran, "the compiled motion was used"


def test_compiled_it_finds_the_same_gaps_to_who_comes_from_elsewhere(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pytest.importorskip("numba")
    (scene,) = records(CROSSING, 1)
    seen: list[tuple[Any, Any]] = []
    looked: Any = corridors.nearest_in_corridor

    def both_ways(*pairs: Any) -> Any:
        monkeypatch.setattr(compiled, "is_loaded", lambda: False)
        plain = looked(*pairs)
        monkeypatch.setattr(compiled, "is_loaded", lambda: True)
        seen.append((plain, looked(*pairs)))
        return plain

    compiled.kernel()
    leaders = "roadlang.simulation.surroundings.leaders"
    monkeypatch.setattr(f"{leaders}.can_search", lambda world: False)  # as on hills
    monkeypatch.setattr(f"{leaders}.nearest_in_corridor", both_ways)
    drives([scene], duration=12.0)
    assert sum(np.isfinite(gap).sum() for (gap, _), _ in seen) > 50
    for plain, fast in seen:
        for one, other in zip(plain, fast, strict=True):
            assert one.tobytes() == other.tobytes()


def test_many_short_drives_load_the_compiled_motion_too(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("numba")
    monkeypatch.setattr(compiled, "_worked", [0.0])
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    answers = [compiled.pays(3000, 40) for _ in range(8)]
    assert not answers[0]
    assert answers[-1]


def test_tables_of_many_lines_are_compiled_where_numba_is_loaded(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(compiled, "_lines", [0])
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    monkeypatch.delitem(sys.modules, "numba", raising=False)
    assert not compiled.pays_for_lines(compiled.LINES + 1)
    monkeypatch.setattr(compiled, "_lines", [0])
    monkeypatch.setitem(sys.modules, "numba", np)
    assert not compiled.pays_for_lines(compiled.LINES)
    assert compiled.pays_for_lines(1)
