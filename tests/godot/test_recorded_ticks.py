"""Records of several worlds, as one drive has them, are looked at tick by tick."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from roadlang_godot.drive.driving import GodotDrive
from roadlang_godot.drive.followed_scene import FollowedScene
from roadlang_godot.drive.simulate import _record
from roadlang_godot.net.telemetry import CONTACT, RECORD, Records


class Seen:
    """What is looked at: the tick, the agents, and the ticks of the contacts that came with it."""

    finished = False

    def __init__(self) -> None:
        self.ticks: list[tuple[int, list[int], list[int]]] = []

    def look_at_records(self, rows: Records, contacts: Records) -> None:
        tick = int(rows["tick"][0])
        self.ticks.append((tick, rows["agent"].tolist(), contacts["tick"].tolist()))


def records(dtype: Any, **columns: list[int]) -> Records:
    found = np.zeros(len(next(iter(columns.values()))), dtype)
    for name, values in columns.items():
        found[name] = values
    return found


def test_a_contact_belongs_to_the_first_record_that_is_not_before_it() -> None:
    """Ticks 0, 5, 10 are recorded of two worlds, each with two agents."""
    ticks, worlds = [0] * 4 + [5] * 4 + [10] * 4, [0, 0, 1, 1] * 3
    trace = records(RECORD, tick=ticks, world=worlds, agent=[0, 1] * 6)
    contacts = records(CONTACT, tick=[0, 3, 5, 5, 6, 10], world=[0, 0, 0, 1, 0, 0])
    drive = GodotDrive(trace, contacts, 10, "over")
    for world, expected in ((0, ([0], [3, 5], [6, 10])), (1, ([], [5], []))):
        seen = Seen()
        _record(drive, cast("FollowedScene", seen), 2, world)
        assert seen.ticks == [
            (tick, [0, 1], found) for tick, found in zip((0, 5, 10), expected, strict=True)
        ]
