"""The standard controllers decide in Godot as they do in Python: one table of cases for both.

The engine's own tests run the same table (`godot_backend/tests/test_controllers.gd`). It is written
by `python tests/godot/test_controller_cases.py`; a case without options tests the defaults.
"""

from __future__ import annotations

import json
import math
import sys
from typing import Any

import numpy as np
import pytest

from roadlang.drive.controllers import python_controllers
from roadlang.ir.scene import Call, Provenance, Scene, SceneActor, SceneRoad
from roadlang.plugins.discovery import load_registry
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.calling.controllers import Driver
from roadlang.simulation.observing.observing import View
from roadlang.simulation.observing.surroundings import Surroundings
from roadlang.simulation.surroundings.leaders import Leaders
from roadlang_godot.engines import engine

TABLE = engine.project() / "tests" / "controller_cases.json"
CALLS: tuple[tuple[str, dict[str, float]], ...] = (
    ("lane_follow", {}),
    ("lane_follow", {"speed": 20.0, "acceleration": 1.0, "lateral_acceleration": 2.0}),
    ("pure_pursuit", {}),
    ("pure_pursuit", {"speed": 9.0, "lookahead": 4.0, "lookahead_time": 0.5}),
    ("pure_pursuit", {"speed": 25.0, "deceleration": 3.0, "lateral_acceleration": 6.0}),
    ("stanley", {}),
    ("stanley", {"speed": 30.0, "gain": 1.5, "softening": 2.0}),
    ("car_follow", {}),
    ("car_follow", {"speed": 12.0, "headway": 1.0, "gap": 4.0, "deceleration": 3.0}),
    ("brake", {}),
    ("brake", {"speed": 5.0, "deceleration": 4.0}),
)
STATES = (
    # station, left of the line, turned from it, speed, gap to the vehicle ahead, its speed
    (10.5, 0.0, 0.0, 0.0, math.inf, 0.0),
    (35.5, 1.0, 0.1, 12.0, 20.0, 8.0),
    (55.5, -0.7, -0.2, 16.0, 6.0, 16.0),
    (80.5, 0.2, 0.05, 9.0, math.inf, 0.0),
    (100.5, 0.0, 0.0, 20.0, 50.0, 0.0),
)


def place(s: float) -> tuple[float, float, float]:
    """Straight for 60 m, then a left bend of 25 m: x, y and heading."""
    angle = max(0.0, s - 60.0) / 25.0
    return min(s, 60.0) + 25 * math.sin(angle), 25 - 25 * math.cos(angle), angle


def path() -> list[tuple[float, float, float]]:
    """The places at each meter."""
    return [place(float(s)) for s in range(121)]


def scene(kind: str, options: dict[str, float], state: tuple[float, ...]) -> Scene:
    """One car in a state, driven by one controller."""
    station, left, turned, *_ = state
    x, y, heading = place(station)
    xs, ys, headings = zip(*path(), strict=True)
    stations = tuple(float(i) for i in range(len(path())))
    road = SceneRoad(
        "main", stations, stations, xs, ys, headings, tuple(0.0 for _ in stations),
        tuple(8.0 for _ in stations), 1, False, stations[-1], "main",
    )  # fmt: skip
    actor = SceneActor(
        "ego", "ego", "car",
        x - math.sin(heading) * left, y + math.cos(heading) * left, heading + turned,
        4.5, 1.8, 1.5, "main", station, 0.0, None, "forward",
        {"wheelbase": 2.7, "max_steering": 1.2}, (Call(kind, options),),
    )  # fmt: skip
    return Scene("case", "", 0, Provenance("0", 0, 0, 0), roads=(road,), agents=(actor,))


def decided(kind: str, options: dict[str, float], state: tuple[float, ...]) -> list[float | None]:
    """Steering angle (None: left to another) and acceleration, as Python has them."""
    one = scene(kind, options, state)
    world = world_of([one], {}, 0.02, 0.1)
    world.motion.speed[:] = state[3]
    view = View(world, world.poses, 0.1, Surroundings(world))
    gap, speed = np.array([state[4]]), np.array([state[5]])
    none = np.zeros((1, 1, 1))
    view._ahead = Leaders(gap, speed, np.zeros(1), lambda: none, lambda: none)
    driver = python_controllers(one, load_registry())["ego"]
    assert isinstance(driver, Driver)
    guarded = driver.each[0]
    assert guarded is not None
    controller = guarded.built(guarded.options)
    found = guarded.decide(controller, view.of(np.array([0])), None)
    steering = float(found.steering[0])
    return [None if math.isnan(steering) else steering, float(found.acceleration[0])]


ASKED = [(kind, options, state) for kind, options in CALLS for state in STATES]


def case(kind: str, options: dict[str, float], state: tuple[float, ...]) -> dict[str, Any]:
    """A row of the table as Python decides it now."""
    actor = scene(kind, options, state).agents[0]
    return {
        "kind": kind,
        "options": options,
        "state": [None if math.isinf(value) else value for value in state],
        "pose": [actor.x, actor.y, actor.heading],
        "control": decided(kind, options, state),
    }


def table() -> dict[str, Any]:
    """The whole file."""
    return {"path": path(), "cases": [case(*asked) for asked in ASKED]}


@pytest.mark.parametrize(
    ("asked", "expected"), list(zip(ASKED, json.loads(TABLE.read_text())["cases"], strict=True))
)
def test_python_agrees_with_the_table(asked: Any, expected: dict[str, Any]) -> None:
    found = case(*asked)
    assert found["kind"] == expected["kind"]
    assert found["state"] == expected["state"]
    for value, known in zip(found["control"], expected["control"], strict=True):
        assert value == (known if known is None else pytest.approx(known, abs=1e-6))


def test_the_table_has_every_controller_of_the_engine_that_steers_a_car() -> None:
    assert {kind for kind, _ in CALLS} >= {
        "lane_follow", "pure_pursuit", "stanley", "car_follow", "brake"
    }  # fmt: skip


if __name__ == "__main__":
    TABLE.write_text(json.dumps(table(), indent=1) + "\n", encoding="utf-8")
    sys.exit(0)
