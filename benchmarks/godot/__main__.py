"""Measures the engine against its bars: `python -m benchmarks.godot [NAME ...]`.

Needs a Godot engine; prints one line a bar. Numbers depend on what else the machine does.
"""

from __future__ import annotations

import hashlib
import math
import statistics
import sys
import time
from collections.abc import Callable

import numpy as np

from benchmarks.godot.drags import drags
from benchmarks.godot.lockstep import lockstep
from benchmarks.godot.window_drags import window_drags
from roadlang.api import Scene
from roadlang_godot.build.frame import SceneOrigin
from roadlang_godot.build.layout import layout_of
from roadlang_godot.build.line import polyline
from roadlang_godot.build.road_mesh import road_parts
from roadlang_godot.drive import driving
from roadlang_godot.drive.simulate import Settings, drive_in
from roadlang_godot.engines import engine
from roadlang_godot.net.session import Session
from tests.godot.godot_proxy import Proxy, Weather
from tests.godot.godot_scenes import bend, bends, call, car, pieces, road, scene, straight
from tests.godot.test_live_editing import raised


def long_road() -> None:
    """100 km of road, sent, built and proven."""
    x = np.arange(0, 100_001, 20.0)
    line = polyline("long", np.stack([x, 60 * np.sin(x / 150)], axis=-1), 7.0)
    things = road_parts(line, 1, SceneOrigin(50_000.0, 0.0))
    for transport in ("udp", "websocket"):
        with engine.start(transport=transport) as running, running.connect() as session:
            session.begin({"name": "long", "extent": 50_000.0}, clear=True)
            began = time.monotonic()
            session.update(things)
            acknowledged = time.monotonic() - began
            session.prove()
            proven = time.monotonic() - began
        rate = len(things) / acknowledged
        print(f"{transport}: {len(things)} segments of 100 m: {rate:,.0f}/s", end="; ")
        print(f"{line.length / 1000:.0f} km proven built in {proven:.2f} s")


def storms() -> None:
    """Scenes through 30 % loss both ways, doubles, reordering and corruption."""
    line = polyline("main", pieces(straight(2000), bend(200, 150), straight(2000)), 7.0)
    things = road_parts(line, 1, SceneOrigin())
    weather = Weather(loss=0.3, double=0.15, reorder=0.2, corrupt=0.05)
    whole, runs = 0, 20
    with engine.start() as running:
        for seed in range(runs):
            with (
                Proxy(running.host, running.port, weather, seed) as proxy,
                engine.connect(running.host, proxy.port, patience=20.0) as session,
            ):
                session.begin({"name": "storm", "extent": 5000.0}, clear=True)
                session.update(things)
                proof = session.prove()
                whole += proof.parts == proof.builds == len(things)
    print(f"storms: {whole} of {runs} scenes digest-equal, nothing built twice")


def live_edits() -> None:
    """From sending an edit to its effect in physics, in real time."""
    took = []
    with engine.start() as running, running.connect() as session:
        session.begin({"name": "live", "extent": 200.0}, clear=True)
        session.update([raised(0.0)])
        for turn in range(1, 301):
            height = 0.1 * (turn % 40) + 0.1
            began = time.monotonic()
            session.update([raised(height)])
            while abs((session.probe(50.0, 0.0) or 0.0) - height) > 1e-3:
                pass
            took.append(1000 * (time.monotonic() - began))
            time.sleep(0.003 * (turn % 7))
    p95 = statistics.quantiles(took, n=20)[-1]
    print(
        f"live edit to physical effect: median {statistics.median(took):.1f} ms, p95 {p95:.1f} ms"
    )


def speed() -> None:
    """Simulated seconds a second: one car and fifty in the engine, one in lock-step."""
    bent = bends()
    ego = car("ego", bent, 5.0, call("pure_pursuit", speed=13.0, lookahead=6.0))
    crowd = [
        car(f"car[{i}]", bent, 5.0 + 9.0 * i, call("lane_follow", speed=9.0)) for i in range(50)
    ]
    with engine.start(fixed_fps=60) as running, running.connect() as session:
        for name, agents in (("1 car", [ego]), ("50 cars", crowd)):
            _build(session, scene(bent, agents=agents))
            began = time.monotonic()
            ticks = driving.run(session, 60 * 50).ticks
            rate = len(agents) * ticks / 60 / (time.monotonic() - began)
            print(f"{name}: {rate:.0f} car-seconds per second")
        _build(session, scene(bent, agents=[ego]))
        with driving.LockStep(session) as lock:
            began = time.monotonic()
            while lock.tick < 60 * 40:
                speed_now = float(lock.state.poses["speed"][0])
                lock.step({1: driving.EngineControl.steer(0.0, 2.0 * (8.0 - speed_now))})
            print(f"lock-step from Python: {40 / (time.monotonic() - began):.0f} s per second")


def repeats() -> None:
    """Digests of the telemetry of repeated drives, in one engine and in a fresh one."""
    bent = bends()
    cars = [car(f"car[{i}]", bent, 5.0 + 9.0 * i, call("car_follow", speed=12.0)) for i in range(5)]
    digests = []
    for _ in range(2):
        with engine.start(fixed_fps=60) as running, running.connect() as session:
            for _ in range(2):
                _build(session, scene(bent, agents=cars))
                trace = driving.run(session, 60 * 30).trace
                digests.append(hashlib.sha256(trace.tobytes()).hexdigest())
    print(f"repeats: {len(set(digests))} digest in {len(digests)} drives of 2 engines")


def grip() -> None:
    """Cross-track error at 15 m/s on bends of 37 m; the speed at which a car slides out."""
    bent = bends()
    with engine.start(fixed_fps=60) as running, running.connect() as session:
        for kind in ("pure_pursuit", "stanley", "lane_follow", "car_follow"):
            pursuit = call(kind, speed=15.0, lookahead=1.0, lookahead_time=0.4)
            chosen = pursuit if kind == "pure_pursuit" else call(kind, speed=15.0)
            ego = car("ego", bent, 5.0, chosen)
            trace = drive_in(session, scene(bent, agents=[ego]), Settings(duration=80), {})
            worst = np.abs(trace.agents["ego"].cross_track_error).max()
            print(f"{kind} at 15 m/s, R 37 m: cross-track error {worst:.2f} m")
        for friction in (0.5, 0.9, 1.2):
            ring = road("ring", pieces(straight(220), bend(60, 350)), width=9.0)
            limit = math.sqrt(friction * 9.81 * 60)
            for share in np.arange(0.85, 1.21, 0.025):
                fast = call("pure_pursuit", speed=share * limit, lookahead=1.0, lookahead_time=0.4)
                made = scene(
                    ring, agents=[car("ego", ring, 3.0, fast)], world={"friction": friction}
                )
                ego_trace = drive_in(session, made, Settings(duration=45), {}).agents["ego"]
                if np.abs(ego_trace.cross_track_error).max() > 3.0:
                    break
            print(f"friction {friction}: slides out at {share:.3f} of sqrt(mu g R)")


def _build(session: Session, made: Scene) -> None:
    layout = layout_of(made)
    session.begin(layout.settings(), clear=True)
    session.update(layout.parts)
    session.prove()


BARS: dict[str, Callable[[], None]] = {
    one.__name__: one
    for one in (long_road, storms, live_edits, drags, window_drags, speed, lockstep, repeats, grip)
}

if __name__ == "__main__":
    for wanted in sys.argv[1:] or BARS:
        BARS[wanted]()
