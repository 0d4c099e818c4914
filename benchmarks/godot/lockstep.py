"""Controllers in Python, in lock-step: simulated seconds per second of CPU, engine and client."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import ClassVar

from benchmarks.godot.engine_time import engine_seconds
from roadlang import testing
from roadlang.api import Control, Controller, Observation, Speed, option
from roadlang.drive.controllers import python_controllers
from roadlang_godot.drive.simulate import Settings, drive_in
from roadlang_godot.engines import engine
from roadlang_godot.net.session import Session

SETTINGS, TURNS = Settings(duration=40.0, step=0.05), 3
ROAD = """
road main {
  draw with segments { pieces: [
    straight(150m), arc(60m, 80deg), straight(150m), arc(45m, -90deg), straight(250m)
  ] }
  width: 8m, lanes: 2
}
agent cars is car on main at 5m { count: %d, spacing: 9m, lane: -1, drive with %s }
"""
DRIVES = ("follower { speed: 9m/s }", "traffic { speed: 9m/s }", "pure_pursuit { speed: 9m/s }")


@dataclass(frozen=True)
class Follower(Controller):
    """Drives along its lane toward a point ahead, as a first controller of one's own does."""

    name: ClassVar[str] = "follower"
    speed: Speed = option(9.0, help="kept")

    def control(self, observation: Observation) -> Control:
        """Toward the point 8 m ahead on the line."""
        x, y, *_ = observation.line_ahead(8.0)
        across, along = y - observation.y, x - observation.x
        angle = math.atan2(across, along) - observation.heading
        bend = 2.0 * math.sin(angle) / max(math.hypot(along, across), 1.0)
        pull = 1.5 * (self.speed - observation.speed)
        return Control(math.atan(observation.wheelbase * bend), pull)


def lockstep() -> None:
    """A controller of one's own, and shipped ones that Python decides for; 1 and 10 agents."""
    for drive in DRIVES:
        for count in (1, 10):
            rates, shares = [], []
            with (
                engine.start(fixed_fps=SETTINGS.frame_rate) as running,
                running.connect() as session,
            ):
                for _ in range(TURNS):
                    rate, share = _rate(session, running, ROAD % (count, drive))
                    rates.append(rate)
                    shares.append(share)
            best = max(range(TURNS), key=rates.__getitem__)
            name = drive.split()[0]
            print(
                f"lock-step at {1000 * SETTINGS.step:.0f} ms, {name}, {count} agents: "
                f"{rates[best]:.1f} simulated s per CPU s "
                f"({100 * shares[best]:.0f} % of it in the engine)"
            )


def _rate(session: Session, running: engine.Engine, text: str) -> tuple[float, float]:
    """Simulated seconds per CPU second of one drive; the engine's share of them."""
    scenario = testing.scenario(text, kinds=[Follower])
    scene = scenario.sample(1, seed=0)[0].record
    controllers = python_controllers(scene, testing.registry_with(Follower))
    of_client, of_engine = time.process_time(), engine_seconds(running)
    trace = drive_in(session, scene, SETTINGS, controllers)
    of_client, of_engine = time.process_time() - of_client, engine_seconds(running) - of_engine
    seconds = of_client + of_engine
    return float(trace.time[-1]) / seconds, of_engine / seconds
