"""The examples of maneuvers do what they are for; their expectations fail where it goes wrong."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import roadlang

EXAMPLES = Path(__file__).parents[2] / "examples"


def kept(
    name: str, folder: Path, count: int, control_step: float = 0.04, **changes: str
) -> list[bool]:
    """Whether all expectations hold, in `count` scenes of an example in which texts are changed."""
    text = (EXAMPLES / f"{name}.rl").read_text(encoding="utf-8")
    for old, new in changes.items():
        old = old.replace("__", " ")
        assert old in text
        text = text.replace(old, new)
    for picture in EXAMPLES.glob("*.png"):
        shutil.copy(picture, folder)
    (folder / f"{name}.rl").write_text(text, encoding="utf-8")
    scenes = roadlang.load(folder / f"{name}.rl").sample(count)
    return [one.satisfied for one in scenes.run("builtin", control_step=control_step)]


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        "cut_in",
        "overtaking",
        "platoon",
        "parked_row",
        "signals",
        "roundabout",
        "on_ramp",
        "emergency_brake",
        "zebra_crossing",
    ],
)
def test_an_example_keeps_its_expectations(name: str, tmp_path: Path) -> None:
    assert all(kept(name, tmp_path, 3))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("cut_in", {"drive__with__car_follow__{__speed:__80km/h__}": "drive with lane_follow"}),
        ("cut_in", {"gap:__6m..14m": "gap: 60m"}),
        ("overtaking", {"target:__truck,": "target: oncoming,"}),
        ("platoon", {"speed:__85km/h": "speed: 45km/h"}),
        ("roundabout", {"drive__with__traffic__}": "drive with pure_pursuit { speed: 18m/s } }"}),
        ("on_ramp", {"drive__with__merge__{__to:__left,__within:__160m__}": ""}),
        ("on_ramp", {"drive__with__merge": "drive with change_lane { to: left, force: true }#"}),
        ("emergency_brake", {"delay:__80ms": "delay: 800ms"}),
        ("parked_row", {"deceleration:__6m/s^2": "deceleration: 1m/s^2"}),
        (
            "zebra_crossing",
            {"street__at__20m__{__drive__with__traffic": "street at 20m { drive with lane_follow"},
        ),
    ],
)
def test_its_expectations_fail_where_it_goes_wrong(
    name: str, changes: dict[str, str], tmp_path: Path
) -> None:
    assert not all(kept(name, tmp_path, 3, 0.1, **changes))
