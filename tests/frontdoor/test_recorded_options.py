"""Options in a scene file that was edited by hand are checked as those of a scenario are."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from roadlang import DiagnosticError, Scene, testing
from roadlang.cli.main import main

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (160m, 0m)] }, width: 7m, lanes: 2 }
agent ego is car on main at 5m {
  sense with gps { noise: 0.5m }
  drive with lane_follow { speed: 5m/s }
  drive with brake { when: ego.station > 30m, while: ego.speed > 1m/s }
}
agent others is car on main at 50m {
  count: 2, spacing: 10m, drive with car_follow { speed: 5m/s }
}
object tree is tree on main at 90m { side: left, offset: 2m }
expect apart: always (gap(ego, others) > 1m)
simulate with builtin { duration: 2s }
"""
FOLLOW = ("agents", 0, "drive", 0, "options")
WHEN = ("agents", 0, "drive", 1, "when", "signals", "ego.station")
STATION = 'agents[0].drive[1].when.signals["ego.station"]'
EDITS: dict[str, tuple[tuple[Any, ...], Any, str]] = {
    "a very long car": (("agents", 0, "length"), 1e9, "agents[0].length"),
    "a car inside out": (("agents", 0, "width"), -1.8, "agents[0].width"),
    "a mass of nothing": (("agents", 0, "options", "mass"), 0.0, "agents[0].options.mass"),
    "a wheelbase in words": (
        ("agents", 0, "options", "wheelbase"),
        "long",
        "agents[0].options.wheelbase",
    ),
    "a flat tree": (("objects", 0, "height"), 0.0, "objects[0].height"),
    "a word for a number": ((*FOLLOW, "speed"), "fast", "agents[0].drive[0].options.speed"),
    "a list for a number": ((*FOLLOW, "speed"), [1, "a"], "agents[0].drive[0].options.speed"),
    "a number out of bounds": ((*FOLLOW, "speed"), -1.0, "agents[0].drive[0].options.speed"),
    "of a sensor": (
        ("agents", 0, "sensors", 0, "options", "noise"),
        True,
        "agents[0].sensors[0].options.noise",
    ),
    "of every sensor": (
        ("agents", 0, "sensors", 0, "options", "delay"),
        {"q": 1},
        "agents[0].sensors[0].options.delay",
    ),
    "of the simulator": (("simulate", "options", "duration"), "2s", "simulate.options.duration"),
    "of a signal": ((*WHEN, "options", "of"), 7, f"{STATION}.options.of"),
    "an agent that is not there": ((*WHEN, "options", "agent"), "eg", f"{STATION}.options.agent"),
    "null for an agent": ((*WHEN, "options", "agent"), None, f"{STATION}.options"),
    "no agent": ((*WHEN, "options"), {}, f"{STATION}.options"),
}


@pytest.fixture(scope="module")
def written() -> str:
    (scene,) = testing.sample(TEXT)
    return scene.to_json()


def edited(written: str, way: tuple[Any, ...], value: Any) -> str:
    document = json.loads(written)
    inner = document
    for step in way[:-1]:
        inner = inner[step]
    inner[way[-1]] = value
    return json.dumps(document)


@pytest.mark.parametrize("edit", EDITS)
def test_the_place_of_the_option_is_named(written: str, edit: str) -> None:
    way, value, place = EDITS[edit]
    with pytest.raises(DiagnosticError) as caught:
        Scene.from_json(edited(written, way, value), "edited.json")
    (found,) = caught.value.diagnostics
    assert (found.code, found.path) == ("RL461", "edited.json")
    assert found.message.endswith(f" - at `$.{place}`")


def test_options_as_they_were_written_are_read(written: str) -> None:
    assert Scene.from_json(written).to_json() == written


@pytest.mark.parametrize("name", ["speed", "from_a_later_version"])
def test_integers_and_options_of_other_versions_are_read(written: str, name: str) -> None:
    Scene.from_json(edited(written, (*FOLLOW, name), 4))


def test_a_kind_that_is_not_installed_is_reported_where_it_is_used(written: str) -> None:
    Scene.from_json(edited(written, ("agents", 0, "drive", 0, "kind"), "acme.follow"))


def test_the_command_names_the_place_and_writes_nothing(
    written: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "edited.json"
    file.write_text(edited(written, (*FOLLOW, "speed"), "fast"), encoding="utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["run", str(file), "-o", str(tmp_path / "out")])
    assert ended.value.code == 1
    shown = capsys.readouterr().err
    assert "error[RL461]" in shown
    assert "RL470" not in shown
    assert not (tmp_path / "out").exists()
