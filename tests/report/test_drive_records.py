"""What the viewer of the page is given of a drive."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

import roadlang
from roadlang.report.drive_records import DriveView, drive_record, view
from roadlang.report.results import ShownDrive
from roadlang.session.scene import installed

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (60m, 0m)] } }
agent ego is car on main at 10m { start_speed: 10m/s, drive with pure_pursuit { speed: 10m/s } }
object box is barrier on main at 50m { offset: 5m }
expect moves: always (ego.speed > 1m/s)
expect is_slow: always (ego.speed < 8m/s)
expect is_near: always (ego.x < 32m)
"""


@cache
def driven() -> tuple[DriveView, Any]:
    scene = roadlang.loads(TEXT).sample(1, seed=0)[0]
    drive = scene.run(duration=3.0)
    verdicts = tuple(drive.verdicts.values())
    shown = ShownDrive("one", "1", 4, scene.record, drive.trace, verdicts, True)
    seen = view(shown, installed())
    return seen, drive_record(seen, {}, 20)


def test_the_worst_expectation_is_the_one_that_is_violated_most() -> None:
    seen, record = driven()
    assert [judged.verdict.satisfied for judged in seen.judged] == [True, False, False]
    assert record["worst"] == "is_near"
    assert seen.worst is not None
    assert seen.worst.verdict.robustness == pytest.approx(-8.0, abs=0.5)


def test_robustness_is_in_the_units_of_the_rest_of_the_page() -> None:
    text = TEXT.replace("ego.x < 32m", "ego.heading < 10deg")
    text = text.replace("ego.speed < 8m/s", "abs(ego.acceleration) < 2m/s^2")
    drive = roadlang.loads(text).sample(1, seed=0)[0].run(duration=1.0)
    verdicts = tuple(drive.verdicts.values())
    shown = ShownDrive("one", "1", 4, drive.scene.record, drive.trace, verdicts, True)
    _, force, near = drive_record(view(shown, installed()), {}, 20)["verdicts"]
    assert force["unit"] == "m/s\N{SUPERSCRIPT TWO}"
    assert (near["unit"], near["robustness"]) == ("deg", pytest.approx(10.0, abs=0.5))
    assert min(near["series"]) == pytest.approx(near["robustness"], abs=0.01)


def test_the_moment_is_that_of_the_first_violation() -> None:
    _, record = driven()
    time, x = np.cumsum(record["time"]) / 1000, np.cumsum(record["agents"][0]["x"]) / 100
    at = record["moment"]
    assert x[at - 1] < 32.0 <= x[at] < 33.1
    assert record["place"].startswith(f"{time[at]:.1f}\N{NO-BREAK SPACE}s, s")


def test_numbers_are_those_of_the_trace_rounded() -> None:
    seen, record = driven()
    trace = seen.drive.trace
    time = np.cumsum(record["time"]) / 1000
    assert time[0] == 0.0
    assert time[-1] == pytest.approx(trace.time[-1], abs=1e-3)
    ego = trace.agents["ego"]
    for name, values, unit in (
        ("speed", ego.speed, 100), ("station", ego.station, 100), ("x", ego.x, 100),
        ("y", ego.y, 100), ("heading", ego.heading, 1000),
    ):  # fmt: skip
        found = record if name in record else record["agents"][0]
        expected = np.interp(time, trace.time, values)
        np.testing.assert_allclose(np.cumsum(found[name]) / unit, expected, atol=0.02)
    turned = 0.5 + 3.0 * trace.time  # beyond a half turn, where a heading begins anew
    turning = replace(ego, heading=np.arctan2(np.sin(turned), np.cos(turned)))
    other = replace(seen.drive, trace=replace(trace, agents={"ego": turning}))
    found = drive_record(view(other, installed()), {}, 20)["agents"][0]
    expected = np.interp(time, trace.time, turned)
    np.testing.assert_allclose(np.cumsum(found["heading"]) / 1000, expected, atol=0.02)
    assert record["agents"][0]["size"] == [ego.length, ego.width]
    assert record["agents"][0]["until"] == len(time)
    assert [(o[:2], o[2:4]) for o in record["objects"]] == [(["box", "barrier"], [50.0, 5.0])]
    assert [agent["name"] for agent in record["agents"]] == ["ego"]


def test_the_color_of_the_path_is_the_sign_of_the_worst_expectation() -> None:
    seen, record = driven()
    (series,) = [v["series"] for v in record["verdicts"] if v["name"] == record["worst"]]
    for shade, value in zip(record["shades"], series, strict=True):
        assert (shade > 8) == (value > 0.5) or abs(value) < 1.0
        assert 0 <= shade <= 16
    assert record["shades"][0] > 8 > record["shades"][-1]
    assert [v["robustness"] for v in record["verdicts"]] == [
        j.verdict.robustness for j in seen.judged
    ]


def test_an_agent_is_shown_until_it_leaves() -> None:
    seen, _ = driven()
    trace = seen.drive.trace
    ego = trace.agents["ego"]
    for last in (0.5, 1.7):
        gone = replace(ego, present=(trace.time <= last).astype(float))
        other = replace(seen.drive, trace=replace(trace, agents={"ego": gone}))
        record = drive_record(view(other, installed()), {}, 20)
        time = np.cumsum(record["time"]) / 1000
        assert record["agents"][0]["until"] == (time <= last + 1e-3).sum() < len(time)


def test_an_agent_on_several_roads_is_plotted_over_what_it_drove() -> None:
    """Where a road begins, its arc length does too."""
    seen, record = driven()
    assert record["driven"] == []
    trace = seen.drive.trace
    ego = trace.agents["ego"]
    far = np.linspace(0.0, 40.0, len(trace.time))
    roads = np.where(far < 15.0, 0.0, np.where(far < 20.0, -1.0, 1.0))
    turned = replace(ego, road=roads, route_progress=far)
    other = replace(seen.drive, trace=replace(trace, agents={"ego": turned}))
    found = drive_record(view(other, installed()), {}, 20)
    time = np.cumsum(found["time"]) / 1000
    expected = np.interp(time, trace.time, far)
    np.testing.assert_allclose(np.cumsum(found["driven"]) / 100, expected, atol=0.02)
    unknown = replace(turned, route_progress=np.full(len(far), np.nan))
    other = replace(seen.drive, trace=replace(trace, agents={"ego": unknown}))
    assert drive_record(view(other, installed()), {}, 20)["driven"] == []
