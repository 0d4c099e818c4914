"""`walk` along the road, and `replay` of what was recorded: exactly."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roadlang import testing
from roadlang.diagnostics import DiagnosticError
from roadlang.drive.trace_files import to_csv, to_json

from .driven_roads import drive

STREET = """
road main {
  draw with segments { pieces: [PIECES] }
  left:  [drive(3m), sidewalk(2m)]
  right: [drive(3m), parking(2m), sidewalk(2m)]
}
"""
STRAIGHT = STREET.replace("PIECES", "straight(200m)")
# From the middle of the two lanes: the right sidewalk lies 6 m right, the left one 4 m left.


def walker(options: str, place: str) -> str:
    return f"agent ego is pedestrian on main at 40m {{ {place}\n drive with walk {{ {options} }} }}"


@pytest.mark.parametrize(
    ("options", "place", "y"),
    [
        ("", "side: right, offset: 0.5m", -6.0),
        ("", "side: left, offset: 0.5m", 4.0),
        ("along: edge, beyond: 0.3m", "side: left, offset: 0m", 3.3),
        ("along: edge", "offset: -4m", -3.5),
    ],
)
def test_who_walks_goes_to_the_sidewalk_or_the_edge_and_along_it(
    options: str, place: str, y: float
) -> None:
    (trace,) = drive(STRAIGHT + walker(options, place), duration=20)
    ego = trace.agents["ego"]
    assert ego.y[-1] == pytest.approx(y, abs=0.05)
    assert ego.speed[1:] == pytest.approx(np.full(len(ego.speed) - 1, 1.4))
    assert ego.x[-1] - ego.x[0] == pytest.approx(28.0, abs=1.5)


def test_who_faces_back_walks_back() -> None:
    text = STRAIGHT + walker("speed: 2m/s", "side: right, offset: 0.5m, facing: back")
    ego = drive(text, duration=10)[0].agents["ego"]
    assert ego.x[-1] - ego.x[0] == pytest.approx(-20.0, abs=1.5)
    assert ego.y[-1] == pytest.approx(-6.0, abs=0.05)


def test_round_a_bend_it_stays_on_the_sidewalk() -> None:
    bend = STREET.replace("PIECES", "straight(50m), arc(30m, 90deg), straight(30m)")
    ego = drive(bend + walker("", "side: right, offset: 0.5m"), duration=40)[0].agents["ego"]
    assert np.abs(ego.cross_track_error[ego.time > 8]).max() < 0.1


def test_who_walks_can_stop_and_go_on() -> None:
    text = (
        STRAIGHT
        + """
    agent ego is pedestrian on main at 40m {
      side: right, offset: 0.5m
      drive with brake
      drive with walk { when: time > 2s, while: time < 6s }
    }
    """
    )
    ego = drive(text, duration=10)[0].agents["ego"]
    assert np.ptp(ego.x[ego.time <= 2]) == 0.0
    assert ego.x[-1] - ego.x[0] == pytest.approx(4 * 1.4, abs=0.6)


def recorded(file: str, more: str = "") -> str:
    return (
        STRAIGHT
        + f"""
    agent ego is car on main at 20m {{ lane: none, drive with replay {{ file: "{file}" {more} }} }}
    """
    )


def test_a_table_is_replayed_exactly_with_straight_lines_between(tmp_path: Path) -> None:
    rows = [(0.0, 20.0, 0.0, 0.0), (2.0, 40.0, 0.0, 0.0), (4.0, 50.0, 3.0, 0.4)]
    text = "\n".join(",".join(map(str, row)) for row in rows)
    (tmp_path / "a.csv").write_text("time,x,y,heading\n" + text, encoding="utf-8")
    ego = drive(recorded(str(tmp_path / "a.csv")), duration=6)[0].agents["ego"]
    for column, place in ((ego.x, 1), (ego.y, 2), (ego.heading, 3)):
        known = np.interp(ego.time, [row[0] for row in rows], [row[place] for row in rows])
        assert column == pytest.approx(known, abs=1e-9)
    assert ego.speed[ego.time > 4.0] == pytest.approx(0.0)
    assert ego.station == pytest.approx(ego.x, abs=1e-6)


@pytest.mark.parametrize(
    "text",
    [
        "time;x;y;heading\n0;20,0;0;0\n2;40,0;0;0\n",
        "time\tx\ty\theading\n0\t20\t0\t0\n2\t40\t0\t0\n",
        "\ufefftime,x,y,heading\r0,20,0,0\r2,40,0,0\r",
    ],
)
def test_tables_of_spreadsheets_are_replayed_too(text: str, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_bytes(text.encode())
    ego = drive(recorded(str(tmp_path / "a.csv")), duration=1)[0].agents["ego"]
    assert ego.x[-1] == pytest.approx(30.0)


@pytest.mark.parametrize("kind", ["csv", "json"])
def test_a_drive_of_ours_is_replayed_as_it_was(kind: str, tmp_path: Path) -> None:
    text = (
        STREET.replace("PIECES", "straight(40m), arc(60m, 70deg), straight(80m)")
        + """
    agent ego is car on main at 5m { start_speed: 10m/s, drive with pure_pursuit { speed: 12m/s } }
    """
    )
    (first,) = drive(text, duration=10, step=0.04, control_step=0.04)
    file = tmp_path / f"trace.{kind}"
    file.write_text({"csv": to_csv, "json": to_json}[kind](first), encoding="utf-8")
    again = text.replace("pure_pursuit { speed: 12m/s }", f'replay {{ file: "{file}" }}')
    (second,) = drive(again, duration=10, step=0.04, control_step=0.04)
    for column in ("x", "y", "heading", "speed", "station", "cross_track_error"):
        one, other = (getattr(trace.agents["ego"], column) for trace in (first, second))
        assert other == pytest.approx(one, abs=1e-5 if column != "cross_track_error" else 1e-3)


def test_a_recording_begins_when_its_condition_comes_true(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_text("time,x,y,heading,speed\n5,20,0,0,7\n15,120,0,0,7\n", encoding="utf-8")
    text = recorded(str(file), ", when: time >= 2s").replace(
        "drive with replay", "drive with brake\n drive with replay"
    )
    ego = drive(text, duration=8)[0].agents["ego"]
    assert ego.x[ego.time <= 2.0].max() == 20.0
    assert ego.x[-1] == pytest.approx(20.0 + 60.0, abs=0.5)
    assert ego.speed[-1] == 7.0  # as the file says


def test_who_is_replayed_can_be_hit_and_then_stands(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_text("time,x,y,heading\n0,20,0,0\n10,120,0,0\n", encoding="utf-8")
    other = "agent other is car on main at 60m { lane: none, drive with brake }"
    (trace,) = drive(recorded(str(file)) + other, duration=10)
    assert [event["agent"] for event in trace.events] == ["ego", "other"]
    assert trace.agents["ego"].x[-1] == pytest.approx(55.5, abs=0.01)


LONG = '"' + "1" * 200_000 + '"'


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("time,x,y\n0,0,0\n1,1,1\n", "no column `heading`"),
        ("time,x,y,heading\n0,0,0,0\n0,1,1,0\n", "times do not increase"),
        ("time,x,y,heading\n0,0,0,0\n1,a,1,0\n", "not all of its values are numbers"),
        ("time,agent,x,y,heading\n0,eg,0,0,0\n1,eg,1,1,0\n", "it has no agent `ego`"),
        ("time,x,y,heading\n0,0,0,0\n1,1_000,1,0\n", "`x` is `1_000` in row 2"),
        ("time,x,y,heading\n0,0,0,0\n1,inf,1,0\n", "`x` is `inf` in row 2"),
        ("time,x,y,heading\n0,0,0,0\n1,,1,0\n", "numbers: `x` is empty in row 2"),
        ("time,x,y,heading\n0,0,0,0\n1,5,0\n", "row 2 has 3 columns, not 4"),
        ("{", "it is not the trace of a drive"),
        pytest.param('{"a":' * 20_000, "it is not the trace of a drive", id="deeply nested"),
        ("time,x\n", "no column `time`"),
        pytest.param(LONG + "\n", "field larger than field limit", id="long word"),
        ("time,steering,acceleration\n", "it has no rows"),
        ("time,steering,acceleration\n0,0,nan\n", "not all of its values are numbers"),
        ("time,steering,acceleration\n0,0,1\n0,0,1\n", "its times do not increase"),
        pytest.param(
            f"time,steering,acceleration\n{LONG},0,0\n", "field larger than", id="long number"
        ),
    ],
)
def test_a_file_that_is_no_recording_is_refused_by_name(
    text: str, says: str, tmp_path: Path
) -> None:
    (tmp_path / "a.csv").write_text(text, encoding="utf-8")
    scenes = testing.sample(recorded(str(tmp_path / "a.csv")))
    with pytest.raises(DiagnosticError) as fault:
        list(scenes.run("builtin"))
    assert fault.value.diagnostics[0].code == "RL477"
    assert says in str(fault.value)


def test_recorded_inputs_may_have_empty_lines_and_quoted_names(tmp_path: Path) -> None:
    file = tmp_path / "inputs.csv"
    file.write_bytes(b'"time","steering","acceleration"\r\n0,0,1\r\n\r\n9,0,1\r\n\r\n')
    (trace,) = drive(recorded(str(file)), duration=2)
    assert trace.agents["ego"].acceleration[-1] == pytest.approx(1.0 - 0.012 * 9.81, abs=0.01)
