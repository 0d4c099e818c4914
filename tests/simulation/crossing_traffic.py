"""Cars at a junction, and what went wrong with them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roadlang.ir.scene import Scene, SceneActor
from roadlang.ir.trace import Trace
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.junctions.signal_lights import Lights
from roadlang.simulation.surroundings.crossed_junctions import crossings_of

from .routed_scenes import call, car, route


def entries(scene: Scene) -> list[tuple[str, int]]:
    """Roads into junctions from outside, with the lanes that lead there."""
    junctions = scene.networks[-1].junctions
    leaving = {
        (one.source.road, one.source.lane) for junction in junctions for one in junction.connections
    }
    inner = {
        arm.road
        for junction in junctions
        for other in junctions
        for arm in junction.arms
        if other is not junction and any(arm.road == each.road for each in other.arms)
    }
    return sorted((road, lane) for road, lane in leaving if road not in inner)


def before_junction(scene: Scene, road: str, lane: int, distance: float) -> float:
    """The station on a road, so many meters before the stop line of a lane."""
    found = next(one for one in scene.roads if one.name == road)
    end = next(
        one.source.end
        for junction in scene.networks[-1].junctions
        for one in junction.connections
        if (one.source.road, one.source.lane) == (road, lane)
    )
    return found.length - found.trim[1] - distance if end == "end" else found.trim[0] + distance


def turns_of(scene: Scene, road: str, lane: int) -> list[str]:
    """Where a lane leads at its junction."""
    found = {
        one.turn
        for junction in scene.networks[-1].junctions
        for one in junction.connections
        if (one.source.road, one.source.lane) == (road, lane)
    }
    return sorted(found)


def queues(scene: Scene, seed: int, cars: int = 4, **options: float) -> Scene:
    """The scene with cars in all lanes into its junction, that turn at random."""
    draw = np.random.default_rng(seed)
    agents: list[SceneActor] = []
    for road, lane in entries(scene):
        for number in range(cars):
            turn = str(draw.choice(turns_of(scene, road, lane)))
            distance = 15.0 + 14.0 * number + float(draw.uniform(0.0, 5.0))
            path = route(scene, road, lane, before_junction(scene, road, lane, distance), [turn])
            drives = call("traffic", speed_factor=float(draw.uniform(0.85, 1.15)), **options)
            speed = float(draw.uniform(0.0, 5.0))
            agents.append(car(scene, f"{road}.{lane}.{number}", path, drive=drives, speed=speed))
    return replace(scene, agents=tuple(agents))


def line_crossings(scene: Scene, trace: Trace) -> list[tuple[str, float, bool]]:
    """Name, time, and whether its light was red, of each front that passed a stop line."""
    world = world_of([scene], {}, 0.02, 0.1)
    crossings = crossings_of(world)
    lights = Lights.of(crossings.junctions)
    found = []
    for number, actor in enumerate(scene.agents):
        agent = trace.agents[actor.name]
        front = agent.progress * world.length[number] + 0.5 * actor.length
        for place, stop in enumerate(crossings.stop[number]):
            if not np.isfinite(stop) or front[0] > stop or front[-1] <= stop:
                continue
            time = float(np.interp(stop, front, agent.time))
            connection = lights.first[crossings.junction[number, place]]
            connection += crossings.connection[number, place]
            red = lights.is_red(np.array([connection]), np.array([time]))
            found.append((actor.name, time, bool(red[0])))
    return found


def contacts(trace: Trace) -> list[tuple[str, str]]:
    """Who touched whom."""
    return [(event["agent"], event["other"]) for event in trace.events]
