"""Who is next ahead on one road, found in the order of stations, and contacts of pairs that are
looked at only when they can have come near: the same as of all pairs at every step."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.state.world import World
from roadlang.simulation.surroundings import close_pairs
from roadlang.simulation.surroundings import leaders as leaders_module
from roadlang.simulation.surroundings.contacts import ContactDetector
from roadlang.simulation.surroundings.leaders import Leaders, Pairing, leaders
from roadlang.simulation.vehicles import compiled
from roadlang.simulation.vehicles.poses import Poses

from .test_same_bytes import records

ROW = """
road main { draw with segments { pieces: [straight(200m)] }, width: 8m, lanes: 2 }
agent cars is choice(car, truck, motorcycle, bus) on main at random { count: 9, lane: -1 }
"""
ONCOMING = ROW + "agent other is car on main at random { lane: 1 }\n"


def world_in_disorder(text: str, seed: int) -> World:
    """Some of its agents are beside each other, some turned, some gone."""
    world = world_of(records(text, 12), {}, 0.02, 0.1)
    random, count = np.random.default_rng(seed), len(world.present)
    motion = world.motion
    motion.along = np.where(random.uniform(size=count) < 0.3, motion.along.round(-1), motion.along)
    motion.speed = random.uniform(0.0, 20.0, count)
    motion.acceleration = random.uniform(-3.0, 3.0, count)
    motion.offset = motion.offset + random.normal(0.0, 1.0, count)
    if seed % 2:
        motion.sine = random.uniform(-0.2, 0.2, count)
        world.present = world.present & (random.uniform(size=count) > 0.1)
    return world


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("text", [ROW, ONCOMING], ids=["row", "oncoming"])
def test_who_is_next_is_the_same_as_among_all_gaps(
    text: str, seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    world = world_in_disorder(text, seed)
    pairing = Pairing.of(world)
    assert pairing.one_way == (text == ROW)

    def found(many: int) -> tuple[bytes, ...]:
        monkeypatch.setattr(leaders_module, "MANY", many)
        each: Leaders = leaders(world, world.poses, pairing)
        columns = each.gap, each.speed, each.acceleration, each.gaps, each.turned
        return tuple(column.tobytes() for column in columns)

    assert found(0) == found(10**9)


def test_gaps_are_those_of_when_they_were_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    monkeypatch.setattr(leaders_module, "MANY", 0)
    world = world_in_disorder(ROW, 3)
    pairing = Pairing.of(world)
    before = leaders(world, world.poses, pairing).gaps
    later = leaders(world, world.poses, pairing)
    target = np.full(len(world.present), 3.0)
    assert world.followed.move(target, None, world.motion.along, world.motion.speed)
    assert later.gaps.tobytes() == before.tobytes()
    assert leaders(world, world.poses, pairing).gaps.tobytes() != before.tobytes()


def contacts(world: World, always: bool) -> list[Any]:
    """Those of agents that are moved about at random, where pairs are looked at always or not."""
    detector = ContactDetector(world)
    random, found, poses = np.random.default_rng(7), [], world.poses
    x, y = poses.x.copy(), poses.y.copy()
    for step in range(150):
        if always:
            detector._pairs.restart(np.arange(len(x)))
        moved = random.normal(0.0, 0.4, (2, len(x))) * ~world.halted
        x, y = x + moved[0], y + moved[1] + 0.02 * step * (np.arange(len(x)) % 2)
        now = replace(poses, x=x, y=y)
        found += detector.watch(world, now, 0.1)
        if step % 40 == 39:  # a scene begins again
            again = np.arange(world.slots)
            world.restart(again)
            x[again], y[again] = poses.x[again], poses.y[again]
            detector.restart(again, replace(poses, x=x.copy(), y=y.copy()))
    return found


@pytest.mark.parametrize("few", [0, 10**9], ids=["many", "few"])
@pytest.mark.parametrize("fast", [False, True], ids=["numpy", "numba"])
def test_contacts_are_found_though_pairs_are_not_always_looked_at(
    few: int, fast: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if fast:
        pytest.importorskip("numba")
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    scenes = records(ROW, 12)
    always = contacts(world_of(scenes, {}, 0.02, 0.1), True)
    monkeypatch.setattr(compiled, "is_loaded", lambda: fast)
    monkeypatch.setattr(close_pairs, "FEW", few)
    often = contacts(world_of(scenes, {}, 0.02, 0.1), False)
    assert often == always
    assert len(often) > 10


@pytest.mark.parametrize("few", [0, 10**9], ids=["many", "few"])
@pytest.mark.parametrize("fast", [False, True], ids=["numpy", "numba"])
def test_pairs_that_are_far_apart_are_not_looked_at(
    few: int, fast: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if fast:
        pytest.importorskip("numba")
    monkeypatch.setattr(compiled, "is_loaded", lambda: fast)
    monkeypatch.setattr(close_pairs, "FEW", few)
    pairs = close_pairs.ClosePairs((np.array([0]), np.array([1])), np.array([2.0, 2.0]))
    road_width = heading = np.zeros(2)

    def met(x: float, meters: float) -> int:
        poses = Poses(np.array([0.0, x]), np.zeros(2), heading, road_width)
        there = np.ones(2, dtype=bool)
        return len(pairs.met(poses, np.array([meters, meters]) ** 2, there, ~there))

    assert met(104.0, 1.0) == 0  # both may go 50 m until they touch
    assert met(3.0, 5.0) == 0  # too soon to be looked at
    assert met(3.0, 25.0) == 1
