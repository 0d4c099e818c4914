"""`drive with traffic`: nobody collides, nobody runs a red light, and everybody gets on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang.ir.scene import Scene, SceneActor
from roadlang.ir.scene_route import RouteStep, SceneRoute

from .crossing_traffic import (
    before_junction,
    contacts,
    entries,
    line_crossings,
    queues,
    turns_of,
)
from .routed_scenes import CROSSING, TEE, call, car, drive_scenes, network_scene, route
from .test_same_bytes import bytes_of

RULES = {
    "right_first": "",
    "signals": "control with signals { green: 8s }",
    "all_way_stop": "control with all_way_stop",
    "yield": "control with yield",
    "stop": "control with stop",
}


def scene_with(rule: str, plan: str = CROSSING, lanes: int = 2, world: str = "") -> Scene:
    options = f"lanes: {lanes}, speed_limit: 50km/h\n{RULES[rule]}"
    return network_scene(plan, options, cell=f"{4 * lanes}m/px", world=world)


def test_queues_get_through_without_contact_or_red_lights() -> None:
    """At four arms and three, under all rules, all in one block."""
    empty = [(rule, scene_with(rule, plan)) for rule in RULES for plan in (CROSSING, TEE)]
    cases = [(rule, queues(scene, seed)) for seed, (rule, scene) in enumerate(empty)]
    traces = drive_scenes([scene for _, scene in cases], duration=70.0)
    for (rule, scene), trace in zip(cases, traces, strict=True):
        assert contacts(trace) == [], rule
        passed = line_crossings(scene, trace)
        assert not [name for name, _, red in passed if red], rule
        assert len(passed) >= 0.9 * len(scene.agents), rule


@pytest.mark.slow
@pytest.mark.parametrize("rule", RULES)
def test_queues_in_several_lanes_get_through(rule: str) -> None:
    empty = scene_with(rule, lanes=4)
    scene = queues(empty, 0)
    (trace,) = drive_scenes([scene], duration=90.0)
    assert contacts(trace) == []
    passed = line_crossings(scene, trace)
    assert not [name for name, _, red in passed if red]
    assert len(passed) >= 0.9 * len(scene.agents)


def lone_car(scene: Scene, distance: float, begins: float, **options: float) -> Scene:
    """One car before the junction, straight on."""
    road, lane = entries(scene)[0]
    path = route(scene, road, lane, before_junction(scene, road, lane, distance), ["straight"])
    return replace(
        scene, agents=(car(scene, "ego", path, drive=call("traffic", **options), speed=begins),)
    )


@pytest.mark.parametrize("yellow", [0.0, 1.0, 4.0])
def test_nobody_crosses_at_red_whenever_the_light_changes(yellow: float) -> None:
    control = f"control with signals {{ green: 6s, yellow: {yellow}s, all_red: 1s }}"
    empty = network_scene(CROSSING, f"lanes: 2, speed_limit: 60km/h\n{control}")
    scenes = [lone_car(empty, distance, 16.0) for distance in np.linspace(20.0, 100.0, 9)]
    for scene, trace in zip(scenes, drive_scenes(scenes, duration=40.0), strict=True):
        ((_, _, red),) = line_crossings(scene, trace)
        assert not red
        assert trace.agents["ego"].acceleration.min() > -8.5


def test_a_car_with_the_road_to_itself_does_not_slow_down_at_a_junction() -> None:
    (trace,) = drive_scenes([lone_car(scene_with("yield"), 80.0, 12.0)], duration=8.0)
    assert trace.agents["ego"].speed[5:].min() > 11.5


def test_at_a_stop_sign_cars_stop_even_if_nobody_comes() -> None:
    scene = scene_with("stop")
    minor = scene.networks[-1].junctions[0].control.minor
    road, lane = next(one for one in entries(scene) if one[0] in minor)
    path = route(scene, road, lane, before_junction(scene, road, lane, 50.0), ["straight"])
    one = replace(scene, agents=(car(scene, "ego", path, drive=call("traffic"), speed=8.0),))
    (trace,) = drive_scenes([one], duration=30.0)
    ego = trace.agents["ego"]
    ((_, time, _),) = line_crossings(one, trace)
    before = (ego.time > time - 4.0) & (ego.time < time)
    assert ego.speed[before].min() < 0.3


@pytest.mark.parametrize("rule", ["right_first", "yield"])
def test_who_yields_lets_pass_who_comes_at_nearly_the_same_time(rule: str) -> None:
    scene = scene_with(rule)
    junction = scene.networks[-1].junctions[0]
    straight = {one.id: one.source for one in junction.connections if one.turn == "straight"}
    first, second = next(pair for pair in junction.yields if set(pair) <= set(straight))
    agents = []
    for name, id, distance in (("yields", first, 30.0), ("passes", second, 31.0)):
        road, lane = straight[id].road, straight[id].lane
        path = route(scene, road, lane, before_junction(scene, road, lane, distance), ["straight"])
        agents.append(car(scene, name, path, drive=call("traffic", speed=10.0), speed=10.0))
    one = replace(scene, agents=tuple(agents))
    (trace,) = drive_scenes([one], duration=20.0)
    order = sorted(line_crossings(one, trace), key=lambda row: row[1])
    assert [name for name, _, _ in order] == ["passes", "yields"]
    assert contacts(trace) == []


def test_who_came_first_goes_first_where_all_have_to_stop() -> None:
    scene = scene_with("all_way_stop")
    agents = []
    for number, (road, lane) in enumerate(entries(scene)):
        distance = 20.0 + 12.0 * number
        path = route(scene, road, lane, before_junction(scene, road, lane, distance), ["straight"])
        agents.append(car(scene, f"car{number}", path, drive=call("traffic"), speed=5.0))
    one = replace(scene, agents=tuple(agents))
    (trace,) = drive_scenes([one], duration=40.0)
    passed = sorted(line_crossings(one, trace), key=lambda row: row[1])
    assert [name for name, _, _ in passed] == ["car0", "car1", "car2", "car3"]


def test_four_that_wait_for_the_right_do_not_wait_forever() -> None:
    scene = scene_with("right_first")
    agents = []
    for number, (road, lane) in enumerate(entries(scene)):
        path = route(scene, road, lane, before_junction(scene, road, lane, 20.0), ["straight"])
        agents.append(car(scene, f"car{number}", path, drive=call("traffic"), speed=5.0))
    one = replace(scene, agents=tuple(agents))
    (trace,) = drive_scenes([one], duration=30.0)
    assert len(line_crossings(one, trace)) == 4
    assert contacts(trace) == []


def test_cars_let_one_pass_that_runs_a_red_light() -> None:
    scene = scene_with("signals")
    rows = entries(scene)
    agents = []
    for number, (road, lane) in enumerate(rows):
        path = route(scene, road, lane, before_junction(scene, road, lane, 45.0), ["straight"])
        runs = number == 0
        drives = call("lane_follow", speed=12.0) if runs else call("traffic")
        agents.append(car(scene, f"car{number}", path, drive=drives, speed=12.0))
    offsets = np.arange(0.0, 20.0, 4.0)
    scenes = [_offset(replace(scene, agents=tuple(agents)), offset) for offset in offsets]
    red_lights = 0
    for one, trace in zip(scenes, drive_scenes(scenes, duration=20.0), strict=True):
        assert contacts(trace) == []
        red_lights += sum(red for name, _, red in line_crossings(one, trace) if name == "car0")
        assert not [name for name, _, red in line_crossings(one, trace) if red and name != "car0"]
    assert red_lights >= 2


def _offset(scene: Scene, seconds: float) -> Scene:
    """With signals that began so long ago."""
    network = scene.networks[-1]
    junctions = tuple(
        replace(one, control=replace(one.control, offset=seconds)) for one in network.junctions
    )
    return replace(scene, networks=(replace(network, junctions=junctions),))


def test_a_car_without_a_route_obeys_the_signals_of_the_roads_that_it_crosses() -> None:
    text = "road main from town { select: longest }"
    signals = "lanes: 2, speed_limit: 50km/h\n" + RULES["signals"]
    scene = network_scene(CROSSING, signals, network=text)
    main = next(road for road in scene.roads if road.name == "main")
    offset = float(main.cross_section().offset(-1, 60.0))
    x, y, heading = (
        float(np.interp(60.0, main.stations, c)) for c in (main.x, main.y, main.heading)
    )
    path = route(scene, *entries(scene)[0], before_junction(scene, *entries(scene)[0], 40.0), [])
    ego = replace(
        car(scene, "ego", path, drive=call("traffic"), speed=10.0),
        road="main", start=60.0, lane=-1, offset=offset, route=None, facing="forward",
        x=x - np.sin(heading) * offset, y=y + np.cos(heading) * offset, heading=heading,
    )  # fmt: skip
    scenes = [_offset(replace(scene, agents=(ego,)), float(offset)) for offset in range(0, 26, 5)]
    waits = 0
    for one, trace in zip(scenes, drive_scenes(scenes, duration=40.0), strict=True):
        ((_, _, red),) = line_crossings(one, trace)
        assert not red
        waits += bool(trace.agents["ego"].speed[10:].min() < 0.1)
    assert 1 <= waits < len(scenes)


def test_a_route_that_ends_at_a_junction_ends_with_the_front_at_its_line() -> None:
    scene = scene_with("right_first")
    road, lane = entries(scene)[0]
    path = route(scene, road, lane, before_junction(scene, road, lane, 60.0), [])
    one = replace(scene, agents=(car(scene, "ego", path, drive=call("traffic"), speed=8.0),))
    (trace,) = drive_scenes([one], duration=30.0)
    ego = trace.agents["ego"]
    assert ego.present.tolist() == [1.0] * (len(ego.time) - 1) + [0.0]
    assert 58.0 < ego.route_progress[-2] + 2.25 < 60.0


def test_a_queue_waits_where_the_lane_beyond_the_junction_is_full() -> None:
    """Nobody stops on the junction."""
    scene = scene_with("yield")
    major = [one for one in entries(scene) if one[0] not in _minor(scene)]
    road, lane = major[0]
    long = route(scene, road, lane, before_junction(scene, road, lane, 20.0), ["straight"])
    step = long.steps[1]
    way = 1.0 if step.stop > step.start else -1.0
    ahead = replace(long, steps=(replace(step, start=step.start + 6.0 * way),))
    blocker = car(scene, "blocker", ahead, drive=call("brake"))
    one = replace(scene, agents=(car(scene, "ego", long, drive=call("traffic")), blocker))
    (trace,) = drive_scenes([one], duration=20.0)
    assert line_crossings(one, trace) == []


def _minor(scene: Scene) -> tuple[str, ...]:
    return scene.networks[-1].junctions[0].control.minor


def test_an_object_in_the_lane_stops_cars_and_one_beside_it_does_not() -> None:
    scene = scene_with("right_first")
    road, lane = entries(scene)[0]
    path = route(scene, road, lane, before_junction(scene, road, lane, 80.0), [turn_of(scene)])
    waits = call("traffic", go_around=False)
    ego = car(scene, "ego", path, drive=waits, speed=8.0)
    for aside, stops in ((0.0, True), (2.6, False)):
        thing = car(scene, "thing", replace(path, steps=(path.steps[0],)))
        heading = thing.heading
        thing = replace(
            thing, drive=(), route=None, road=None,
            x=thing.x + 40.0 * np.cos(heading) + aside * np.sin(heading),
            y=thing.y + 40.0 * np.sin(heading) - aside * np.cos(heading),
        )  # fmt: skip
        one = replace(scene, agents=(ego,), objects=(thing,))
        (trace,) = drive_scenes([one], duration=15.0)
        assert contacts(trace) == []
        assert bool(trace.agents["ego"].speed[-1] < 0.1) is stops


def turn_of(scene: Scene) -> str:
    return turns_of(scene, *entries(scene)[0])[0]


def test_the_options_do_what_they_say() -> None:
    """A longer headway keeps a longer gap; a factor scales the limit; who is bold is off sooner."""
    empty = scene_with("right_first")

    def driven(duration: float = 6.0, **options: float) -> tuple[np.ndarray, np.ndarray]:
        scene = lone_car(empty, 110.0, 0.0, **options)
        (trace,) = drive_scenes([scene], duration=duration)
        return trace.agents["ego"].speed, trace.agents["ego"].progress

    assert driven(aggression=1.0)[0][20] > driven(aggression=0.0)[0][20] + 1.0
    assert driven(speed=5.0)[0].max() == pytest.approx(5.0, abs=0.2)
    assert driven(duration=9.0, speed_factor=0.5)[0].max() == pytest.approx(25 / 3.6, abs=0.2)

    road, lane = entries(empty)[0]
    gaps = []
    for headway in (0.8, 2.0):
        agents = []
        for name, distance, speed in (("ego", 100.0, 14.0), ("slow", 70.0, 5.0)):
            start = before_junction(empty, road, lane, distance)
            path = route(empty, road, lane, start, ["straight"])
            options = {"headway": headway} if name == "ego" else {"speed": speed}
            agents.append(car(empty, name, path, drive=call("traffic", **options), speed=5.0))
        (trace,) = drive_scenes([replace(empty, agents=tuple(agents))], duration=14.0)
        ego, slow = trace.agents["ego"], trace.agents["slow"]
        gaps.append(np.hypot(ego.x[-1] - slow.x[-1], ego.y[-1] - slow.y[-1]) - 4.5)
    assert gaps[0] == pytest.approx(2.0 + 0.8 * 5.0, abs=0.6)
    assert gaps[1] == pytest.approx(2.0 + 2.0 * 5.0, abs=0.6)


def test_traffic_alone_is_its_row_of_a_block() -> None:
    scenes = [queues(scene_with(rule), seed, cars=2) for seed, rule in enumerate(RULES)]
    together = drive_scenes(scenes, duration=12.0)
    for scene, trace in list(zip(scenes, together, strict=True))[::2]:
        (alone,) = drive_scenes([scene], duration=12.0)
        assert bytes_of(alone) == bytes_of(trace)


@pytest.mark.parametrize("apart", [-1.0, 0.0, 1.0])
def test_two_that_change_to_each_others_lane_side_by_side_do_not_touch(apart: float) -> None:
    scene = scene_with("right_first", lanes=4)
    road = next(one for one in scene.roads if one.name == entries(scene)[0][0])
    low, high = road.trim[0] + 10.0, road.length - road.trim[1]
    middle = low + 70.0
    agents = []
    for name, first, second, begin in (("one", -1, -2, low), ("other", -2, -1, low + apart)):
        steps = (
            RouteStep(road.name, first, begin, middle),
            RouteStep(road.name, second, middle, high),
        )
        drives = call("traffic")
        agents.append(car(scene, name, SceneRoute(steps), drive=drives, speed=12.0))
    (trace,) = drive_scenes([replace(scene, agents=tuple(agents))], duration=20.0)
    assert contacts(trace) == []
    assert min(agent.progress[-1] for agent in trace.agents.values()) > 0.9


def test_left_hand_traffic_drives_as_the_mirror_image_of_right_hand_traffic() -> None:
    """Under all rules."""
    arm = "." * 12 + "#" + "." * 17
    plan = "\n".join([arm] * 14 + ["#" * 30] + [arm] * 9)
    other = "\n".join(row[::-1] for row in plan.splitlines())
    scenes = []
    for rule in RULES:
        right = scene_with(rule, plan)
        left = scene_with(rule, other, world="traffic: left")
        agents, images = [], []
        for number, (road, lane) in enumerate(entries(right)):
            for turn, distance in (("left", 20.0), ("right", 34.0), ("straight", 48.0)):
                start = before_junction(right, road, lane, distance + number)
                path = route(right, road, lane, start, [turn])
                agents.append(car(right, f"{number}.{turn}", path, drive=call("traffic")))
                images.append(image_of(agents[-1], turn, distance + number, left, 30 * 8.0))
        scenes += [replace(right, agents=tuple(agents)), replace(left, agents=tuple(images))]
    traces = drive_scenes(scenes, duration=15.0)
    for rule, trace, mirrored in zip(RULES, traces[::2], traces[1::2], strict=True):
        for name, one in trace.agents.items():
            image = mirrored.agents[name]
            assert np.abs(one.x + image.x - 30 * 8.0).max() < 1e-9, rule
            assert np.abs(one.y - image.y).max() < 1e-9, rule


def image_of(
    agent: SceneActor, turn: str, distance: float, scene: Scene, width: float
) -> SceneActor:
    """The agent at the mirrored place, with the mirrored turn."""
    opposite = {"left": "right", "right": "left"}.get(turn, turn)
    found = []
    for road, lane in entries(scene):
        start = before_junction(scene, road, lane, distance)
        path = route(scene, road, lane, start, [opposite])
        one = car(scene, agent.name, path, drive=agent.drive)
        found.append((abs(one.x + agent.x - width) + abs(one.y - agent.y), one))
    away, image = min(found, key=lambda pair: pair[0])
    assert away < 1e-6
    return image
