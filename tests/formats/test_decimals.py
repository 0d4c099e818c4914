"""Numbers as text: no minus before what is zero, bearings below a full turn, times that differ."""

from __future__ import annotations

import math
from xml.etree.ElementTree import fromstring

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang import testing
from roadlang_formats.decimals import bearing, decimals
from roadlang_formats.emit_sumo import SumoBackend

ROAD = """road main { draw with segments { pieces: [straight(100m)] } }
agent ego is car on main at 5m { drive with lane_follow { speed: 10m/s } }
simulate with builtin { duration: 60ms, step: 5ms, control_step: 5ms, vehicle_step: 5ms }
"""


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [(-1e-17, 3, "0.000"), (-0.0, 2, "0.00"), (-0.0006, 3, "-0.001"), (12.34567, 3, "12.346")],
)
def test_what_is_zero_has_no_minus(value: float, digits: int, text: str) -> None:
    assert decimals(value, digits) == text


@pytest.mark.parametrize(
    ("heading", "degrees"),
    [(0.0, 90.0), (math.pi / 2, 0.0), (math.pi / 2 + 1e-12, 0.0), (-math.pi, 270.0)],
)
def test_north_is_zero_and_never_a_full_turn(heading: float, degrees: float) -> None:
    assert bearing(heading, 6) == degrees


@given(st.floats(-20.0, 20.0))
def test_a_bearing_is_within_a_turn_and_clockwise_from_north(heading: float) -> None:
    found = bearing(heading, 3)
    assert 0.0 <= found < 360.0
    assert math.sin(math.radians(found)) == pytest.approx(math.cos(heading), abs=1e-4)


def test_the_moments_of_a_drive_in_short_steps_differ() -> None:
    (scene,) = testing.sample(ROAD)
    drive = scene.run()
    moments = fromstring(SumoBackend().drive_files(scene.record, drive.trace)["fcd.xml"])
    times = [moment.attrib["time"] for moment in moments]
    assert times[:4] == ["0.00", "0.005", "0.01", "0.015"]
    assert [float(time) for time in times] == pytest.approx(drive.trace.time.tolist(), abs=1e-6)
