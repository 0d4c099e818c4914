"""Traffic at junctions by compiled loops: the same bytes as with numpy alone."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from roadlang.api import Scene
from roadlang.simulation import quiet_drives
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.controlling.driving import DriverGroup
from roadlang.simulation.recording import later_samples
from roadlang.simulation.state import along_routes, held_controls, settling
from roadlang.simulation.surroundings import leader_loops, near_pairs
from roadlang.simulation.surroundings.contacts import ContactDetector
from roadlang.simulation.surroundings.leaders import Pairing, leaders
from roadlang.simulation.traffic import looking, meeting_ways, oncoming, waiting
from roadlang.simulation.traffic.wide_places import WidePlaces
from roadlang.simulation.vehicles import compiled

from .test_same_bytes import CROSSING, bytes_of, drives, records

LOOPS = [
    *((module, "_loop") for module in (looking, waiting, held_controls, settling, quiet_drives)),
    (leader_loops, "_windows"),
    (leader_loops, "_nearest"),
    (meeting_ways, "_wide"),
    (meeting_ways, "_ways"),
    (meeting_ways, "_meetings"),
]
CONTROLS = {
    "right_first": "",
    "signals": "control with signals { green: 5s, yellow: 1s, all_red: 1s }",
    "all_way_stop": "control with all_way_stop",
    "roads": "",
}


def scenes_with(control: str, count: int = 2) -> list[Scene]:
    lanes = "lanes: 2, speed_limit: 40km/h"
    text = CROSSING.replace("lanes: 2", f"{lanes}\n{CONTROLS[control]}").replace("8,", "10,")
    return records(text, count)


@pytest.fixture
def both(monkeypatch: pytest.MonkeyPatch) -> Callable[[Callable[[], Any]], tuple[Any, Any]]:
    """What is computed with numpy alone, and with the compiled loops."""
    pytest.importorskip("numba")
    compiled.kernel()
    monkeypatch.setattr(quiet_drives, "STEPS", 0)

    def found(compute: Callable[[], Any]) -> tuple[Any, Any]:
        with monkeypatch.context() as patch:
            patch.setattr(compiled, "is_loaded", lambda: False)
            patch.setattr(compiled, "pays", lambda *_: False)
            plain = compute()
        return plain, compute()

    return found


@pytest.mark.parametrize("control", ["right_first", "signals", "all_way_stop"])
def test_traffic_drives_to_the_same_bytes(
    control: str, both: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    scenes, ran = scenes_with(control), set()
    monkeypatch.setattr(looking, "LOOKS", 0)
    for module, name in LOOPS:
        loop: Any = getattr(module, name)()

        def counted(*given: Any, which: Any = (module, name), loop: Any = loop) -> Any:
            ran.add(which)
            return loop(*given)

        monkeypatch.setattr(module, name, lambda counted=counted: counted)
    plain, fast = both(lambda: [bytes_of(trace) for trace in drives(scenes, duration=15.0)])
    assert fast == plain
    assert ran == set(LOOPS), "each of the loops was used"


def test_pairs_that_are_near_are_the_same(both: Any) -> None:
    world = world_of(scenes_with("roads", 3), {}, 0.02, 0.1)
    draw = np.random.default_rng(7)
    world.motion.speed = draw.uniform(0.0, 40.0, len(world.present))
    world.present = draw.uniform(size=len(world.present)) < 0.8
    pairing, poses = Pairing.of(world), world.poses
    plain, fast = both(
        lambda: near_pairs.near_pairs(world, poses, pairing.elsewhere, pairing.radius)
    )
    assert 20 < len(plain.agent) < pairing.elsewhere.sum()
    for name in ("agent", "target", "agents", "column"):
        np.testing.assert_array_equal(getattr(fast, name), getattr(plain, name))


RAMMING = """
road main { draw with segments { pieces: [straight(200m)] }, lanes: 2 }
agent slow is car on main at 60m { lane: -1, start_speed: 2m/s, drive with lane_follow }
agent fast is car on main at 10m..20m {
  lane: -1, start_speed: 15m/s, drive with lane_follow { speed: 15m/s }
}
agent beside is car on main at 10m { lane: 1, start_speed: 9m/s }
"""


def test_agents_that_touch_do_so_at_the_same_moment(both: Any) -> None:
    scenes = records(RAMMING, 2)
    plain, fast = both(lambda: drives(scenes, duration=8.0))
    assert all(trace.events for trace in plain)
    assert [bytes_of(trace) for trace in fast] == [bytes_of(trace) for trace in plain]


def test_places_and_limits_along_routes_are_the_same(both: Any) -> None:
    world = world_of(scenes_with("signals", 3), {}, 0.02, 0.1)
    table, rows = world.table, np.flatnonzero(world.has_route)
    draw = np.random.default_rng(3)
    along = draw.uniform(-10.0, 1.1, len(rows)) + draw.uniform(size=len(rows)) * world.length[rows]
    for braking, on in ((1.5, 0.0), (draw.uniform(1.0, 3.0, len(rows)), 12.0)):
        plain, fast = both(
            lambda braking=braking, on=on: np.stack(
                [
                    along_routes.stations(table, rows, along),
                    along_routes.limits_ahead(table, rows, along, braking, on),
                ]
            )
        )
        np.testing.assert_array_equal(fast, plain)
        assert len(np.unique(plain[0])) > 5


BUSES = """
image plan from \"\"\"
.#......#.
.########.
.#......#.
.########.
..........
\"\"\" { scale: 14m/px }
network town from plan { lanes: 2 }
agent buses is choice(bus, truck, car) on town at random {
  count: 12, route_length: 400m, drive with traffic
}
"""


def test_narrow_places_are_the_same(both: Any) -> None:
    world = world_of(records(BUSES, 2), {}, 0.02, 0.1)
    draw, wide, found = np.random.default_rng(5), WidePlaces.of(world), 0
    for _ in range(30):
        world.motion.along = draw.uniform(0.0, 1.0, len(world.present)) * world.length
        world.followed.lateral.offset = draw.choice([0.0, 0.0, -0.5], len(world.present))
        world.present = draw.uniform(size=len(world.present)) < 0.9
        poses = world.poses
        plain, fast = both(lambda poses=poses: meeting(oncoming._meeting(world, poses, wide)))
        assert fast == plain
        found += len(plain)
    assert found > 10


def meeting(found: Any) -> list[tuple[float, ...]]:
    """Pairs of agents and where they meet; those that may meet nowhere are left out."""
    if found is None:
        return []
    first, second, enter, leave = found
    pairs = np.stack([np.tile(first, 2), np.tile(second, 2), *enter, *leave])
    return sorted(map(tuple, pairs[:, np.isfinite(enter).all(axis=0)].T.tolist()))


def test_samples_that_are_computed_later_are_the_same(
    both: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    scenes, made = scenes_with("roads", 3), []
    columns_now = later_samples.columns_now

    def counted(world: Any, poses: Any) -> Any:
        made.append(len(world.scenes))
        return columns_now(world, poses)

    monkeypatch.setattr(later_samples, "columns_now", counted)
    plain, fast = both(lambda: [bytes_of(trace) for trace in drives(scenes, control_step=0.04)])
    assert fast == plain
    assert max(made) > 100, "many at once"
    monkeypatch.setattr(later_samples, "AT_ONCE", 1)
    assert (
        both(lambda: [bytes_of(trace) for trace in drives(scenes, control_step=0.04)])[1] == plain
    )


def test_who_is_next_ahead_is_the_same(both: Any) -> None:
    scenes = scenes_with("roads", 3)
    world = world_of(scenes, {}, 0.02, 0.1)
    draw = np.random.default_rng(11)
    world.motion.speed = draw.uniform(0.0, 40.0, len(world.present))
    world.motion.along = draw.uniform(0.0, 0.7, len(world.present)) * world.length
    world.followed.lateral.offset = draw.choice([0.0, 0.0, -1.0, 2.5], len(world.present))
    world.present = draw.uniform(size=len(world.present)) < 0.9
    pairing, poses = Pairing.of(world), world.poses
    plain, fast = both(lambda: leaders(world, poses, pairing))
    there = np.isfinite(plain.gaps)
    assert 5 < there.sum() < there.size / 2
    for name in ("gap", "speed", "acceleration", "gaps"):
        np.testing.assert_array_equal(getattr(fast, name), getattr(plain, name))
    np.testing.assert_array_equal(fast.turned[there], plain.turned[there])


PASSING = """
road main { draw with segments { pieces: [straight(300m)] }, lanes: 2, width: 7m }
agent one is car on main at 10m {
  lane: -1, start_speed: 10m/s, drive with traffic { speed: 10m/s }
}
agent two is car on main at 200m..220m {
  lane: 1, start_speed: 10m/s, drive with traffic { speed: 10m/s }
}
"""


def test_what_a_decision_holds_for_is_driven_at_once(
    both: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where two pass each other, closer than the circles around them."""
    scenes, done = records(PASSING, 2), {"watch": 0, "held": 0}
    for owner, name in ((ContactDetector, "watch"), (DriverGroup, "held")):
        made = getattr(owner, name)

        def counted(*given: Any, name: str = name, made: Any = made) -> Any:
            done[name] += 1
            return made(*given)

        monkeypatch.setattr(owner, name, counted)

    def driven() -> Any:
        done.update(watch=0, held=0)
        return [
            bytes_of(trace) for trace in drives(scenes, duration=12.0, control_step=0.04)
        ], dict(done)

    (plain, singly), (fast, at_once) = both(driven)
    assert fast == plain
    assert singly == {"watch": 301, "held": 300}
    assert at_once == {"watch": 1, "held": 100}
