"""Signals over time: the engine sees the colors that `SceneControl.light` tells."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from roadlang.ir.scene_junctions import SceneControl, SceneJunction, SignalPhase
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.junctions.signal_lights import Lights

from .crossing_traffic import before_junction, entries
from .routed_scenes import CROSSING, car, network_scene, route

CROSSED = network_scene(CROSSING, "lanes: 2\ncontrol with signals { green: 6s }")
JUNCTION: SceneJunction = CROSSED.networks[-1].junctions[0]
IDS = [one.id for one in JUNCTION.connections]
SECONDS = st.sampled_from([0.0, 0.1, 0.2, 0.3, 1.0, 7.0]) | st.floats(0.0, 60.0)
PHASE = st.builds(
    SignalPhase, st.lists(st.sampled_from(IDS), unique=True).map(tuple), SECONDS, SECONDS, SECONDS
)
CONTROL = st.builds(
    SceneControl, st.just("signals"), st.just(()),
    st.lists(PHASE, min_size=1, max_size=4).map(tuple), SECONDS,
)  # fmt: skip


def edges(control: SceneControl) -> list[float]:
    """Where colors change, and one floating-point number before and after."""
    at = [time - control.offset for row in control.changes for time in row]
    return [float(near) for time in at for near in (np.nextafter(time, -1e9), time, time + 1e-12)]


@given(st.lists(CONTROL, min_size=1, max_size=3), st.data())
def test_the_engine_sees_what_the_scene_says_at_any_time(
    controls: list[SceneControl], data: Any
) -> None:
    lights = Lights.of([replace(JUNCTION, control=control) for control in controls])
    for number, control in enumerate(controls):
        known = st.sampled_from(edges(control)) | st.floats(0.0, 200.0)
        times = data.draw(st.lists(known, min_size=1, max_size=8))
        if control.cycle == 0.0:
            continue
        rows = np.repeat(lights.first[number] + np.arange(len(IDS)), len(times))
        green, to_red = lights.at(rows, np.tile(times, len(IDS)))
        colors = [control.light(id, time) for id in IDS for time in times]
        assert green.tolist() == [color == "green" for color in colors]
        assert (to_red > 0.0).tolist() == [color != "red" for color in colors]
        assert lights.is_red(rows, np.tile(times, len(IDS))).tolist() == [
            color == "red" for color in colors
        ]


def test_where_there_are_no_signals_nothing_is_red() -> None:
    lights = Lights.of([replace(JUNCTION, control=SceneControl("stop"))])
    assert not lights.is_red(np.arange(len(IDS)), np.array([0.0])).any()
    scene = network_scene(CROSSING, "lanes: 2\ncontrol with stop")
    road, lane = entries(scene)[0]
    path = route(scene, road, lane, before_junction(scene, road, lane, 40.0), ["straight"])
    world = world_of([replace(scene, agents=(car(scene, "ego", path),))], {}, 0.02, 0.1)
    assert world.stop_lines.is_empty
