"""Loss, doubles, reordering and corruption, both ways: the scene is built whole, and once."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.line import polyline
from roadlang_godot.build.road_mesh import road_parts
from roadlang_godot.engines.engine import Engine, connect
from tests.godot.godot_proxy import Proxy, Weather
from tests.godot.godot_scenes import bend, pieces, straight

pytestmark = pytest.mark.godot

STORM = Weather(loss=0.3, double=0.15, reorder=0.2, corrupt=0.05)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_stormy_network_delivers_the_scene_whole_and_once(fast_engine: Engine, seed: int) -> None:
    line = polyline("main", pieces(straight(2000), bend(200, 150), straight(2000)), 7.0)
    things = road_parts(line, 1, SceneOrigin())
    with (
        Proxy(fast_engine.host, fast_engine.port, STORM, seed) as proxy,
        connect(fast_engine.host, proxy.port) as session,
    ):
        session.begin({"name": "storm", "extent": 5000.0}, clear=True)
        session.update(things)
        proof = session.prove()
    assert proof.parts == proof.builds == len(things)


def test_a_drive_over_a_stormy_network_has_every_record(fast_engine: Engine) -> None:
    from roadlang_godot.drive.simulate import Settings, drive_in
    from tests.godot.godot_scenes import call, car, road, scene

    main = road("main", pieces(straight(150)))
    made = scene(main, agents=[car("ego", main, 5.0, call("lane_follow", speed=12.0))])
    with (
        Proxy(fast_engine.host, fast_engine.port, STORM, 4) as proxy,
        connect(fast_engine.host, proxy.port) as session,
    ):
        trace = drive_in(session, made, Settings(duration=5.0), {})
    assert np.diff(trace.time) == pytest.approx(0.02)
    assert trace.time[-1] == pytest.approx(5.0)
