"""In conditions of a group's own controllers, its name is the copy that drives."""

from __future__ import annotations

import pytest

from roadlang import testing

ROAD = "road main { draw with segments { pieces: [straight(200m)] }, lanes: 2 }\n"
LEAD = "agent lead is car on main at 150m\n"


def signals_of(options: str, counts: str = "2") -> list[list[dict[str, str]]]:
    """Of each copy in each of three scenes, what the options of its signals name."""
    text = (
        f"agent cars is car on main at 10m {{ count: {counts}, spacing: 20m,"
        f" drive with traffic, drive with brake {{ {options} }} }}\n"
    )
    scenes = testing.sample(ROAD + LEAD + text, 3)
    found = []
    for scene in scenes:
        for agent in (agent for agent in scene.record.agents if agent.group == "cars"):
            call = agent.drive[-1]
            signals = (call.when or call.during or {})["signals"].values()
            found.append([dict(signal["options"]) for signal in signals])
    return found


@pytest.mark.parametrize("word", ["when", "while"])
def test_each_copy_looks_at_itself(word: str) -> None:
    found = signals_of(f"{word}: cars.speed > 5m/s and gap(cars, lead) < 40m")
    own = [[{"agent": name}, {"first": name, "second": "lead"}] for name in ("cars[0]", "cars[1]")]
    assert found == own * 3


def test_copies_with_options_of_their_own_and_scenes_with_other_counts() -> None:
    found = signals_of("deceleration: 2m/s^2..4m/s^2, when: cars.speed > 5m/s", "integer(1, 3)")
    names = [options["agent"] for (options,) in found]
    assert {"cars[0]", "cars[1]"} <= set(names)
    assert all(
        name == f"cars[{number}]" for name, number in zip(names, _counted(names), strict=True)
    )


def _counted(names: list[str]) -> list[int]:
    """0, 1, ... from each first copy on."""
    counted: list[int] = []
    for name in names:
        counted.append(0 if name == "cars[0]" else counted[-1] + 1)
    return counted


def test_a_copy_that_is_named_stays() -> None:
    assert signals_of("when: cars[0].speed > 5m/s") == [[{"agent": "cars[0]"}]] * 6
    assert signals_of("when: lead.speed > 5m/s") == [[{"agent": "lead"}]] * 6
