"""Sensors: what they measure, when it arrives, and what controllers make of it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DiagnosticError, testing
from roadlang.api import (
    Control,
    Controller,
    Mirror,
    Observation,
)
from roadlang.drive.controllers import python_controllers
from roadlang.geometry.arrays import Floats
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.surroundings.ray_casts import RayCaster
from tests.simulation.sensed_drives import ROAD, SECONDS, agent, record, runs


def reference(origin: Floats, direction: Floats, boxes: list[Any]) -> float:
    """The distance along a ray to the first side of a footprint, by Cramer's rule for each side."""
    best = math.inf
    for box in boxes:
        c, s = math.cos(box.heading), math.sin(box.heading)
        corners = [
            (box.x + c * a - s * b, box.y + s * a + c * b)
            for a, b in (
                (box.length / 2, box.width / 2), (-box.length / 2, box.width / 2),
                (-box.length / 2, -box.width / 2), (box.length / 2, -box.width / 2),
            )
        ]  # fmt: skip
        for first, last in zip(corners, corners[1:] + corners[:1], strict=True):
            side = np.subtract(last, first)
            apart = np.subtract(first, origin)
            determinant = direction[0] * side[1] - direction[1] * side[0] or 1e-300
            along = (apart[0] * side[1] - apart[1] * side[0]) / determinant
            share = (apart[0] * direction[1] - apart[1] * direction[0]) / determinant
            if along >= 0.0 and 0.0 <= share <= 1.0:
                best = min(best, along)
    return best


def test_rays_end_at_the_first_side_of_a_footprint() -> None:
    text = (
        agent("")
        + """
    agent others is car on main at 12m..80m {
      count: 6, offset: -8m..8m, heading: 0deg..360deg, lane: none
    }
    object trees is tree on main at 0m..90m { count: 12, offset: -15m..15m }
    """
    )
    scenes = [scene.record for scene in testing.sample(text, 3)]
    world = world_of(scenes, {}, 0.02, 0.04)
    rows = np.array([0, 7, 14])
    angles = np.linspace(-3.0, 3.0, 41)
    rays = RayCaster(world).of(world, world.poses, rows)
    found = rays((1.0, 0.3, 0.4), angles, 0.0, 80.0)
    hits = 0
    for row, scene, distances in zip(rows, scenes, found, strict=True):
        ego, boxes = scene.agents[0], [*scene.agents[1:], *scene.objects]
        heading = world.poses.heading[row]
        axes = np.array([[math.cos(heading), -math.sin(heading)],
                         [math.sin(heading), math.cos(heading)]])  # fmt: skip
        origin = np.array([ego.x, ego.y]) + axes @ (1.0, 0.3)
        for angle, distance in zip(angles, distances, strict=True):
            direction = axes @ (math.cos(angle), math.sin(angle))
            expected = reference(origin, direction, boxes)
            assert distance == pytest.approx(expected if expected <= 80.0 else math.inf, abs=1e-9)
            hits += math.isfinite(distance)
    assert hits > 30


def test_rays_meet_the_ground_and_pass_over_what_is_low() -> None:
    text = agent(
        "sense with ranges { rays: 1, angle: 0deg, channels: 3, vertical_angle: 40deg, every: 1h\n"
        " at: (0m, 0m, 2m) }"
    )
    text += "object box is cone on main at 13m { lane: -1 }\n"
    distances = record(runs(text)[0], "ranges").arrays["distances"]
    assert distances.shape == (1, 3, 1)
    ground = 2.0 / math.sin(math.radians(20.0))
    assert distances[0, :, 0] == pytest.approx([ground, 60.0, 60.0])


@pytest.mark.parametrize(
    ("options", "times", "arrivals"),
    [
        ("", [0.0, 0.04, 0.08], [0.0, 0.04, 0.08]),
        ("every: 120ms", [0.0, 0.12, 0.24], [0.0, 0.12, 0.24]),
        ("delay: 80ms", [0.0, 0.04, 0.08], [0.0, 0.12, 0.16]),
        ("every: 120ms, delay: 200ms", [0.0, 0.12, 0.24], [0.0, 0.32, 0.44]),
        ("every: 20ms, delay: 10ms", [0.0, 0.04, 0.08], [0.0, 0.04, 0.08]),
    ],
)
def test_readings_are_measured_and_arrive_at_multiples_of_the_control_step(
    options: str, times: list[float], arrivals: list[float]
) -> None:
    (drive,) = runs(agent(f"sense with gps {{ noise: 0m, {options} }}"), step=0.04)
    found = record(drive, "gps")
    assert found.time[:3] == pytest.approx(times)
    assert found.arrival[:3] == pytest.approx(arrivals)
    rows = np.round(found.time / 0.04).astype(int)
    assert np.array_equal(found.arrays["x"], drive.trace.agents["ego"].x[rows])


SEEN: list[Observation] = []


@dataclass(frozen=True)
class Watching(Controller):
    """Keeps what it sees, and rolls on."""

    name: ClassVar[str] = "watching"

    def control(self, observation: Observation) -> Control:
        SEEN.append(observation)
        return Control(0.0, 0.0)


def test_the_last_reading_that_arrived_is_held() -> None:
    SEEN.clear()
    body = "drive with watching\n sense with gps { noise: 0m, every: 120ms, delay: 200ms }"
    runs(agent(body), kinds=(Watching,), step=0.04)
    times = [seen.sensors["gps"].time for seen in SEEN[:16]]
    assert times == pytest.approx([0.0] * 8 + [0.12] * 3 + [0.24] * 3 + [0.36] * 2)
    assert isinstance(SEEN[0].sensors["gps"].x, float)
    with pytest.raises(AttributeError, match="no array `z`; it has x, y"):
        _ = SEEN[0].sensors["gps"].z
    with pytest.raises(KeyError, match="no sensor `gbs`; the agent has gps"):
        _ = SEEN[0].sensors["gbs"]


def test_a_share_of_the_readings_is_lost() -> None:
    (drive,) = runs(agent("sense with gps { dropout: 30% }"), control_step=0.02, step=1.0)
    found = record(drive, "gps")
    assert found.time[0] == 0.0
    assert 0.6 < len(found.time) / (SECONDS / 0.02) < 0.8


def test_errors_have_the_deviations_that_are_asked_for() -> None:
    text = agent(
        "sense with gps { noise: 0.5m, bias: (2m, -1m) }\n"
        "sense with gps as walking { noise: 0m, walk: 0.3m }\n"
        "sense with imu { noise: 0.2m/s^2, yaw_noise: 1deg/s, bias: 0.5m/s^2 }"
    )
    drives = runs(text, 30, step=0.04)
    errors: dict[str, list[Any]] = {"gps": [], "walking": [], "imu": [], "north": []}
    for drive in drives:
        truth = drive.trace.agents["ego"]
        for name in ("gps", "walking"):
            errors[name].append(record(drive, name).arrays["x"] - truth.x[: int(SECONDS / 0.04)])
        north = record(drive, "gps").arrays["y"] - truth.y[: int(SECONDS / 0.04)]
        errors["north"].append(north)
        errors["imu"].append(record(drive, "imu").arrays["acceleration"] - truth.acceleration[:100])
    gps, walk, imu, north = (np.array(errors[name]) for name in errors)
    assert gps.mean() == pytest.approx(2.0, abs=0.05)
    assert north.mean() == pytest.approx(-1.0, abs=0.05)
    assert north.std() == pytest.approx(0.5, rel=0.05)
    assert abs(np.corrcoef(gps.ravel(), north.ravel())[0, 1]) < 0.05
    assert gps.std() == pytest.approx(0.5, rel=0.05)
    assert abs(np.corrcoef(gps[:, :-1].ravel(), gps[:, 1:].ravel())[0, 1]) < 0.05
    assert walk[:, 25].std() == pytest.approx(0.3, rel=0.4)
    assert walk[:, 99].std() == pytest.approx(0.3 * math.sqrt(3.96), rel=0.4)
    assert imu.std() == pytest.approx(0.2, rel=0.05)
    assert imu.mean() == pytest.approx(0.5, abs=0.02)


EVERYTHING = """
  sense with ranges { rays: 16, noise: 0.1m, lost_rays: 10%, every: 80ms }
  sense with gps { bias: (-2m..2m, 0m), walk: 0.1m, delay: 0ms..200ms }
  sense with imu { dropout: 20% }
  sense with noise { position: 0m..0.4m, heading: 1deg, speed: 0.3m/s, delay: 80ms }
"""


def test_a_scene_gives_the_same_readings_alone_and_among_others() -> None:
    text = agent(EVERYTHING) + "agent lead is car on main at 30m { drive with lane_follow }\n"
    text += "agent late is car on main at 12m { lane: 1, drive with watching\n sense with gps }\n"
    scenes = testing.sample(text, 2, kinds=(Watching,))
    together = list(scenes.run("builtin", duration=SECONDS))
    for scene, drive in zip(reversed(list(scenes)), reversed(together), strict=True):
        alone = scene.run("builtin", duration=SECONDS)
        assert alone.trace.agents["ego"].x.tobytes() == drive.trace.agents["ego"].x.tobytes()
        assert len(alone.readings) == len(drive.readings) == 5
        for one, other in zip(alone.readings, drive.readings, strict=True):
            assert one.time.tobytes() == other.time.tobytes()
            for name in one.arrays:
                assert one.arrays[name].tobytes() == other.arrays[name].tobytes()
    first, second = (record(drive, "imu").arrays["yaw_rate"] for drive in together[:2])
    assert not np.allclose(first[:20], second[:20])


def test_of_two_noises_the_last_one_counts_whoever_else_drives() -> None:
    text = (
        f"{ROAD}agent other is car on main at 60m {{ count: integer(0, 1)\n"
        "sense with noise as far }\n"
        + agent(
            "sense with noise as near { position: 0.5m }\n sense with noise as far"
        ).removeprefix(ROAD)
    )
    scenes = testing.sample(text, 3, seed=1)
    assert {len(scene.record.agents) for scene in scenes} == {1, 2}
    for scene, drive in zip(scenes, scenes.run("builtin", duration=SECONDS), strict=True):
        ego = drive.trace.agents["ego"]
        alone = scene.run("builtin", duration=SECONDS).trace.agents["ego"]
        assert ego.x.tobytes() == alone.x.tobytes()
        assert np.abs(ego.cross_track_error).max() < 0.05


def test_noise_is_what_controllers_see_and_nobody_else() -> None:
    SEEN.clear()
    body = "drive with watching\n sense with noise { position: 0.5m, speed: 1m/s, delay: 200ms }"
    (drive,) = runs(agent(body), kinds=(Watching,), step=0.04)
    truth = drive.trace.agents["ego"]
    assert np.allclose(truth.speed[:50], 10.0, atol=0.4)
    speeds = np.array([seen.speed for seen in SEEN])
    assert 0.7 < speeds.std() < 1.3
    late = np.array([seen.x for seen in SEEN])[6:] - truth.x[1 : len(SEEN) - 5]
    assert abs(late.mean()) < 0.2
    assert 0.35 < late.std() < 0.65


def test_a_vehicle_steers_by_the_noise() -> None:
    quiet, noisy = (
        runs(agent(f"sense with noise {{ position: {sigma} }}"))[0].trace.agents["ego"]
        for sigma in ("0m", "0.5m")
    )
    (plain,) = runs(agent(""))
    assert quiet.x.tobytes() == plain.trace.agents["ego"].x.tobytes()
    assert np.abs(quiet.cross_track_error).max() < 0.05
    assert np.abs(noisy.cross_track_error).max() > 0.05


def test_who_looks_for_a_sensor_hears_which_there_are() -> None:
    (none,) = testing.check(agent("drive with emergency_brake"))
    assert "is `ranges`, but `ego` has no sensor" in none.message
    assert none.help == ("add it to the agent: `sense with ranges`",)
    front = 'drive with emergency_brake { sensor: "front" }\n sense with gps'
    (other,) = testing.check(agent(front))
    assert "is `front`, but the sensors of `ego` are `gps`" in other.message
    assert other.help == ("add it to the agent: `sense with ... as front`",)
    assert not testing.check(agent(front.replace("gps", "ranges as front")))
    with pytest.raises(DiagnosticError, match=r"has several channels; it needs rays in one row"):
        runs(agent("drive with emergency_brake\n sense with ranges { channels: 2 }"))


def test_an_engine_delivers_what_is_due_and_nothing_else() -> None:
    camera = (
        "sense with camera as front { width: 32px, height: 16px, outputs: [depth], every: 100ms }"
    )
    scene = testing.sample(agent(camera))[0]
    mirror = Mirror(scene.record, python_controllers(scene.record, scene.registry), 0.05)
    seen = []
    for step in range(4):
        mirror.follow(np.array([[5.0, 0.0, 0.0, 10.0]]), np.zeros(1), passed=step > 0)
        due = mirror.due_readings()
        assert [(one.agent, one.sensor.name) for one in due] == [("ego", "front")] * (step % 2 == 0)
        for one in due:
            with pytest.raises(
                DiagnosticError, match=r"`depth` of shape \(32, 16\), not \(16, 32\)"
            ):
                mirror.deliver(one.agent, one.sensor.name, {"depth": np.zeros((32, 16))})
            mirror.deliver(one.agent, one.sensor.name, {"depth": np.full((16, 32), step)})
        mirror.decide()
        seen.append(mirror.seen("ego").sensors["front"].depth)
    assert [picture[3, 4] for picture in seen] == [0.0, 0.0, 2.0, 2.0]
    with pytest.raises(ValueError, match="read-only"):
        seen[0][3, 4] = 7.0
